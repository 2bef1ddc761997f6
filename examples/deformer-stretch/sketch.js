// The shape gets longer along an axis and thinner across it, so
// that its volume stays the same.
let bunny, stretch

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  bunny = await loadModel('bunny.obj')

  stretch = createWarp(
    warpjet.stretch({
      axis: 'y',
      center: [0, 100, 0],
      keepVolume: true,
      amount: ({ millis }) => millis.div(350).sin().mult(0.45),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  translate(0, 20)
  rotateY(0.5)
  scale(1.3)
  fill('#e9c46a')
  specularMaterial(70)
  shininess(30)
  stretch()
  model(bunny)
}
