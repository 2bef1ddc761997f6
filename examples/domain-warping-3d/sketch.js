// The three levels of domain warping as the relief of a sphere: f(p), f(p + fbm(p)) and
// f(p + fbm(p + fbm(p))). Every vertex moves along its normal by f, and the lighting uses
// the exact normals of the result, through all three levels.
// After Inigo Quilez, Domain warping, 2002.
let plain, warped, twice

const relief =
  (level) =>
  ({ glsl, position, millis }) => {
    const { vec3 } = glsl
    const f = (p, ...shift) =>
      glsl
        .fbm(p.add(vec3(...shift)), { octaves: 3 })
        .mult(0.5)
        .add(0.5)
    const p = position.mult(0.5).add(millis.div(30000))
    let moved = p
    if (level > 0) {
      const q = vec3(f(p, 0, 0, 0), f(p, 5.2, 1.3, 2.8), f(p, 1.7, 9.2, 4.1))
      moved = p.add(q.mult(4))
    }
    if (level > 1) {
      const r = vec3(f(moved, 1.7, 9.2, 0), f(moved, 8.3, 2.8, 5.1), f(moved, 3.9, 6.4, 2.2))
      moved = p.add(r.mult(4))
    }
    // p5's sphere has radius 1 in its own space, so that position is also the normal.
    return position.mult(f(moved, 0, 0, 0).sub(0.5).mult(0.9))
  }

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  plain = createWarp(relief(0))
  warped = createWarp(relief(1))
  twice = createWarp(relief(2))
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(60)
  directionalLight(color('#fff0dd'), -0.5, 0.8, -0.9)
  directionalLight(color('#4463d6'), 0.8, -0.3, 0.2)
  specularMaterial(70)
  shininess(25)
  ball(-202, '#f2c14e', plain)
  ball(0, '#f0883e', warped)
  // The third level has finer detail and needs more vertices.
  ball(202, '#d9432f', twice, 240)
}

function ball(x, color, warp, detail = 160) {
  push()
  translate(x, 0)
  rotateY(millis() / 9000)
  warp()
  fill(color)
  sphere(88, detail, 0.75 * detail)
  pop()
}
