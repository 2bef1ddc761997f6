// A tube swells around a point that travels through it. Without an
// axis, all points near the center would move away from it.
let bulge

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  bulge = createWarp(
    warpjet.bulge({
      axis: 'x',
      center: ({ millis }) => [millis.div(3000).fract().sub(0.5).mult(800), 0, 0],
      radius: 110,
      amount: 1.4,
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

  rotateZ(HALF_PI)
  fill('#43c6ac')
  specularMaterial(90)
  shininess(40)
  bulge()
  cylinder(45, 520, 64, 160)
}
