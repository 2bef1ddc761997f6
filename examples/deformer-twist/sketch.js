// Slices rotate about an axis: the further along the axis a slice
// is, the further it rotates.
let hand, twist

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  hand = await loadModel('hand.obj')

  twist = createWarp(
    warpjet.twist({
      axis: 'y',
      length: 200,
      angle: ({ millis }) => millis.div(1200).cos().mult(2.8),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateY(0.3)
  scale(1.7)
  fill('#e0a58a')
  specularMaterial(70)
  shininess(30)
  twist()
  model(hand)
}
