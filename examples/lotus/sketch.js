// Figure 7a of Pagurek's paper of 2024: one warp, many times. Every petal is the
// same sphere, and a uniform sets how far the petal is bent.
let bloom

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  bloom = createWarp(
    ({ glsl, position }) => {
      const bend = glsl.param('bend')
      const [x, y, z] = [position.x().mult(0.34), position.y(), position.z()]
      const along = y.mult(-0.5).add(0.5)
      const angle = along.mult(bend)
      // The petal is thin, with its sides curled inwards.
      const front = z.mult(0.04).sub(x.mult(x).mult(1.6))

      // It follows an arc of a circle, leaning over to the front.
      const radius = glsl.val(1.5).div(bend)
      const inner = radius.sub(front)
      const up = angle.sin().mult(inner)
      const out = radius.sub(angle.cos().mult(inner))
      return glsl.vec3(x, up.neg(), out).sub(position)
    },
    { defs: 'uniform float bend;' },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(130)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(106, 92, 255, 0.8, -0.3, 0.2)
  specularMaterial(60)
  shininess(30)

  translate(0, 60)
  rotateX(-0.7)
  rotateY(millis() / 6000)
  const petals = 28
  for (let i = 0; i < petals; i++) {
    const outer = (i + 2) / petals
    push()
    rotateY(i * 2.4)
    translate(0, 0, 45 * outer)
    rotateX(0.5 - 1 * outer)
    fill(lerpColor(color('#ffe3b0'), color('#e0518a'), outer))
    const breath = sin(millis() / 1500 - outer)
    bloom({ bend: 0.3 + outer * (0.9 + 0.4 * breath) })
    sphere(90 + 60 * outer, 16, 24)
    pop()
  }
}
