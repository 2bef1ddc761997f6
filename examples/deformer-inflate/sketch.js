// Points move along their normals. What the amount depends on counts: here it runs
// along the plane in waves.
let airplane, inflate

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  airplane = await loadModel('airplane.obj')

  inflate = createWarp(
    warpjet.inflate({
      amount: ({ position, millis }) =>
        position.x().div(16).sub(millis.div(300)).sin().mult(3.5).add(3),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight('#fff0dd', -0.5, 0.8, -0.9)
  directionalLight('#4463d6', 0.8, -0.3, 0.2)

  rotateX(-0.5)
  rotateY(0.6)
  scale(2.5)
  fill('#a99cff')
  specularMaterial(90)
  shininess(40)
  inflate()
  model(airplane)
}
