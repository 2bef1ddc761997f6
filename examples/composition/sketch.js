// Warps composed of warps: a twist and a bend, alone, chained in
// both orders, added, blended, masked, and in a space whose origin
// is beside the bar.
let bar
const warps = {}

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  const font = await loadFont('fredoka.woff')
  textFont(font)
  textAlign(CENTER)
  // clearColors() removes the current fill, which p5 1.11 stores in the geometry.
  bar = makeBar(42, 150).clearColors()

  const { add, bend, blend, chain, inSpace, mask, twist } = warpjet
  const oscillate = (max) => (inputs) => inputs.millis.div(1500).cos().mult(max)
  const a = twist({ axis: 'y', length: 150, angle: oscillate(2.6) })
  const b = bend({ axis: 'z', from: -75, to: 75, angle: oscillate(2.1) })
  const above = ({ glsl, position }) => glsl.smoothstep(20, -20, position.y())
  // A matrix in column-major order, which adds 25 to x.
  const aside = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 25, 0, 0, 1]

  warps.twist = createWarp(a)
  warps.bend = createWarp(b)
  warps.twistThenBend = createWarp(chain(a, b))
  warps.bendThenTwist = createWarp(chain(b, a))
  warps.sum = createWarp(add(a, b))
  warps.halfway = createWarp(blend(a, b, 0.5))
  warps.above = createWarp(mask(a, above))
  warps.aside = createWarp(inSpace(aside, a))
}

function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(70)
  shininess(30)

  const { twist, bend, twistThenBend, bendThenTwist, sum, halfway, above, aside } = warps
  panel(0, 0, '#8d93a8', 'a: twist', twist)
  panel(1, 0, '#8d93a8', 'b: bend', bend)
  panel(2, 0, '#ff8a5b', 'chain(a, b)', twistThenBend)
  panel(3, 0, '#e9c46a', 'chain(b, a)', bendThenTwist)
  panel(0, 1, '#43c6ac', 'add(a, b)', sum)
  panel(1, 1, '#6fb7e9', 'blend(a, b, 0.5)', halfway)
  panel(2, 1, '#a99cff', 'mask(a, above)', above)
  panel(3, 1, '#e07fa8', 'inSpace(aside, a)', aside)
}

function panel(column, row, color, label, warp) {
  push()
  translate(160 * column - 240, 236 * row - 130)
  fill('#d5d9e6')
  textSize(15)
  text(label, 0, 118)
  rotateX(-0.25)
  rotateY(0.5)
  warp()
  fill(color)
  model(bar)
  pop()
}

// p5's box() has vertices only at its corners.
function makeBar(width, height) {
  return buildGeometry(() => {
    for (let side = 0; side < 4; side++) {
      push()
      translate(0, 0, width / 2)
      plane(width, height, 10, 40)
      pop()
      rotateY(HALF_PI)
    }
    for (const end of [-1, 1]) {
      push()
      translate(0, (end * height) / 2)
      rotateX(-end * HALF_PI)
      plane(width, width, 10, 10)
      pop()
    }
  })
}
