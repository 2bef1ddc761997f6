// The three levels of domain warping as the relief of a sphere, f(p), f(p + fbm(p)) and
// f(p + fbm(p + fbm(p))): the offset is the normal times f, and the lights see the exact
// normals of it all.
// After Inigo Quilez, Domain warping, 2002.
let levels

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  levels = [1, 2, 3].map((level) =>
    createWarp(({ glsl, position, millis }) => {
      const f = (p, ...shift) => glsl.fbm(p.add(glsl.vec3(...shift)), { octaves: 4 }).mult(0.5).add(0.5)
      const p = position.mult(0.5).add(millis.div(30000))
      let at = p
      if (level > 1) {
        const q = glsl.vec3(f(p, 0, 0, 0), f(p, 5.2, 1.3, 2.8), f(p, 1.7, 9.2, 4.1))
        at = p.add(q.mult(4))
      }
      if (level > 2) {
        const r = glsl.vec3(f(at, 1.7, 9.2, 0), f(at, 8.3, 2.8, 5.1), f(at, 3.9, 6.4, 2.2))
        at = p.add(r.mult(4))
      }
      return position.mult(f(at, 0, 0, 0).sub(0.5).mult(0.8))
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(70)
  directionalLight('#fff0dd', -0.5, 0.8, -0.9)
  directionalLight('#4463d6', 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(30)
  const colors = ['#e9c46a', '#f4a261', '#e76f51']
  levels.forEach((warp, i) => {
    push()
    translate(210 * (i - 1), 0)
    rotateY(millis() / 9000)
    warp()
    fill(colors[i])
    sphere(95, 160, 120)
    pop()
  })
}
