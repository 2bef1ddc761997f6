// Figure 6 of Pagurek's paper of 2024, with one edge per side: a cube of 12
// triangles, drawn four times with the same twist. In the lower row, `detail` divides
// the cube as finely as the picture needs; on the right, each pixel computes its own
// normal.
let warps

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  const twist = ({ glsl, position, millis }) => {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const angle = y.mult(6).add(millis.div(1500)).sin().mult(0.6)
    const [sin, cos] = [angle.sin(), angle.cos()]
    const turnedX = x.mult(cos).sub(z.mult(sin))
    const turnedZ = x.mult(sin).add(z.mult(cos))
    return glsl.vec3(turnedX, y, turnedZ).sub(position)
  }
  warps = [
    { normals: 'vertex' },
    { normals: 'pixel' },
    { normals: 'vertex', detail: 1 },
    { normals: 'pixel', detail: 1 },
  ].map((options) => createWarp(twist, options))
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(40)

  warps.forEach((warp, i) => {
    push()
    translate(i % 2 ? 145 : -145, i < 2 ? -110 : 110)
    rotateX(-0.4)
    rotateY(0.6)
    fill(i < 2 ? '#ff8a5b' : '#43c6ac')
    warp()
    box(130)
    pop()
  })
}
