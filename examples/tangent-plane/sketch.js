// Two methods for normals: that of Pagurek's article of 2021 (left), and the exact one
// (right). The older method rotates the plane of x and y until it touches the surface,
// moves two neighbours in this plane, and takes the plane through the moved points. The
// axis of that rotation is z × normal. On the front of the cube, the normal is z: there
// is no axis, and no light.
// Needs p5 2: hooks of p5 1.11 have other names.
let cube, exact, byNeighbours

const sines = ({ glsl, position, millis }) => {
  const wave = (x) => x.mult(0.04).add(millis.div(800)).sin().mult(16)
  const [x, y, z] = [position.x(), position.y(), position.z()]
  return glsl.vec3(wave(y), wave(z), wave(x))
}

// The older method.
function tangentPlane(glsl) {
  const [position, normal] = ['position', 'normal'].map((name) => glsl.vec3Param(`inputs.${name}`))
  const move = (p) => p.add(sines({ glsl, position: p, millis: glsl.param('time') }))
  const [x, y, z] = [normal.x(), normal.y(), normal.z()]
  const across = glsl.vec3(y.mult(-1), x, 0)
  const axis = across.div(across.length())
  // The x and y axes after the rotation about `axis`, by Rodrigues' formula.
  const turn = z.mult(-1).add(1)
  const u = glsl.vec3(z, 0, x.mult(-1)).add(axis.mult(axis.x()).mult(turn))
  const v = glsl.vec3(0, z, y.mult(-1)).add(axis.mult(axis.y()).mult(turn))
  const here = move(position)
  const beside = (way) => move(position.add(way.mult(0.1))).sub(here)
  const normalThere = beside(u).cross(beside(v))
  // Without an axis, if the normal is along z, the result is NaN. WEBGL draws NaN as
  // black; `hasAxis` makes both renderers do so.
  return { here, normalThere, hasAxis: glsl.step(0.001, across.length()) }
}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  cube = denseCube(150, 30)
  exact = createWarp(sines)

  // Hooks are written in GLSL, and in WGSL on WEBGPU.
  const [target, time, begin] =
    webglVersion === WEBGL2
      ? ['glsl300', 'float time', '(Vertex inputs) {']
      : ['wgsl', 'time: f32', '(given: Vertex) { var inputs = given; let time = hooks.time;']
  const { code } = warpjet.compile(tangentPlane, { target })
  byNeighbours = baseMaterialShader().modify({
    uniforms: { [time]: () => millis() },
    'Vertex getObjectInputs': `${begin}
      ${code}
      inputs.position = here;
      inputs.normal = normalize(normalThere);
      inputs.color = vec4(hasAxis * inputs.color.rgb, 1.0);
      return inputs;
    }`,
  })
}

function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(40)

  place(-150, '#ff8a5b', () => shader(byNeighbours))
  place(150, '#43c6ac', () => exact())
}

function place(x, color, use) {
  push()
  translate(x, 0)
  rotateX(-0.6)
  rotateY(0.5 * sin(millis() / 2000) + 0.3)
  use()
  fill(color)
  model(cube)
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
