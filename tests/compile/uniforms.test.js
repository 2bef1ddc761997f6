// The option `uniforms` of compileWarp: types follow from values, and values are used on the CPU.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile, compileWarp } from 'warpjet'
import { bakeWarp, subdivide } from 'warpjet/mesh'
import { throwWarpErrors, throwsWarpError } from '../support/warp-errors.js'

const origin = [0, 0, 0]

/** Returns the position to which a warp moves the origin. */
const movedTo = (offset, uniforms, callUniforms) =>
  compileWarp(offset, { uniforms }).evaluateAt(origin, { uniforms: callUniforms }).position

const readValue = ({ glsl, uniforms }) => glsl.vec3(uniforms.value, 0, 0)
const declare = (value) => compileWarp(readValue, { uniforms: { value } })

describe('types follow from the values:', () => {
  test('a number, true and false are floats', () => {
    const offset = ({ glsl, uniforms: { a, b, c } }) => glsl.vec3(a, b, c.add(4))
    assert.deepEqual(movedTo(offset, { a: 0.5, b: true, c: false }), [0.5, 1, 4])
  })

  test('arrays, typed ones too, are vectors', () => {
    const offset = ({ glsl, uniforms: { a, b, c } }) =>
      glsl.vec3(a.y(), b.z(), c.w().add(a.x(), b.x(), c.x()))
    const uniforms = { a: [1, 2], b: new Float32Array([3, 4, 5]), c: [6, 7, 8, 9] }
    assert.deepEqual(movedTo(offset, uniforms), [2, 5, 9 + 1 + 3 + 6])
  })

  test('9 and 16 numbers are matrices, column by column', () => {
    const offset = ({ glsl, uniforms: { turn, place } }) =>
      turn.mult(glsl.vec3(1, 10, 100)).add(place.mult(glsl.vec4(0, 0, 0, 1)).xyz())
    const uniforms = {
      turn: [1, 2, 3, 4, 5, 6, 7, 8, 9],
      place: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1000, 2000, 3000, 1],
    }
    assert.deepEqual(movedTo(offset, uniforms), [1741, 2852, 3963])
  })

  test('vectors of p5 are vec3s, colors of p5 are vec4s, and a smaller uniform takes the first components of either', () => {
    const vector = { x: 1, y: 2, z: 3 }
    const color = { _array: [0.5, 0.25, 0, 1] }
    const offset = ({ uniforms: { v, c } }) => v.add(c.xyz().mult(c.w()))
    assert.deepEqual(movedTo(offset, { v: vector, c: color }), [1.5, 2.25, 3])
    const flat = ({ glsl, uniforms: { a, b } }) => b.add(glsl.vec3(a, 0))
    const callUniforms = { a: vector, b: color }
    assert.deepEqual(movedTo(flat, { a: [0, 0], b: [0, 0, 0] }, callUniforms), [1.5, 2.25, 0])
  })

  test('uniforms that the code reads are listed, and each is read by its own name', () => {
    const warp = compileWarp(
      ({ glsl, millis, uniforms }) => glsl.vec3(uniforms.wind, millis.mult(uniforms.amount)),
      { uniforms: { amount: 1, unused: 2, wind: [1, 0] } },
    )
    const types = Object.fromEntries(warp.uniforms.map(({ name, type }) => [name, type]))
    assert.deepEqual(types, { amount: 'float', millis: 'float', wind: 'vec2' })
    assert.match(warp.code, /\bwind\b/)
    assert.match(warp.code, /\bamount \* millis|millis \* amount\b/)
    assert.doesNotMatch(warp.code, /unused/)
  })

  test('glsl.param reads the same uniform', () => {
    const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.a.sub(glsl.param('a')), 1, 0)
    const warp = compileWarp(offset, { uniforms: { a: 3 } })
    assert.deepEqual(warp.uniforms, [])
  })
})

