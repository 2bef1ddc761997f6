// A widely used noise, unchanged from its package: the sketch reads the file, adds an
// offset function, and displaces a sphere with exact normals.
// Elsewhere, load the file from a CDN: cdn.jsdelivr.net/npm/glsl-noise/simplex/3d.glsl
const { glslOffset } = warpjet

let lumps

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  const noise = await loadStrings('../../node_modules/glsl-noise/simplex/3d.glsl')
  lumps = createWarp(
    glslOffset(`${noise.join('\n')}
      vec3 offset(vec3 position, float millis) {
        vec3 p = position * 1.7 + vec3(0.0, millis / 3000.0, 0.0);
        return position * (0.18 * snoise(p) + 0.06 * snoise(2.3 * p));
      }`),
  )
}

function draw() {
  background('#151823')
  ambientLight(60)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(120)
  shininess(30)

  rotateX(0.2)
  rotateY(millis() / 6000)
  lumps()
  fill('#d1495b')
  sphere(140, 120, 90)
}
