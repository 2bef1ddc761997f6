// A plane wave travels along an axis and moves points to and fro:
// a flying carpet.
let wave

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  wave = createWarp(
    warpjet.wave({ axis: [1, 0, 0.4], direction: 'y', amount: 28, wavelength: 240, speed: 130 }),
    { space: 'world' },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(1.05)
  rotateZ(0.5)
  fill('#ff8a5b')
  specularMaterial(110)
  shininess(50)
  wave()
  plane(420, 280, 100, 80)
}
