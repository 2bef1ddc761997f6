// The inputs of an offset function are made when they are first read, and appear to exist from the start.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { WarpError, compile, compileWarp } from '../../dist/warpjet.js'

/** Calls `inspect` in an offset function, with the function's inputs. */
function inOffset(inspect, options) {
  compileWarp((inputs) => {
    inspect(inputs)
    return inputs.glsl.vec3(0, 0, 0)
  }, options)
}

describe('glsl', () => {
  test('has every function as an own property, though it is made later', () =>
    inOffset(({ glsl }) => {
      const names = Object.keys(glsl)
      for (const name of ['val', 'param', 'sin', 'vec3', 'mul', 'oneMinus', 'fbm'])
        assert.ok(names.includes(name), name)
      assert.ok(!names.includes('of'), '`of`, which only front ends call, must not be enumerable')
      assert.ok('of' in glsl && Object.hasOwn(glsl, 'of'))
      assert.equal(new Set(names).size, names.length)
      assert.deepEqual(Object.keys({ ...glsl }), names)
    }))

  test('makes each function once, also for an alias', () =>
    inOffset(({ glsl }) => {
      assert.equal(glsl.sin, glsl.sin)
      assert.equal(glsl.mul, glsl.mult)
      assert.equal({ ...glsl }.sin, glsl.sin)
    }))

  test('lists the same names before and after some were read', () =>
    inOffset(({ glsl }) => {
      const before = Reflect.ownKeys(glsl)
      assert.ok(glsl.vec3 && glsl.cos)
      assert.deepEqual(Reflect.ownKeys(glsl), before)
    }))

  test('keeps assigned, defined and deleted properties as they are', () =>
    inOffset(({ glsl }) => {
      const replacement = () => 1
      glsl.sin = replacement
      assert.equal(glsl.sin, replacement)
      Object.defineProperty(glsl, 'cos', { value: replacement })
      assert.equal(glsl.cos, replacement)
      delete glsl.tan
      assert.ok(!Object.keys(glsl).includes('tan'))
      assert.throws(() => glsl.tan, WarpError)
      inOffset(({ glsl }) => assert.notEqual(glsl.sin, replacement))
    }))

  test('throws for an unknown name', () =>
    inOffset(({ glsl }) => {
      assert.throws(() => glsl.sine, /glsl\.sine: there is no such function; did you mean/)
      assert.equal('sine' in glsl, false)
    }))
})

describe('the inputs of an offset function', () => {
  test('are the same expression each time they are read, in a fixed order', () =>
    inOffset((inputs) => {
      assert.equal(inputs.position, inputs.position)
      assert.equal(inputs.mouseX, { ...inputs }.mouseX)
      const names = Object.keys(inputs)
      assert.deepEqual(names.slice(0, 3), ['glsl', 'position', 'normal'])
      assert.deepEqual(names.slice(-5), ['mouseX', 'mouseY', 'width', 'height', 'uniforms'])
      assert.ok(!names.includes('tangent') && !('tangent' in inputs))
      assert.throws(() => inputs.time, /An offset function gets no "time"/)
    }))

  test('include the uniforms of the option `uniforms`', () =>
    inOffset(
      ({ uniforms, ...others }) => {
        assert.deepEqual(Object.keys(uniforms), ['amount'])
        assert.ok(!('uniforms' in others) && 'position' in others)
      },
      { uniforms: { amount: 0.5 } },
    ))
})

test('a string that is not ASCII reaches the wasm unchanged', () => {
  const name = 'größe🙂'
  assert.throws(
    () => compile((glsl) => ({ y: glsl.param(name) })),
    (error) => error instanceof WarpError && error.message.includes('größe'),
  )
  assert.throws(() => compile((glsl) => ({ [name]: glsl.val(1) })), /größe🙂/)
})
