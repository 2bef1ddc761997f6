// A window goes into the Dock: it narrows into a funnel and slides
// down that funnel.
let pane, genie

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  pane = drawScreen(360, 230)

  genie = createWarp(
    warpjet.genie({
      axis: 'y',
      center: [90, 215, 0],
      length: 400,
      neck: 0.06,
      amount: ({ millis }) => millis.div(5000).fract().sub(0.5).abs().mult(-1.2).add(0.6),
    }),
    { space: 'world' },
  )
}

function draw() {
  background('#151823')
  orbitControl()

  translate(-60, -60)
  texture(pane)
  genie()
  plane(360, 230, 60, 80)
}

function drawScreen(width, height) {
  const pane = createGraphics(width, height)
  pane.noStroke()
  pane.background('#f2ede4')
  for (let x = 0; x < width; x += 4) {
    const color = lerpColor(pane.color('#a99cff'), pane.color('#ff8a5b'), x / width)
    pane.fill(color)
    pane.rect(x, 26, 4, height)
  }
  pane.fill('#e9c46a')
  pane.circle(250, 110, 80)
  pane.fill('#43c6ac')
  pane.triangle(20, height, 130, 90, 240, height)
  pane.fill('#2f8f83')
  pane.triangle(150, height, 250, 130, 350, height)
  return pane
}