describe('uniforms and inherited properties:', () => {
  const names = ['constructor', 'toString', 'hasOwnProperty', 'valueOf']

  test('a uniform named like a property of Object is read if it is declared or passed', () => {
    for (const name of names) {
      const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms[name], 0, 0)
      assert.deepEqual(movedTo(offset, { [name]: 2 }), [2, 0, 0], name)
      assert.deepEqual(movedTo(offset, { [name]: () => 2 }), [2, 0, 0], name)
      assert.deepEqual(movedTo(offset, { [name]: 2 }, { [name]: 3 }), [3, 0, 0], name)
    }
  })

  test('uniforms are read from objects without a prototype', () => {
    const bare = (entries) => Object.assign(Object.create(null), entries)
    const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.toString, uniforms.reach, 0)
    const declared = bare({ toString: 2, reach: 5 })
    assert.deepEqual(movedTo(offset, declared), [2, 5, 0])
    assert.deepEqual(movedTo(offset, declared, bare({ toString: 3 })), [3, 5, 0])
  })

  test('an inherited property neither declares nor passes a uniform', () => {
    const inheriting = Object.create({ amount: 1 })
    inheriting.reach = 5
    throwsWarpError(
      () => movedTo(({ glsl, uniforms }) => glsl.vec3(uniforms.amount, 0, 0), inheriting),
      /amount/,
    )
    const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.reach, 0, 0)
    assert.deepEqual(movedTo(offset, inheriting), [5, 0, 0])
    assert.deepEqual(movedTo(offset, { reach: 5 }, Object.create({ reach: 7 })), [5, 0, 0])
  })

  test('__proto__ is an ordinary key, but not a valid name in a shader', () => {
    const uniforms = JSON.parse('{ "__proto__": 1 }')
    throwsWarpError(
      () => compileWarp(({ glsl, uniforms }) => glsl.vec3(uniforms['__proto__']), { uniforms }),
      /"__proto__" cannot be read in a shader: .* two consecutive underscores/,
    )
    const warp = compileWarp(({ position }) => position, { uniforms })
    assert.deepEqual(warp.evaluateAt([1, 2, 3], { uniforms }).position, [2, 4, 6])
    throwsWarpError(
      () => compileWarp(({ position }) => position).evaluateAt(origin, { uniforms }),
      /the warp has no uniform "__proto__"/,
    )
  })
})

describe('on the CPU', () => {
  test('a passed value replaces the declared one, for that call', () => {
    const warp = declare(0.5)
    const x = (uniforms) => warp.evaluateAt(origin, { uniforms }).position[0]
    assert.deepEqual([x(), x({ value: 2 }), x({}), x({ value: true })], [0.5, 2, 0.5, 1])
  })

  test('every method accepts uniforms', () => {
    const warp = compileWarp(({ position, uniforms }) => position.mult(uniforms.grow), {
      uniforms: { grow: 1 },
    })
    const mesh = { positions: [1, 0, 0, 0, 1, 0, 0, 0, 2], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1] }
    const box = { min: [0, 0, 0], max: [1, 1, 1] }
    const twice = [2, 0, 0, 0, 2, 0, 0, 0, 4]
    const thrice = [3, 0, 0, 0, 3, 0, 0, 0, 6]
    assert.deepEqual([...warp.evaluate(mesh).positions], twice)
    assert.deepEqual([...warp.evaluate(mesh, { uniforms: { grow: 2 } }).positions], thrice)
    const [x, grown] = [warp.bounds(box), warp.bounds(box, { uniforms: { grow: 2 } })].map(
      ({ max }) => max[0],
    )
    assert.ok(x >= 2 && x < 2.001 && grown >= 3 && grown < 3.001, `${x}, ${grown}`)
    assert.equal(warp.foldover(mesh).count, 0)
    assert.equal(warp.foldover(mesh, { uniforms: { grow: -3 } }).count, 3)
    assert.deepEqual([...bakeWarp(mesh, warp).positions], twice)
    assert.deepEqual([...bakeWarp(mesh, warp, { uniforms: { grow: 2 } }).positions], thrice)
  })

  test('a function is called once for its type, then at every use, but not if a value is passed', () => {
    let calls = 0
    const warp = declare(() => ++calls)
    assert.equal(calls, 1)
    const x = (uniforms) => warp.evaluateAt(origin, { uniforms }).position[0]
    assert.deepEqual([x(), x(), x({ value: 9 }), x()], [2, 3, 9, 4])
    assert.equal(calls, 4)
  })

  test('a function that the warp does not read is not called again', () => {
    let calls = 0
    const count = () => ++calls
    const warp = compileWarp(({ position }) => position, { uniforms: { count } })
    warp.evaluateAt(origin)
    assert.equal(calls, 1)
    assert.deepEqual(warp.evaluateAt([1, 2, 3], { uniforms: { count: 7 } }).position, [2, 4, 6])
  })

  test('an array is copied, and arguments are unchanged', () => {
    const value = [1, 2, 3]
    const warp = compileWarp(({ uniforms }) => uniforms.value, { uniforms: { value } })
    value[0] = 100
    const callUniforms = Object.freeze({ value: Object.freeze([4, 5, 6]) })
    assert.deepEqual(warp.evaluateAt(origin).position, [1, 2, 3])
    assert.deepEqual(warp.evaluateAt(origin, { uniforms: callUniforms }).position, [4, 5, 6])
    assert.deepEqual(value, [100, 2, 3])
  })

  test('a subdivision calls a function once, so that all vertices agree', () => {
    const plane = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1] }
    let calls = 0
    const options = { uniforms: { value: () => ++calls } }
    const offset = ({ glsl, position, uniforms }) =>
      glsl.vec3(0, 0, position.x().mult(3).add(uniforms.value).sin())
    const fine = subdivide(plane, { warp: compileWarp(offset, options), tolerance: 0.01 })
    assert.ok(fine.positions.length > 30)
    assert.equal(calls, 2)
    const callUniforms = { value: 2 }
    const same = subdivide(plane, {
      warp: compileWarp(offset, options),
      uniforms: callUniforms,
      tolerance: 0.01,
    })
    assert.deepEqual(same.positions, fine.positions)
    assert.equal(calls, 3)
  })
})

