// Figure 7e of Pagurek's paper of 2024: a carousel of cloths that hang by their upper
// edges and trail behind.
let cloth, wind

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  // A front and a back, each with its own normals. clearColors() removes the current fill, which p5 1.11 stores.
  cloth = buildGeometry(() => {
    for (const side of [0, PI]) {
      push()
      rotateY(side)
      translate(0, 0, 0.5)
      plane(110, 170, 24, 32)
      pop()
    }
  }).clearColors()

  wind = createWarp(
    ({ glsl, position, millis }) => {
      // From 0 at the upper edge to 1 at the lower.
      const down = position.y().div(170).add(0.5)
      const across = position.x().mult(0.05).add(position.y().mult(0.03))
      const phase = glsl.param('phase').sub(millis.div(300))
      const ripple = across.add(phase).sin().mult(down).mult(14)
      const trail = down.mult(down).mult(-50)
      return glsl.vec3(trail, trail.div(5), ripple)
    },
    { defs: 'uniform float phase;' },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(110)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(40)
  shininess(10)

  translate(0, -30)
  rotateX(-0.35)
  scale(1.2)
  rotateY(-millis() / 3000)
  push()
  translate(0, -85)
  rotateX(HALF_PI)
  fill('#f4efe6')
  torus(190, 3, 64, 12)
  pop()

  const colors = ['#ff8a5b', '#e9c46a', '#43c6ac', '#7a8cff']
  for (let i = 0; i < 8; i++) {
    push()
    rotateY((i * TWO_PI) / 8)
    translate(0, 0, 190)
    fill(colors[i % 4])
    wind({ phase: i * 1.7 })
    model(cloth)
    pop()
  }
}
