// Figure 2 of Pagurek's paper of 2024: a sphere, (a) at rest, (b) moved by sines, but lit
// by its old normals, (c) with flat normals from the screen-space derivatives dFdx and
// dFdy, (d) by createWarp, with exact normals.
// Needs p5 2: hooks of p5 1.11 have other names.
let warp, onlyPositions, facets

const sines = ({ glsl, position, millis }) => {
  const time = millis.div(700)
  const wave = (x, phase) => x.mult(7).add(time, phase).sin().mult(0.13)
  const [x, y, z] = [position.x(), position.y(), position.z()]
  return glsl.vec3(wave(y, 0), wave(z, 2), wave(x, 4))
}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  warp = createWarp(sines)

  // b and c use the same code without normals, written into hooks of p5: in GLSL, or on
  // WEBGPU in WGSL, where the y of derivatives points down.
  const { target, time, seen, begin, facet } = webglVersion === WEBGL2 ? inGLSL : inWGSL
  const { code } = warpjet.compileWarp(sines, {
    target,
    names: { position: 'inputs.position', millis: 'time' },
    normals: false,
  })
  onlyPositions = baseMaterialShader().modify({
    uniforms: { [time]: () => millis() },
    'Vertex getObjectInputs': `${begin('Vertex')}
      ${code}
      inputs.position = warpedPosition;
      return inputs;
    }`,
  })
  facets = onlyPositions.modify({
    varyingVariables: [seen],
    'Vertex getCameraInputs': `${begin('Vertex')} seen = inputs.position; return inputs; }`,
    'Inputs getPixelInputs': `${begin('Inputs')}
      inputs.normal = normalize(${facet});
      return inputs;
    }`,
  })
}

const inGLSL = {
  target: 'glsl300',
  time: 'float time',
  seen: 'vec3 seen',
  begin: (type) => `(${type} inputs) {`,
  facet: 'cross(dFdy(seen), dFdx(seen))',
}
const inWGSL = {
  target: 'wgsl',
  time: 'time: f32',
  seen: 'seen: vec3<f32>',
  begin: (type) => `(given: ${type}) { var inputs = given; let time = hooks.time;`,
  facet: 'cross(dpdx(seen), dpdy(seen))',
}

function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(120)
  shininess(50)

  panel(-150, -112, '#8d93a8', () => resetShader())
  panel(150, -112, '#e9c46a', () => shader(onlyPositions))
  panel(-150, 112, '#ff8a5b', () => shader(facets))
  panel(150, 112, '#43c6ac', () => warp())
}

function panel(x, y, color, use) {
  push()
  translate(x, y)
  use()
  fill(color)
  sphere(82, 64, 48)
  pop()
}
