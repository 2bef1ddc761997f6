// A bunny sinks to the ground and spreads there.
let bunny, melt

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  bunny = await loadModel('bunny.obj')

  melt = createWarp(
    warpjet.melt({
      axis: 'y',
      ground: 100,
      height: 60,
      amount: ({ millis }) => millis.div(1400).sin().mult(0.42).add(0.42),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  translate(0, -30)
  rotateX(-0.35)
  rotateY(0.5)
  scale(1.1)
  fill('#ff8a5b')
  specularMaterial(140)
  shininess(60)
  melt()
  model(bunny)
}
