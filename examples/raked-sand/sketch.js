// A garden of raked sand around two wandering stones. The sketch draws the furrows into a
// p5.Graphics, whose grey is the height of the sand. The image is read as a cubic
// B-spline, so the light uses its exact slope and shows none of its 120 × 120 pixels.
const side = 430
let sand, heights

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  heights = createGraphics(120, 120)
  heights.pixelDensity(1)
  heights.noStroke()
  sand = createWarp(
    ({ glsl, position }) => {
      const uv = position.xy().add(0.5)
      const height = glsl.texture('heights', uv, { filter: 'bspline' }).r()
      return glsl.vec3(0, 0, height.mult(14))
    },
    { defs: 'uniform highp sampler2D heights;' },
  )
}

function draw() {
  const time = millis() / 6000
  const stones = [
    { x: 40 + 8 * cos(time), y: 43 + 12 * sin(time), size: 6 },
    { x: 80 + 6 * sin(1.3 * time), y: 78 + 10 * cos(time), size: 9 },
  ]
  rakeAround(stones)

  background('#151823')
  ambientLight(60)
  directionalLight(255, 225, 185, cos(time), sin(time), -0.7)
  directionalLight(88, 80, 74, -cos(time), -sin(time), -0.9)
  translate(0, -10, -60)
  rotateX(0.65)
  rotateZ(0.3)
  push()
  sand({ heights })
  fill('#d8c3a0')
  plane(side, side, 160, 160)
  pop()

  fill('#6d7278')
  for (const { x, y, size } of stones) {
    push()
    translate((x / 120 - 0.5) * side, (y / 120 - 0.5) * side, 8)
    scale(1.2, 1, 0.8)
    sphere(4 * size)
    pop()
  }
}

/** Draws straight furrows, and rings around each stone; the grey across a furrow follows a cosine. */
function rakeAround(stones) {
  const grey = (distance) => 128 + 110 * cos((distance * TWO_PI) / 10)
  for (let y = 0; y < 120; y++) {
    heights.fill(grey(y))
    heights.rect(0, y, 120, 1)
  }
  for (const { x, y, size } of stones)
    for (let radius = size + 20; radius > size; radius -= 0.25) {
      heights.fill(grey(radius - size))
      heights.circle(x, y, 2 * radius)
    }
}
