// Figure 7d of Pagurek's paper of 2024: extruded text that bulges under the mouse.
// With p5's default camera, world space equals screen space, except that the origin
// is in the middle.
// Needs p5 2: p5 1.11 has no textToModel().
let word, bulge

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  const font = await loadFont('fredoka.woff')
  textSize(195)
  textAlign(CENTER, CENTER)
  const detail = { extrude: 50, sampleFactor: 1 }
  word = font.textToModel('warp!', 0, -20, detail)
  // WEBGPU needs texture coordinates, which text models lack.
  word.uvs = word.vertices.flatMap(() => [0, 0])

  bulge = createWarp(
    ({ glsl, position, mouse, size, millis }) => {
      const away = position.xy().sub(mouse.sub(size.div(2)))
      const near = away.dot(away).div(-16000).exp()
      const wave = position.x().mult(0.01).add(millis.div(600)).sin().mult(14)
      return glsl.vec3(away.mult(near).mult(0.6), near.mult(90).add(wave))
    },
    { space: 'world' },
  )
}

function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.3)
  rotateY(sin(millis() / 3000) / 3)
  fill('#ffd98a')
  specularMaterial(90)
  shininess(40)
  bulge()
  model(word)
}
