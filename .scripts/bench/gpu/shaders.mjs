// Shaders of WebGL 2 that draw a warped sheet with exact normals at vertices, with exact normals at pixels, and with normals at pixels by
// finite differences.

/** Maps each input of a warp → its GLSL value at a vertex of the sheet. `corner` is the position of the vertex, from -1 to 1. */
const inputValues = {
  position: 'vec3(corner, 0.2)',
  normal: 'normalize(vec3(0.3 * corner, 1.0))',
  uv: '0.5 * corner + 0.5',
  color: 'vec4(0.5 * corner + 0.5, 0.5, 1.0)',
}
/** The value of all other inputs, which are gradients. */
const gradient = 'vec3(0.1 * corner, 0.5)'

/** Returns a function that writes declarations of variables. */
const declare = (qualifier) => (variables) =>
  variables.map(({ type, name }) => `${qualifier} ${type} ${name};\n`).join('')
const declareUniforms = declare('uniform highp')

const varyingsFor = (variables) =>
  variables.map(({ type, name }) => ({ type, name: `passed_${name}`, input: name }))

/** Writes a vertex shader. `outputs` are the varyings, each with the expression that is assigned to it, `input`. */
const writeVertexShader = ({ code, declarations, uniforms, attributes }, outputs) => {
  const inputs = new Map(attributes.map((each) => [each.name, each]))
  for (const each of outputs)
    if (!each.isResult) inputs.set(each.input, { type: each.type, name: each.input })
  return `#version 300 es
precision highp float;
${declareUniforms(uniforms)}${declare('out')(outputs)}${declarations}
void main() {
  vec2 corner = vec2(gl_VertexID % 101, gl_VertexID / 101) / 50.0 - 1.0;
${[...inputs.values()].map(({ type, name }) => `  ${type} ${name} = ${inputValues[name] ?? gradient};\n`).join('')}
${code}
${outputs.map(({ name, input }) => `  ${name} = ${input};\n`).join('')}
  // The factor is so small that the sheet stays in place, but the compiler cannot remove the warp.
  gl_Position = vec4(corner + 1e-20 * clamp(warpedPosition.xy, -1.0, 1.0), 0.0, 1.0);
}`
}

/** Writes a fragment shader. `body` computes `lit`, the normal with which light is computed. */
const writeFragmentShader = ({ uniforms, declarations }, inputs, body) => `#version 300 es
precision highp float;
precision highp int;
${declareUniforms(uniforms)}${declare('in')(inputs)}out vec4 color_;
${declarations}
void main() {
${body}
  color_ = vec4(vec3(max(dot(lit, vec3(0.48, 0.6, 0.64)), 0.0)), 1.0);
}`

const readInputs = (inputs) =>
  inputs.map(({ type, name, input }) => `  ${type} ${input} = ${name};\n`).join('')

/** Returns shaders that compute the normal by central differences along two tangents: four evaluations of the offset. */
function createDifferences(warp) {
  const inputs = varyingsFor([
    ...new Map([...warp.attributes, ...requiredInputs].map((each) => [each.name, each])).values(),
  ])
  const otherInputs = inputs.filter(({ input }) => input !== 'position')
  const parameters = otherInputs.map(({ type, input }) => `, ${type} ${input}`).join('')
  const otherArguments = otherInputs.map(({ input }) => `, ${input}`).join('')
  const move = `vec3 move(vec3 position${parameters}) {\n${warp.code}\nreturn warpedPosition;\n}`
  const moveBy = (step) => `move(position ${step}${otherArguments})`
  const body = `${readInputs(inputs)}
  vec3 u = normalize(cross(normal, vec3(0.3, 0.8, 0.5))) * 1e-3;
  vec3 v = cross(normal, u);
  vec3 lit = normalize(cross(${moveBy('+ u')} - ${moveBy('- u')}, ${moveBy('+ v')} - ${moveBy('- v')}));`
  const { uniforms, declarations } = warp
  const source = { uniforms, declarations: `${declarations}\n${move}` }
  return {
    vertex: writeVertexShader(warp, inputs),
    fragment: writeFragmentShader(source, inputs, body),
  }
}

const requiredInputs = [
  { type: 'vec3', name: 'position' },
  { type: 'vec3', name: 'normal' },
]

const hasSameCode = (a, b) => a.code === b.code && a.declarations === b.declarations

/** Returns shaders that compute the exact normal at each pixel. */
function createExact(plain, fragment) {
  const inputs = varyingsFor(fragment.attributes)
  return {
    vertex: writeVertexShader(plain, inputs),
    fragment: writeFragmentShader(
      fragment,
      inputs,
      `${readInputs(inputs)}${fragment.code}\n  vec3 lit = normalize(warpedNormal);`,
    ),
  }
}

/**
 * Maps each method of gpu.mjs → { vertex, fragment }. `warp` computes normals in the vertex stage, and `plain` is the same warp without
 * normals. `fragment` and `faded` are the warp's code for the fragment stage, in which noise does not fade and fades.
 */
export function createShaders(warp, plain, fragment, faded) {
  const shown = [{ type: 'vec3', name: 'shown', input: 'warpedNormal', isResult: true }]
  const none = { uniforms: [], declarations: '' }
  return {
    vertex: {
      vertex: writeVertexShader(warp, shown),
      fragment: writeFragmentShader(none, shown, '  vec3 lit = normalize(shown);'),
    },
    pixel: createExact(plain, fragment),
    ...(hasSameCode(fragment, faded) ? {} : { faded: createExact(plain, faded) }),
    differences: createDifferences(plain),
  }
}
