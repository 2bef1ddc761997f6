// A rake draws into a p5.Graphics, and a plane of sand takes its grey for its height. The
// image is read as a cubic B-spline, so the light knows its exact slope at every vertex
// and shows none of its 160 × 160 pixels.
let sand, heights

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  heights = createGraphics(160, 160)
  heights.pixelDensity(1)
  heights.background(110)
  heights.noStroke()
  for (let t = 0; t < 60; t += 0.01) rake(t)

  sand = createWarp(
    ({ glsl, position }) => {
      const uv = position.xy().add(0.5)
      const height = glsl.texture('heights', uv, { filter: 'bspline' }).r()
      return glsl.vec3(0, 0, height.mult(55))
    },
    { defs: 'uniform sampler2D heights;' },
  )
}

/** Seven teeth, side by side across the way: grooves, and ridges between them. */
function rake(t) {
  const [x, y] = [80 + 52 * sin(t), 80 + 52 * sin(1.37 * t + 1)]
  const way = atan2(1.37 * cos(1.37 * t + 1), cos(t))
  for (let tooth = -3; tooth <= 3; tooth++) {
    const side = 4 * tooth
    heights.fill(tooth % 2 ? 190 : 40, 60)
    heights.circle(x - side * sin(way), y + side * cos(way), 5)
  }
}

function draw() {
  background('#151823')
  const now = 60 + millis() / 1500
  for (let t = now - deltaTime / 1500; t < now; t += 0.01) rake(t)

  ambientLight(70)
  directionalLight(255, 214, 165, 0.9, 0.35, -0.35)
  directionalLight(70, 90, 150, -0.6, -0.7, -0.5)
  rotateX(0.85)
  rotateZ(millis() / 15000)
  translate(0, 0, -30)
  sand({ heights })
  fill('#d9b98a')
  plane(400, 400, 240, 240)
}
