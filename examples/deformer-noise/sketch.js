// Noise moves points along their normals: a sphere grows bumps that
// change over time.
// Needs p5 2: p5 1.11 has no vertex properties.
let ball, noise

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  ball = await addSurfaceVariation(buildGeometry(() => sphere(125, 160, 110)))

  noise = createWarp(warpjet.noiseDisplace({ amount: 55, scale: 75, speed: 0.4 }))
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  fill('#e9c46a')
  specularMaterial(110)
  shininess(40)
  noise()
  model(ball)
}
