// Figure 4 of Pagurek's paper of 2024: the Stanford bunny at rest, twisted, and
// flattened into the plane of y and z.
let bunny, twist, flatten

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  bunny = await loadModel('bunny.obj')

  twist = createWarp(({ glsl, position, millis }) => {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const angle = y.mult(0.015).mult(millis.div(900).sin())
    const [sin, cos] = [angle.sin(), angle.cos()]
    const turnedX = x.mult(cos).sub(z.mult(sin))
    const turnedZ = x.mult(sin).add(z.mult(cos))
    return glsl.vec3(turnedX, y, turnedZ).sub(position)
  })

  flatten = createWarp(({ glsl, position, millis }) => {
    // Not entirely flat: otherwise front and back would have the same depth, and flicker.
    const amount = millis.div(900).sin().mult(1.5).add(0.5).clamp(0, 0.97)
    return glsl.vec3(position.x().mult(amount).neg(), 0, 0)
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(70)
  shininess(30)

  place(-200, '#8d93a8', () => resetShader())
  place(0, '#ff8a5b', () => twist())
  place(200, '#e9c46a', () => flatten())
}

function place(x, color, use) {
  push()
  translate(x, 0)
  rotateY(0.7)
  scale(0.94)
  use()
  fill(color)
  model(bunny)
  pop()
}
