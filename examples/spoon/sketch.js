// Figure 7b of Pagurek's paper of 2024: a spoon, bent by staring at it. The neck
// follows the arc of a circle, and beyond the arc the bowl continues straight.
let spoon, bend

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  spoon = await loadModel('spoon.obj')

  bend = createWarp(({ glsl, position, millis }) => {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const [from, length] = [-10, 50]
    const curvature = millis.div(1500).sin().mult(0.018).add(0.0185)
    const radius = glsl.val(1).div(curvature)

    const along = x.sub(from).clamp(0, length)
    const beyond = x.sub(from).sub(along)
    const angle = along.div(radius)
    const [sin, cos] = [angle.sin(), angle.cos()]
    const inner = radius.sub(y)

    const bentX = inner.mult(sin).add(beyond.mult(cos)).add(from)
    const bentY = radius.sub(inner.mult(cos)).add(beyond.mult(sin))
    return glsl.vec3(bentX, bentY, z).sub(position)
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  translate(40, -50)
  rotateX(-0.5)
  rotateY(0.5 + sin(millis() / 4000) / 3)
  scale(2.5)
  fill('#c9d1e6')
  specularMaterial(255)
  shininess(80)
  bend()
  model(spoon)
}
