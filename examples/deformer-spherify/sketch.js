// A box blends into a sphere around a center.
let spherify

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  camera(0, 0, 520)
  spherify = createWarp(
    warpjet.spherify({
      radius: 75,
      amount: ({ millis }) => millis.div(1200).sin().mult(0.45).add(0.4).max(0),
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

  rotateX(-0.5)
  rotateY(millis() / 5000)
  fill('#43c6ac')
  specularMaterial(90)
  shininess(40)
  spherify()
  warpBox(130, 130, 130, 40)
}
