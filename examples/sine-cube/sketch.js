// Figure 3 of Pagurek's paper of 2024: a cube, moved by a sine along each axis.
// Every face has its own normals, so that the edges stay sharp.
let cube, warp

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  // clearColors() removes the current fill, which p5 1.11 stores in the geometry.
  cube = denseCube(200, 40).clearColors()

  warp = createWarp(({ glsl, position, millis }) => {
    const wave = (x) => x.mult(0.035).add(millis.div(800)).sin().mult(22)
    const [x, y, z] = [position.x(), position.y(), position.z()]
    return glsl.vec3(wave(y), wave(z), wave(x))
  })
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.5)
  rotateY(millis() / 4000)
  fill('#43c6ac')
  specularMaterial(110)
  shininess(40)
  warp()
  model(cube)
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
