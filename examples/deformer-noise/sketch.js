// A sphere grows bumps along its normals, which become others as
// time goes by.
let noise

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  noise = createWarp(warpjet.noiseDisplace({ amount: 55, scale: 75, speed: 0.4 }), {
    space: 'world',
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight('#fff0dd', -0.5, 0.8, -0.9)
  directionalLight('#4463d6', 0.8, -0.3, 0.2)

  fill('#e9c46a')
  specularMaterial(110)
  shininess(40)
  noise()
  sphere(125, 200, 140)
}
