// The higher a point is, the further it moves sideways: upright
// letters become italic.
// Needs p5 2: p5 1.11 has no textToModel().
let word, shear

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  const font = await loadFont('fredoka.woff')
  textSize(172)
  textAlign(CENTER, CENTER)
  word = font.textToModel('lean', 0, -20, { extrude: 52, sampleFactor: 1 })
  // WEBGPU needs texture coordinates, which text models lack.
  word.uvs = word.vertices.flatMap(() => [0, 0])

  shear = createWarp(
    warpjet.shear({
      axis: 'y',
      direction: 'x',
      center: [0, 60, 0],
      amount: ({ millis }) => millis.div(700).sin().mult(0.7),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.3)
  rotateY(0.35)
  fill('#ffd98a')
  specularMaterial(90)
  shininess(40)
  shear()
  model(word)
}
