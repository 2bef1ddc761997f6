// Figure 5 of Pagurek's paper of 2024: a genie. Each vertex flies into the spout
// along its own curve, the vertices nearest to the spout first.
let bunny, teapot, vanish

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  bunny = await loadModel('bunny.obj')
  teapot = await loadModel('teapot.obj')

  vanish = createWarp(({ glsl, position, millis }) => {
    const spout = glsl.vec3(100, 186, 0)
    const above = glsl.vec3(150, 0, 0)
    const progress = millis.div(1300).sin().mult(0.75).add(0.5)
    const start = position.dist(spout).div(480)
    const t = glsl.smoothstep(start, start.add(0.5), progress)

    // A quadratic Bézier curve from the vertex to the spout.
    const path = position.mix(above, t).mix(above.mix(spout, t), t)
    return path.sub(position)
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(40)

  push()
  translate(-40, 120)
  scale(1.2)
  fill('#e9c46a')
  model(teapot)
  pop()

  push()
  translate(-20, -100)
  fill('#43c6ac')
  vanish()
  model(bunny)
  pop()
}
