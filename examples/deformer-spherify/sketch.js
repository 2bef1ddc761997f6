// Blends into a sphere around a center.
let teapot, spherify

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  teapot = await loadModel('teapot.obj')

  spherify = createWarp(
    warpjet.spherify({
      radius: 75,
      amount: ({ millis }) => millis.div(1200).sin().mult(0.45).add(0.4).max(0),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight('#fff0dd', -0.5, 0.8, -0.9)
  directionalLight('#4463d6', 0.8, -0.3, 0.2)

  rotateY(millis() / 5000)
  scale(1.8)
  fill('#43c6ac')
  specularMaterial(90)
  shininess(40)
  spherify()
  model(teapot)
}
