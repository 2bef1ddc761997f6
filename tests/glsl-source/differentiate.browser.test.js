// Runs the output of `differentiate` on every pipeline: compares gradients and Jacobians with finite differences that an interpreter
// with its own parser computes in double precision.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { differentiate } from '../../dist/glsl.js'
import { pointsOfCube } from '../glsl/points.js'
import { walk } from '../glsl/walk.js'
import { derivative } from '../random/differences.js'
import { openPipelines, targetsInThisRun } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

// Arguments of the functions below, as code in each language and as a function from a point `p` to numbers.
const integer = {
  glsl: 'int(floor(p.z * 4.0))',
  wgsl: 'i32(floor(p.z * 4.0))',
  numbersAt: ([, , z]) => [Math.floor(z * 4)],
}
const unsigned = {
  glsl: 'uint(floor(p.z * 4.0) + 4.0)',
  wgsl: 'u32(floor(p.z * 4.0) + 4.0)',
  numbersAt: ([, , z]) => [Math.floor(z * 4) + 4],
}
const condition = { glsl: 'p.y > 0.1', numbersAt: ([, y]) => [y > 0.1] }
const [x, xy, xyz, xyzx] = ['x', 'xy', 'xyz', 'xyzx'].map((letters) => ({
  glsl: `p.${letters}`,
  numbersAt: (p) => [...letters].map((letter) => p['xyz'.indexOf(letter)]),
}))
const matrix = {
  glsl: 'mat2(1.0, 2.0, p.z, 0.5)',
  wgsl: 'mat2x2f(1.0, 2.0, p.z, 0.5)',
  numbersAt: ([, , z]) => [1, 2, z, 0.5],
}

const turn = `vec2 f(vec2 p, float a) {
  float c = cos(a * p.y), s = sin(a * p.x);
  return mat2(c, s, -s, c) * p;
}`
/**
 * Maps a title → a function `f`, the index of the parameter with respect to which it is differentiated, an argument for each parameter, and
 * whether it uses bit operations.
 */
const cases = {
  'a distance field, with respect to its point': [
    'float f(vec3 p) { return length(p * p.yzx + 0.3) - p.x; }',
    0,
    [xyz],
  ],
  'a float function of a float': ['float f(float t) { return sin(t * 3.0) * t; }', 0, [x]],
  'a float function of a vec2, with an int and a bool': [
    'float f(int n, vec2 p, bool isOn) { return isOn ? sin(p.x * float(n)) : p.y * p.y * float(abs(n) % 3); }',
    1,
    [integer, xy, condition],
  ],
  'a vec2 function of a vec2': [turn, 0, [xy, x]],
  'a vec2 function of a float': [turn, 1, [xy, x]],
  'a vec3 function of a vec3, with a loop up to an int parameter': [
    `vec3 f(vec3 p, int n, bool isOn) {
      vec3 q = p;
      for (int i = 0; i < 4; i++) { if (i >= n) break; q += 0.3 * sin(q.yzx * float(i + 1)); }
      return isOn ? q : q * p.x;
    }`,
    0,
    [xyz, integer, condition],
  ],
  'a vec3 function of a vec3, with the bits of a uint': [
    'vec3 f(vec3 p, uint n) { return p.zxy * p * float((n & 3u) + (n >> 1)); }',
    0,
    [xyz, unsigned],
    true,
  ],
  'a vec4 function of a vec4': [
    'vec4 f(vec4 q) { return q.wzyx * q * q.x + normalize(q + 1.5); }',
    0,
    [xyzx],
  ],
  'a vec2 function of a vec3': ['vec2 f(vec3 p) { return p.xy * p.z + sin(p.zx); }', 0, [xyz]],
  'a vec4 function of a vec2': ['vec4 f(vec2 p) { return vec4(p, p.x * p.y, cos(p.x)); }', 0, [xy]],
  'a vec3 function of a vec4': ['vec3 f(vec4 q) { return cross(q.xyz, q.wzx + 0.3); }', 0, [xyzx]],
  'a vec2 function of a vec2, with a matrix parameter': [
    'vec2 f(vec2 p, mat2 m) { return m * p * p.x + inverse(m) * p; }',
    0,
    [xy, matrix],
  ],
}

const sizes = { float: 1, vec2: 2, vec3: 3, vec4: 4 }
const points = pointsOfCube(40)

/** Returns the value and the finite differences of `f` at a point. Changes the argument rather than the point. */
function expectedAt(source, by, operands, p) {
  const f = walk(source, 'f')
  const args = operands.map(({ numbersAt }) => numbersAt(p))
  const value = f(...args)
  const at = ({ numbers }) => f(...args.map((arg, i) => (i === by ? numbers : arg)))
  const columns = args[by].map((_, index) =>
    derivative(at, { numbers: args[by] }, [{ name: 'numbers', index }], value),
  )
  return { value, columns }
}

for (const [name, [source, by, operands, hasBits]] of Object.entries(cases)) {
  const [, type, list] = /(\w+) f\((.*?)\) \{/.exec(source)
  const parameter = list.split(', ')[by].split(' ')
  const [from, to] = [sizes[parameter[0]], sizes[type]]
  const isGradient = to === 1
  for (const target of targetsInThisRun) {
    const isUnsupported =
      target === 'glsl100' && (hasBits || (!isGradient && from > 1 && from !== to))
    if (!isUnsupported)
      test(`${name}: derivatives equal finite differences, in ${target}`, async () => {
        const declarations = differentiate(source, { function: 'f', by: parameter[1], target })
        const isWgsl = target === 'wgsl'
        const args = operands.map((operand) => (isWgsl && operand.wgsl) || operand.glsl).join(', ')
        const result = `f${isGradient ? 'Gradient' : 'Jacobian'}(${args})`
        // Returns a matrix column by column, since the pipelines lack some sizes.
        const isMatrix = !isGradient && from > 1
        const outputs = isMatrix
          ? Array.from({ length: from }, (_, k) => ({ name: `column${k}`, shape: to }))
          : [{ name: 'result', shape: isGradient ? from + 1 : to }]
        const declare = ({ name, shape }, value) =>
          `${isWgsl ? 'let' : `vec${shape}`} ${name} = ${value};`
        const values = await pipelines.run(
          target,
          {
            code: outputs
              .map((output, k) => declare(output, isMatrix ? `${result}[${k}]` : result))
              .join('\n'),
            declarations,
            inputs: [{ name: 'p', shape: 3 }],
            outputs,
          },
          points,
        )
        let compared = 0
        points.forEach((p, i) => {
          const { value, columns } = expectedAt(source, by, operands, p)
          const expected = [
            ...(isGradient ? value.map((number) => ({ value: number, error: 0 })) : []),
            ...columns.flat(),
          ]
          assert.equal(values[i].length, expected.length)
          expected.forEach(({ value, error }, k) => {
            if (!(error <= 1e-4)) return
            compared++
            const isNear = Math.abs(values[i][k] - value) <= 2e-3 * Math.max(1, Math.abs(value))
            assert.ok(isNear, `number ${k} at ${p}: expected ${value}, got ${values[i][k]}`)
          })
        })
        const all = points.length * (isGradient ? from + 1 : from * to)
        assert.ok(compared > 0.9 * all, `${compared} of ${all} were compared`)
      })
  }
}
