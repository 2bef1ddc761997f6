// The article's way to a normal (left) beside the exact one (right). The older way
// rotates the plane of x and y until it touches the surface, moves two neighbours
// in it, and takes the plane through the moved points. The axis of that rotation is
// z × normal. In front, the cube's normal is z: no axis, and no light.
let cube, exact, byNeighbours

const sines = ({ glsl, position, millis }) => {
  const wave = (x) => x.mult(0.04).add(millis.div(800)).sin().mult(16)
  const [x, y, z] = [position.x(), position.y(), position.z()]
  return glsl.vec3(wave(y), wave(z), wave(x))
}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  cube = denseCube(150, 30)
  exact = createWarp(sines)

  const { code } = warpjet.compileWarp(sines, { normals: false })
  byNeighbours = baseMaterialShader().modify({
    uniforms: { 'float millis': () => millis() },
    vertexDeclarations: `vec3 move(vec3 position) {
      ${code}
      return warpedPosition;
    }`,
    'Vertex getObjectInputs': `(Vertex inputs) {
      vec3 n = inputs.normal;
      vec3 axis = normalize(vec3(-n.y, n.x, 0.0));
      // The x and y axes after that rotation, by Rodrigues' formula.
      vec3 u = vec3(n.z, 0.0, -n.x) + axis * axis.x * (1.0 - n.z);
      vec3 v = vec3(0.0, n.z, -n.y) + axis * axis.y * (1.0 - n.z);
      vec3 here = move(inputs.position);
      vec3 besideU = move(inputs.position + 0.1 * u);
      vec3 besideV = move(inputs.position + 0.1 * v);
      inputs.position = here;
      inputs.normal = normalize(cross(besideU - here, besideV - here));
      return inputs;
    }`,
  })
}

function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight('#fff0dd', -0.5, 0.8, -0.9)
  directionalLight('#4463d6', 0.8, -0.3, 0.2)
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

// p5's box() has vertices at its corners only.
function denseCube(size, detail) {
  return buildGeometry(() => {
    for (let side = 0; side < 6; side++) {
      push()
      translate(0, 0, size / 2)
      plane(size, size, detail, detail)
      pop()
      // Turn by turn, these bring every side to the front.
      if (side % 2) rotateY(HALF_PI)
      else rotateX(HALF_PI)
    }
  })
}
