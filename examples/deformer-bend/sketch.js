// A straight bar follows an arc and continues straight beyond it.
// In world space a unit is a pixel.
let bend

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  bend = createWarp(
    warpjet.bend({
      axis: 'z',
      along: 'y',
      from: -90,
      to: 90,
      angle: ({ millis }) => millis.div(1300).sin().mult(2.6),
    }),
    { space: 'world' },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  fill('#a99cff')
  specularMaterial(90)
  shininess(40)
  bend()
  cylinder(34, 380, 48, 120)
}
