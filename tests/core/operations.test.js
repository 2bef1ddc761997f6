// Compares every operation on the CPU, in double precision, with the reference of tests/operations, which must cover every operation.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { compositions, operationOfAlias, vectorMethods } from '../operations/aliases.js'
import { brokenConventions, inDouble, problemsOf } from '../operations/check.js'
import { conventions } from '../operations/conventions.js'
import { noises } from '../operations/noise.js'
import { forms, inputMakers, programOf, runOnCpu } from '../operations/program.js'
import { cases } from '../operations/reference.js'
import { expected, points, swizzleProgram, swizzles } from '../operations/swizzles.js'

const targets = ['glsl300', 'glsl100', 'wgsl']
const groups = [...new Set(cases.map(({ group }) => group))]
const casesOf = (group) => cases.filter((operation) => operation.group === group)

/** Functions that other test files cover. */
const coveredElsewhere = ['source', 'repeat', 'texture', ...noises]

/**
 * Methods that request results or transform normals and tangents, which tests/compile/compile.test.js and tests/cpp/warp_test.cpp cover.
 */
const warpMethods = ['output', 'outputDeriv', 'adjustNormal', 'adjustTangent']

/** Aliases and compositions, which tests/core/front-door.test.js and vectors.test.js cover. */
const aliases = [...Object.keys(operationOfAlias), ...Object.keys(compositions), ...vectorMethods]

/** Returns the names of the operations that users can call: functions of the builder, and methods of expressions. */
function callableNames() {
  const names = {}
  compile((glsl) => {
    names.builder = Object.keys(glsl)
    const x = glsl.param('x')
    names.method = []
    for (let p = Object.getPrototypeOf(x); p !== Object.prototype; p = Object.getPrototypeOf(p))
      names.method.push(...Object.getOwnPropertyNames(p))
    // Swizzles of several letters become properties when they are first looked up.
    names.method.push(...swizzles.filter((name) => name.length > 1 && name in x))
    return { y: x }
  })
  const isOperation = (name) =>
    !['constructor', ...warpMethods, ...coveredElsewhere, ...aliases].includes(name)
  return {
    builder: names.builder.filter(isOperation),
    method: names.method.filter(isOperation),
  }
}

describe('the reference covers', () => {
  const { builder, method } = callableNames()
  const coveredNames = new Set([...cases.map(({ name }) => name), ...inputMakers, ...swizzles])

  test('every function of the builder', () =>
    assert.deepEqual(
      builder.filter((name) => !coveredNames.has(name)),
      [],
    ))

  test('every method of expressions', () =>
    assert.deepEqual(
      method.filter((name) => !coveredNames.has(name)),
      [],
    ))

  test('only operations that exist, in both forms', () => {
    const called = cases.flatMap((operation) =>
      forms(operation).map((form) => [form, operation.name]),
    )
    const existing = { builder, method }
    assert.deepEqual(
      called.filter(([form, name]) => !existing[form].includes(name)),
      [],
    )
  })

  test('every size that an operand can have', () => {
    const shapes = new Set(cases.flatMap(({ inputs }) => inputs.map(({ shape }) => shape)))
    assert.deepEqual([...shapes], [1, 2, 3, 4, 'mat2', 'mat3', 'mat4'])
  })
})

describe('a method and the function of the builder compile to the same code:', () => {
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
        const run = (points) => runOnCpu(program, points)
        problems.push(...(await problemsOf(operation, run, inDouble)))
      }
      assert.deepEqual(problems, [])
    })
})

describe('kinks, jumps and boundaries of domains on the CPU:', () => {
  for (const convention of conventions)
    test(convention.operation.title, async () => {
      const program = programOf(convention.operation, 'glsl300')
      const run = (points) => runOnCpu(program, points)
      assert.deepEqual(await brokenConventions(convention, run, inDouble), [])
    })
})

test('every swizzle on the CPU', () => {
  assert.equal(swizzles.length, 3 * (4 + 4 ** 2 + 4 ** 3 + 4 ** 4) + 2 + 2 ** 2 + 2 ** 3 + 2 ** 4)
  assert.deepEqual(runOnCpu(swizzleProgram('glsl300'), points), [expected])
})

test('evaluating a function of the host on the CPU throws', () => {
  const program = programOf(
    cases.find(({ inShaders }) => inShaders),
    'glsl300',
  )
  assert.throws(() => runOnCpu(program, [[1, 2]]), { name: 'WarpError', message: /only.*GPU/ })
})
