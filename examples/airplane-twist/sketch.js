// Figure 1 of Pagurek's paper of 2024: an airplane, twisted along its fuselage,
// and lit as if it had been modelled that way.
let airplane, twist

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  airplane = await loadModel('airplane.obj')

  twist = createWarp(({ glsl, position, millis }) => {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const angle = millis.div(1200).sin().mult(x).mult(0.015)
    const [sin, cos] = [angle.sin(), angle.cos()]
    const turnedY = y.mult(cos).sub(z.mult(sin))
    const turnedZ = y.mult(sin).add(z.mult(cos))
    return glsl.vec3(x, turnedY, turnedZ).sub(position)
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.5)
  rotateY(0.6 + sin(millis() / 4000) / 2)
  scale(2.5)
  fill('#ff8a5b')
  specularMaterial(90)
  shininess(40)
  twist()
  model(airplane)
}
