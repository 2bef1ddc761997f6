// A shader in p5.strands, with operators, an if and a loop. Left: as p5 draws it,
// lit as if nothing had moved. Right: the same shader after exactNormals.
// Needs p5 2: p5 1.11 has no p5.strands.
let before, after

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  before = baseMaterialShader().modify(() => {
    getObjectInputs((inputs) => {
      let x = inputs.position.x
      let y = inputs.position.y
      let z = inputs.position.z
      const time = millis() / 1000
      if (y > 0) {
        x += sin(y * 5 + time) * 0.25 * y
      } else {
        z += sin(y * 5 + time) * 0.25 * y
      }
      for (let i = 1; i < 4; i++) {
        y += (0.09 / i) * sin(x * 3 * i + time)
      }
      inputs.position = [x, y, z]
      return inputs
    })
  })
  after = exactNormals(before)
}

function draw() {
  background('#151823')
  ambientLight(60)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(140)
  shininess(40)
  panel(-150, '#e9c46a', before)
  panel(150, '#43c6ac', after)
}

function panel(x, color, material) {
  push()
  translate(x, 0)
  rotateX(0.4)
  shader(material)
  fill(color)
  sphere(105, 120, 80)
  pop()
}
