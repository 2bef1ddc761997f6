// User functions in GLSL and WGSL, with their derivatives in each supported way. scalars.js describes rows.
import { span } from './row.js'
import { sine } from './tolerances.js'

const { sin, cos } = Math

/** Writes a function of floats in GLSL and WGSL. */
function writeSource(name, names, body) {
  const parameters = (text) => names.map(text).join(', ')
  return {
    glsl: `float ${name}(${parameters((x) => `float ${x}`)}) { return ${body}; }`,
    wgsl: `fn ${name}(${parameters((x) => `${x}: f32`)}) -> f32 { return ${body}; }`,
  }
}

/** x² y + x, with its derivatives as functions of the arguments. */
const bump = {
  name: 'bump',
  arity: 2,
  source: writeSource('bump', ['x', 'y'], 'x * x * y + x'),
  derivatives: [(x, y) => x.mult(y, 2).add(1), (x) => x.mult(x)],
}

/** sin(3 x), with another user function as its derivative, 3 cos(3 x), whose derivative is an expression. */
function wave(glsl) {
  const slope = glsl.fn({
    name: 'waveSlope',
    arity: 1,
    source: writeSource('waveSlope', ['x'], '3.0 * cos(3.0 * x)'),
    derivatives: [(x) => x.mult(3).sin().mult(-9)],
  })
  return {
    name: 'wave',
    arity: 1,
    source: writeSource('wave', ['x'], 'sin(3.0 * x)'),
    derivatives: [slope],
  }
}

/** 2 x - 0.5 y, whose derivatives are the number 2 and an expression. */
const slantFunction = (glsl) => ({
  name: 'slanted',
  arity: 2,
  source: writeSource('slanted', ['x', 'y'], '2.0 * x - 0.5 * y'),
  derivatives: [2, glsl.val(-0.5)],
})

const row = (shapes, note, build, reference, more) => ({
  name: 'fn',
  note,
  only: 'builder',
  inShaders: 'its source is in shading languages',
  shapes: [shapes],
  domains: [span(-2, 2, { at: [0] })],
  build,
  reference,
  ...more,
})

export const functions = [
  row(
    [1, 1],
    'derivatives as functions',
    ({ call }, x, y) => call(bump)(x, y),
    ([x], [y]) => [x * x * y + x],
  ),
  row(
    [3, 1],
    'of a vector and a number',
    ({ call }, v, y) => call(bump)(v, y),
    (v, [y]) => v.map((x) => x * x * y + x),
  ),
  row(
    [1],
    'of an expression and of itself',
    ({ call }, x) => {
      const f = call(bump)
      return f(f(x, 0.5), x.mult(x))
    },
    ([x]) => {
      const inner = 0.5 * x * x + x
      return [inner * inner * x * x + inner]
    },
  ),
  row(
    [2],
    'another function as derivative',
    ({ glsl, call }, v) => call(wave(glsl))(v),
    (v) => v.map((x) => sin(3 * x)),
    { tolerance: sine },
  ),
  row(
    [1],
    'another function as derivative, differentiated twice',
    ({ glsl, call }, x) => glsl.derivative(call(wave(glsl))(x.mult(x)), x),
    ([x]) => [6 * x * cos(3 * x * x)],
    { tolerance: sine },
  ),
  row(
    [1, 1],
    'a number and an expression as derivatives',
    ({ glsl, call }, x, y) => call(slantFunction(glsl))(x, y),
    ([x], [y]) => [2 * x - 0.5 * y],
  ),
]
