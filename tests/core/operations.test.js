// Every operation on the CPU, in double precision, against the reference of tests/operations; and
// that there is no operation without one.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { madeOf, ofVectors, sameAs } from '../operations/aliases.js'
import { compile } from '../../dist/warpjet.js'
import { brokenConventions, inDouble, problemsOf } from '../operations/check.js'
import { conventions } from '../operations/conventions.js'
import { forms, inputMakers, programOf, runOnCpu } from '../operations/program.js'
import { cases } from '../operations/reference.js'
import { expected, points, swizzleProgram, swizzles } from '../operations/swizzles.js'

const targets = ['glsl300', 'glsl100', 'wgsl']
const groups = [...new Set(cases.map(({ group }) => group))]
const casesOf = (group) => cases.filter((operation) => operation.group === group)

/** Other test files cover these. */
const functions = [
  'source',
  'repeat',
  'texture',
  'noise',
  'simplex',
  'valueNoise',
  'worley',
  'curl',
  'fbm',
  'ridged',
  'turbulence',
]

/** Results are asked for, not computed; and those of a warp: tests/compile/compile.test.js and tests/cpp/warp_test.cpp have them. */
const results = ['output', 'outputDeriv', 'adjustNormal', 'adjustTangent']

/** Other names, which tests/core/front-door.test.js and vectors.test.js prove. */
const aliases = [...Object.keys(sameAs), ...Object.keys(madeOf), ...ofVectors]

/** The names that a user can call, { builder, method }. */
function surface() {
  const names = {}
  compile((glsl) => {
    names.builder = Object.keys(glsl)
    const x = glsl.param('x')
    names.method = []
    for (let at = Object.getPrototypeOf(x); at !== Object.prototype; at = Object.getPrototypeOf(at))
      names.method.push(...Object.getOwnPropertyNames(at))
    // Swizzles of several letters become properties when they are first looked up.
    names.method.push(...swizzles.filter((name) => name.length > 1 && name in x))
    return { y: x }
  })
  const isOperation = (name) =>
    !['constructor', ...results, ...functions, ...aliases].includes(name)
  return {
    builder: names.builder.filter(isOperation),
    method: names.method.filter(isOperation),
  }
}

describe('the reference has', () => {
  const { builder, method } = surface()
  const proved = new Set([...cases.map(({ name }) => name), ...inputMakers, ...swizzles])

  test('every function of the builder', () =>
    assert.deepEqual(
      builder.filter((name) => !proved.has(name)),
      [],
    ))

  test('every method of expressions', () =>
    assert.deepEqual(
      method.filter((name) => !proved.has(name)),
      [],
    ))

  test('nothing that there is not, in either form', () => {
    const called = cases.flatMap((operation) =>
      forms(operation).map((form) => [form, operation.name]),
    )
    const there = { builder, method }
    assert.deepEqual(
      called.filter(([form, name]) => !there[form].includes(name)),
      [],
    )
  })

  test('as many components as an operand can have', () => {
    const shapes = new Set(cases.flatMap(({ inputs }) => inputs.map(({ shape }) => shape)))
    assert.deepEqual([...shapes], [1, 2, 3, 4, 'mat2', 'mat3', 'mat4'])
  })
})

describe('a method and the function of the builder give the same text:', () => {
  for (const target of targets)
    test(target, () => {
      for (const operation of cases) {
        const texts = forms(operation).map((form) => programOf(operation, target, form).code)
        assert.equal(new Set(texts).size, 1, `${operation.title}\n${texts.join('\n')}`)
      }
    })
})

describe('value and every derivative on the CPU:', () => {
  for (const group of groups.filter((group) => casesOf(group).some((row) => !row.inShaders)))
    test(group, async () => {
      const problems = []
      for (const operation of casesOf(group).filter(({ inShaders }) => !inShaders)) {
        const program = programOf(operation, 'glsl300')
        const run = (given) => runOnCpu(program, given)
        problems.push(...(await problemsOf(operation, run, inDouble)))
      }
      assert.deepEqual(problems, [])
    })
})

describe('kinks, jumps and ends of domains on the CPU:', () => {
  for (const convention of conventions)
    test(convention.operation.title, async () => {
      const program = programOf(convention.operation, 'glsl300')
      const run = (given) => runOnCpu(program, given)
      assert.deepEqual(await brokenConventions(convention, run, inDouble), [])
    })
})

test('every swizzle on the CPU', () => {
  assert.equal(swizzles.length, 3 * (4 + 4 ** 2 + 4 ** 3 + 4 ** 4) + 2 + 2 ** 2 + 2 ** 3 + 2 ** 4)
  assert.deepEqual(runOnCpu(swizzleProgram('glsl300'), points), [expected])
})

test('a function of the user, which has no text for the CPU, says so there', () => {
  const program = programOf(
    cases.find(({ inShaders }) => inShaders),
    'glsl300',
  )
  assert.throws(() => runOnCpu(program, [[1, 2]]), { name: 'WarpError', message: /only.*GPU/ })
})
