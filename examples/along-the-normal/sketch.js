// Bumps along the normal of a ring. Left: lit as if the normal were constant around
// each vertex. Right: addSurfaceVariation adds the derivatives of the normal along
// the surface to the mesh, so that the light is correct.
// Needs p5 2: p5 1.11 has no vertex properties.
let ring, rough, exact

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  // On WEBGPU, only the farther half of this range of depths is visible.
  ortho(-320, 320, -240, 240, -2000, 2000)

  const bumps = ({ normal, position, millis }) => {
    const wave = (x) => x.mult(0.1).add(millis.div(900)).sin()
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const height = wave(x).add(wave(y), wave(z)).mult(4.5)
    // buildGeometry does not normalize normals.
    return normal.normalize().mult(height)
  }
  rough = createWarp(bumps, { surfaceVariation: false })
  exact = createWarp(bumps)

  ring = buildGeometry(() => torus(92, 38, 160, 80))
  await addSurfaceVariation(ring)
}

function draw() {
  background('#151823')
  ambientLight(80)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(160)
  shininess(40)

  panel(-155, '#e9c46a', rough)
  panel(155, '#43c6ac', exact)
}

function panel(x, color, warp) {
  push()
  translate(x, 0)
  rotateX(0.5)
  rotateY(0.3)
  warp()
  fill(color)
  model(ring)
  pop()
}
