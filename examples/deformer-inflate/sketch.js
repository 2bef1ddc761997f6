// Points move along their normals. The amount can be a function:
// here it runs over the hand in waves.
// Needs p5 2: p5 1.11 has no vertex properties.
let hand, inflate

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  hand = await addSurfaceVariation(await loadModel('hand.obj'))

  inflate = createWarp(
    warpjet.inflate({
      amount: ({ position, millis }) =>
        position.y().div(16).sub(millis.div(300)).sin().mult(4).add(2),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.2)
  rotateY(0.3)
  scale(1.8)
  fill('#e0a58a')
  specularMaterial(90)
  shininess(40)
  inflate()
  model(hand)
}
