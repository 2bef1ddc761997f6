// Rings travel away from a center and fade out at a radius.
let ripple

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  ripple = createWarp(
    warpjet.ripple({ axis: 'y', amount: 16, wavelength: 75, speed: 60, radius: 300 }),
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
  fill('#6fb7e9')
  specularMaterial(160)
  shininess(80)
  ripple()
  plane(400, 360, 160, 160)
}