describe('throws for', () => {
  test('an invalid option `uniforms`', () => {
    const option = (uniforms) => () => compileWarp(({ position }) => position, { uniforms })
    throwWarpErrors([
      [
        option(3),
        /expected an object, such as \{ amount: .*for the option "uniforms", got the number 3/,
      ],
      [option([1, 2]), /expected an object, .* got an array of 2/],
      [option(null), /expected an object, .* got null/],
    ])
  })

  test('an invalid value', () => {
    const cases = [
      ['red', /expected a number, .* for the uniform "value", got the text "red"/],
      [undefined, /expected a number, .* for the uniform "value", got undefined/],
      [[1], /got an array of 1\./],
      [[1, 2, 3, 4, 5], /expected .* an array of 2, 3, 4, 9 or 16 numbers, .* got an array of 5/],
      [{ a: 1 }, /got an object\./],
      [
        () => undefined,
        /a function that returns one of them, .* got a function that returns undefined/,
      ],
      [async () => 1, /got a function that returns a promise/],
      [NaN, /expected a finite number for the uniform "value", got NaN/],
      [[1, Infinity], /expected an array of 2 finite numbers .* got one with Infinity/],
      [[1, 'a', 2], /expected an array of 3 finite numbers .* got one with the text "a"/],
      [[1, , 2], /got one with undefined/],
      [() => [0, NaN], /got one with NaN/],
    ]
    for (const [value, message] of cases) throwsWarpError(() => declare(value), message)
  })

  test('an invalid name', () => {
    const compileNamed = (name, names) => () =>
      compileWarp(({ glsl, uniforms }) => glsl.vec3(uniforms[name]), {
        uniforms: { [name]: 1 },
        names,
      })
    throwWarpErrors([
      [compileNamed('millis'), /uniform "millis" has the name of an input; .* such as "myMillis"/],
      [compileNamed('position'), /uniform "position" has the name of an input/],
      [
        compileNamed('uTime', { millis: 'uTime' }),
        /the name that the option "names" gives to millis/,
      ],
      [compileNamed('float'), /^compileWarp uniforms\.float: "float" cannot be read in a shader/],
      [compileNamed('offset'), /"offset" has the name of a variable .* read/],
    ])
    assert.deepEqual(compileNamed('toString')().uniforms, [{ name: 'toString', type: 'float' }])
  })

  test('reading an undeclared uniform, and writing a uniform', () => {
    const readUndeclared = (uniforms) => () =>
      compileWarp(({ glsl, uniforms: { amont } }) => glsl.vec3(amont), { uniforms })
    throwWarpErrors([
      [
        readUndeclared({ amount: 1, wind: [1, 0] }),
        /declares no "amont"; it declares amount, wind\./,
      ],
      [readUndeclared({}), /nothing declares; add the option \{ uniforms: \{ amont: 0\.5 \} \}/],
      [readUndeclared(), /^compileWarp: the offset reads uniforms\.amont, which nothing declares/],
    ])
    const writing = ({ uniforms, position }) => {
      uniforms.amount = 3
      return position
    }
    throwsWarpError(
      () => compileWarp(writing, { uniforms: { amount: 1 } }),
      /uniforms\.amount cannot be set/,
    )
  })

  test('invalid values passed in a call', () => {
    const warp = compileWarp(({ uniforms }) => uniforms.center.mult(uniforms.amount), {
      uniforms: { center: [0, 0, 0], amount: 1, unread: [1, 2] },
    })
    const call = (uniforms) => () => warp.evaluateAt(origin, { uniforms })
    throwWarpErrors([
      [
        call({ amount: [1, 2] }),
        /expected a finite number for the uniform "amount", got an array of 2/,
      ],
      [call({ amount: 'a' }), /expected a finite number .* got the text "a"/],
      [call({ amount: () => 3 }), /expected a finite number .* got a function/],
      [
        call({ center: 3 }),
        /expected an array of 3 finite numbers for the uniform "center", got the number 3/,
      ],
      [call({ center: [1, NaN, 2] }), /for the uniform "center", got one with NaN/],
      [call({ unread: 1 }), /expected an array of 2 finite numbers for the uniform "unread"/],
      [call({ centre: [1, 2, 3] }), /no uniform "centre"; it has .*center, amount, unread/],
    ])
  })

  test('missing parameters named like properties of Object', () => {
    const offset = ({ glsl }) => glsl.vec3(glsl.param('toString'), glsl.param('constructor'), 0)
    const warp = compileWarp(offset)
    const call = (uniforms) => () => warp.evaluateAt(origin, { uniforms })
    throwsWarpError(call(), /the warp reads "toString"; pass a value/)
    throwsWarpError(call({ toString: 1 }), /the warp reads "constructor"; pass a value/)
    assert.deepEqual(call({ toString: 1, constructor: 2 })().position, [1, 2, 0])
    const { evaluate } = compile((glsl) => ({ y: glsl.param('toString').mult(2) }))
    throwsWarpError(
      () => evaluate({}),
      /^evaluate: expected a finite number for "toString", got undefined/,
    )
    assert.deepEqual(evaluate({ toString: 2 }), { y: 4 })
  })

  test('parameters named like an input that is renamed in the shader', () => {
    const offset = ({ glsl, millis }) => glsl.vec3(glsl.param('millis').mult(millis), 0, 0)
    throwsWarpError(
      () => compileWarp(offset, { names: { millis: 'uTime' } }),
      /^compileWarp: the shader has a variable "millis", but .* millis as "uTime"; rename the variable/,
    )
    const alone = ({ glsl }) => glsl.vec3(glsl.param('millis'), 0, 0)
    assert.deepEqual(compileWarp(alone, { names: { millis: 'uTime' } }).uniforms, [
      { name: 'millis', type: 'float' },
    ])
  })

  test('a function that changes its type', () => {
    let now = 1
    const warp = declare(() => now)
    now = [1, 2]
    throwsWarpError(
      () => warp.evaluateAt(origin),
      /^evaluateAt: expected a finite number for the uniform "value", got an array of 2; its function must always return a value of the same type as at first\./,
    )
    now = undefined
    throwsWarpError(
      () => warp.bounds({ min: origin, max: origin }),
      /^bounds: .* got undefined; its function must always return/,
    )
    now = NaN
    throwsWarpError(() => warp.evaluateAt(origin), /for the uniform "value", got NaN/)
  })
})
