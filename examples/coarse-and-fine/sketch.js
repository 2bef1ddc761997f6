// Figure 6 of Pagurek's paper of 2024: one twist on two cubes. A warp moves only
// vertices, so a coarse mesh stays straight between its vertices.
let coarse, fine, twist

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  // clearColors() removes the current fill, which p5 1.11 stores in the geometry.
  coarse = denseCube(180, 2).clearColors()
  fine = denseCube(180, 40).clearColors()

  twist = createWarp(({ glsl, position, millis }) => {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const angle = y.mult(0.014).mult(millis.div(1000).sin())
    const [sin, cos] = [angle.sin(), angle.cos()]
    const turnedX = x.mult(cos).sub(z.mult(sin))
    const turnedZ = x.mult(sin).add(z.mult(cos))
    return glsl.vec3(turnedX, y, turnedZ).sub(position)
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(40)
  twist()

  place(-150, '#ff8a5b', coarse)
  place(150, '#43c6ac', fine)
}

function place(x, color, shape) {
  push()
  translate(x, 0)
  rotateX(-0.5)
  rotateY(0.7)
  fill(color)
  model(shape)
  pop()
}

// p5's box() has vertices only at its corners.
function denseCube(size, detail) {
  return buildGeometry(() => {
    for (let side = 0; side < 6; side++) {
      push()
      translate(0, 0, size / 2)
      plane(size, size, detail, detail)
      pop()
      // A rotation after each side brings the next one to the front.
      if (side % 2) rotateY(HALF_PI)
      else rotateX(HALF_PI)
    }
  })
}
