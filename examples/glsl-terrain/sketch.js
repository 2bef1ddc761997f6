// A plane displaced by a landscape in the style of Shadertoy, with rotated and
// shrinking octaves. The code contains no normals: warpjet computes them.
const { glslOffset } = warpjet

const land = `
  const mat2 turn = mat2(1.6, 1.2, -1.2, 1.6);

  float hills(vec2 p) {
    return sin(p.x) * cos(p.y);
  }

  float height(vec2 p) {
    float sum = 0.0, size = 1.0;
    vec2 slope = vec2(0.0);
    for (int i = 0; i < 6; i++) {
      float h = hills(p + slope);
      sum += size * h;
      slope += 0.35 * size * vec2(h, -h);
      p = turn * p;
      size *= 0.45;
    }
    return sum;
  }

  vec3 offset(vec3 position, float millis) {
    float h = height(position.xy * 4.0 + vec2(0.0, millis / 4000.0));
    return vec3(0.0, 0.0, 0.11 * h);
  }`

let terrain

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  terrain = createWarp(glslOffset(land))
}

function draw() {
  background('#151823')
  ambientLight(60)
  directionalLight(255, 227, 189, -0.8, 0.5, -0.5)
  directionalLight(53, 80, 140, 0.6, 0.2, -0.4)
  specularMaterial(40)
  shininess(20)

  translate(0, -30)
  rotateX(1.05)
  rotateZ(0.4)
  terrain()
  fill('#8a9a5b')
  scale(1, 1, 380)
  plane(380, 380, 220, 220)
}
