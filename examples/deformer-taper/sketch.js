// Slices get narrower along an axis. The slice at the center keeps
// its size.
let teapot, taper

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  teapot = await loadModel('teapot.obj')

  taper = createWarp(
    warpjet.taper({
      axis: 'y',
      center: [0, 60, 0],
      length: 160,
      amount: ({ millis }) => millis.div(1000).sin().mult(-0.9),
    }),
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateY(sin(millis() / 3000) / 2)
  scale(1.9)
  fill('#43c6ac')
  specularMaterial(90)
  shininess(40)
  taper()
  model(teapot)
}
