// The output of `differentiate` on every pipeline: gradients and Jacobians against differences in double by an interpreter over
// an independent parser.
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

/**
 * Functions `f`, with the argument for each parameter, as code and as numbers at a point `p`; `by` is the index of the parameter
 * with respect to which `f` is differentiated.
 */
const whole = {
  glsl: 'int(floor(p.z * 4.0))',
  wgsl: 'i32(floor(p.z * 4.0))',
  of: ([, , z]) => [Math.floor(z * 4)],
}
const natural = {
  glsl: 'uint(floor(p.z * 4.0) + 4.0)',
  wgsl: 'u32(floor(p.z * 4.0) + 4.0)',
  of: ([, , z]) => [Math.floor(z * 4) + 4],
}
const condition = { glsl: 'p.y > 0.1', of: ([, y]) => [y > 0.1] }
const [x, xy, xyz, xyzx] = ['x', 'xy', 'xyz', 'xyzx'].map((letters) => ({
  glsl: `p.${letters}`,
  of: (p) => [...letters].map((letter) => p['xyz'.indexOf(letter)]),
}))
const matrix = {
  glsl: 'mat2(1.0, 2.0, p.z, 0.5)',
  wgsl: 'mat2x2f(1.0, 2.0, p.z, 0.5)',
  of: ([, , z]) => [1, 2, z, 0.5],
}

const turn = `vec2 f(vec2 p, float a) {
  float c = cos(a * p.y), s = sin(a * p.x);
  return mat2(c, s, -s, c) * p;
}`
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
    [whole, xy, condition],
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
    [xyz, whole, condition],
  ],
  'a vec3 function of a vec3, with the bits of a uint': [
    'vec3 f(vec3 p, uint n) { return p.zxy * p * float((n & 3u) + (n >> 1)); }',
    0,
    [xyz, natural],
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

/** Changes the argument directly, so that the point can stay where it is. */
function wantedAt(text, by, operands, p) {
  const f = walk(text, 'f')
  const given = operands.map(({ of }) => of(p))
  const value = f(...given)
  const at = ({ numbers }) => f(...given.map((each, i) => (i === by ? numbers : each)))
  const columns = given[by].map((_, index) =>
    derivative(at, { numbers: given[by] }, [{ name: 'numbers', index }], value),
  )
  return { value, columns }
}

for (const [name, [text, by, operands, hasBits]] of Object.entries(cases)) {
  const [, type, list] = /(\w+) f\((.*?)\) \{/.exec(text)
  const parameter = list.split(', ')[by].split(' ')
  const [from, to] = [sizes[parameter[0]], sizes[type]]
  const isGradient = to === 1
  for (const target of targetsInThisRun) {
    const isLacking = target === 'glsl100' && (hasBits || (!isGradient && from > 1 && from !== to))
    if (!isLacking)
      test(`${name}: equals its differences, in ${target}`, async () => {
        const declarations = differentiate(text, { function: 'f', by: parameter[1], target })
        const isWgsl = target === 'wgsl'
        const given = operands.map((each) => (isWgsl && each.wgsl) || each.glsl).join(', ')
        const result = `f${isGradient ? 'Gradient' : 'Jacobian'}(${given})`
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
              .map((each, k) => declare(each, isMatrix ? `${result}[${k}]` : result))
              .join('\n'),
            declarations,
            inputs: [{ name: 'p', shape: 3 }],
            outputs,
          },
          points,
        )
        let compared = 0
        points.forEach((p, i) => {
          const { value, columns } = wantedAt(text, by, operands, p)
          const wanted = [
            ...(isGradient ? value.map((number) => ({ value: number, error: 0 })) : []),
            ...columns.flat(),
          ]
          assert.equal(values[i].length, wanted.length)
          wanted.forEach(({ value, error }, k) => {
            if (!(error <= 1e-4)) return
            compared++
            const isNear = Math.abs(values[i][k] - value) <= 2e-3 * Math.max(1, Math.abs(value))
            assert.ok(isNear, `number ${k} at ${p}: ${values[i][k]}, not ${value}`)
          })
        })
        const all = points.length * (isGradient ? from + 1 : from * to)
        assert.ok(compared > 0.9 * all, `${compared} of ${all} were compared`)
      })
  }
}
