// Tests notation that users of other libraries may try: components without parentheses, and the names that operations have in those
// libraries.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { WarpError, compile, compileWarp } from '../../dist/warpjet.js'
import { compositions, operationOfAlias } from '../operations/aliases.js'

const textOf = (make) =>
  compile((glsl) => ({ result: make(glsl, glsl.vec3Param('a'), glsl.param('x')) })).code

test('a component is a value that can also be called', () => {
  for (const name of ['x', 'yz', 'bgr', 'xyxy', 'st']) {
    const called = textOf((_, a) => a[name]().mult(2))
    assert.equal(
      textOf((_, a) => a[name].mult(2)),
      called,
      name,
    )
    assert.equal(
      textOf((glsl, a) => glsl.mult(a[name], 2)),
      called,
      name,
    )
  }
  // The method length has the name of a property of every JavaScript function.
  assert.equal(
    textOf((_, a) => a.xy.length()),
    textOf((_, a) => a.xy().length()),
  )
  assert.equal(
    textOf((_, a) => a.xy),
    textOf((_, a) => a.xy()),
  )
  compile((glsl) => {
    const { y } = glsl.vec3Param('a')
    assert.equal(typeof y.sin, 'function')
    assert.throws(() => y(1), /^WarpError: y: it takes fewer arguments/)
    assert.throws(() => y + 1, WarpError)
    return { y }
  })
})

test('the operator `in` finds swizzles that were not read before, and a swizzle cannot be assigned', () => {
  compile((glsl) => {
    const v = glsl.vec3Param('v')
    assert.ok('zxxz' in v)
    assert.ok(!('zxxzz' in v))
    assert.ok(!('xg' in v))
    assert.throws(() => {
      v.yzxy = v
    }, new WarpError('yzxy: a component cannot be changed; make a new vector, as in glsl.vec3(x, y, z).'))
    return { y: v.x }
  })
})

test('a component without parentheses can be the derivative of a function', () => {
  const bump = (glsl) =>
    glsl.fn({
      name: 'bump',
      source: 'float bump(float x) { return x; }',
      arity: 1,
      derivatives: [glsl.vec3(1, 2, 3).y],
    })
  assert.equal(
    textOf((glsl, _, x) => glsl.derivative(bump(glsl)(x), x)),
    textOf((glsl) => glsl.val(2)),
  )
})

/** The further operands of operations in the next test. Default: 2. */
const operands = {
  mix: [2, 0.25],
  clamp: [0, 1],
  ifElse: [3, 4],
}
const withoutOperands = ['neg', 'inversesqrt', 'length', 'normalize', 'fract', 'noise']

test('aliases are the same operation, as methods and as functions', () => {
  for (const [alias, name] of Object.entries(operationOfAlias)) {
    const others = withoutOperands.includes(name) ? [] : (operands[name] ?? [2])
    const isOfVectors = ['length', 'normalize'].includes(name)
    const operandOf = (a, x) => (isOfVectors ? a : x)
    const expected = textOf((_, a, x) => operandOf(a, x)[name](...others))
    assert.equal(
      textOf((_, a, x) => operandOf(a, x)[alias](...others)),
      expected,
      alias,
    )
    assert.equal(
      textOf((glsl, a, x) => glsl[alias](operandOf(a, x), ...others)),
      expected,
      `glsl.${alias}`,
    )
  }
})

test('compositions have the values of their operations', () => {
  for (const [name, expected] of Object.entries(compositions)) {
    const isOfVectors = expected.length === 3
    const program = compile((glsl) => {
      const x = isOfVectors ? glsl.vec3Param('a') : glsl.param('x')
      return { method: x[name](), called: glsl[name](x) }
    })
    for (const numbers of [
      [0.25, 2, -3],
      [-1.5, 0.5, 4],
      [3, 1, 1],
    ]) {
      const { method, called } = program.evaluate(isOfVectors ? { a: numbers } : { x: numbers[0] })
      const wanted = expected(...numbers)
      assert.ok(
        Math.abs(method - wanted) <= 1e-6 * Math.abs(wanted),
        `${name}: ${method}, not ${wanted}`,
      )
      assert.equal(called, method)
    }
  }
})

test('unknown names suggest similar ones, and properties that consoles and promises probe do not exist', async () => {
  const messageOf = (make) => {
    try {
      compileWarp(make)
    } catch (error) {
      return error.message
    }
  }
  assert.equal(
    messageOf(({ postion }) => postion),
    'An offset function gets no "postion"; did you mean position?',
  )
  assert.match(
    messageOf(({ position }) => position.sine()),
    /did you mean sin\?/,
  )
  compileWarp((inputs) => {
    for (const object of [inputs, inputs.glsl, inputs.position])
      for (const name of ['then', 'toJSON', 'nodeType', 'constructor', Symbol.iterator, '_private'])
        assert.notEqual(typeof object[name], 'string')
    assert.equal('sine' in inputs.position, false)
    return inputs.position
  })
})
