// Tests the results of warps on the CPU, and which arrays they read and write. tests/compile/normals.browser.test.js compares all numbers
// with an oracle, and with those of the GPU.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { compileWarp } from '../../dist/warpjet.js'

const wave = compileWarp(({ glsl, position, millis }) =>
  glsl.vec3(0, position.x().mult(3).add(millis.div(500)).sin().mult(0.2), 0),
)
const uniforms = { millis: 250 }
const plane = { positions: [0, 0, 0, 1, 0, 0], normals: [0, 1, 0, 0, 1, 0] }

describe('evaluate', () => {
  test('returns float32 arrays and leaves its arguments unchanged', () => {
    const mesh = {
      positions: new Float32Array(plane.positions),
      normals: Object.freeze([...plane.normals]),
    }
    const { positions, normals } = wave.evaluate(mesh, { uniforms })
    assert.ok(positions instanceof Float32Array && normals instanceof Float32Array)
    assert.deepEqual([...mesh.positions], plane.positions)
    assert.ok(Math.abs(positions[4] - 0.2 * Math.sin(3.5)) < 1e-7)
    assert.equal(positions[3], 1)
  })

  test('writes into arrays of the caller, also into its own input', () => {
    const { positions, normals } = wave.evaluate(plane, { uniforms })
    const out = { positions: new Float32Array(9).fill(7), normals: new Float32Array(6) }
    const result = wave.evaluate(plane, { uniforms, out })
    assert.equal(result.positions, out.positions)
    assert.equal(result.normals, out.normals)
    assert.deepEqual(result.positions, Float32Array.of(...positions, 7, 7, 7))
    assert.deepEqual(result.normals, normals)
    const inPlace = {
      positions: new Float32Array(plane.positions),
      normals: new Float32Array(plane.normals),
    }
    wave.evaluate(inPlace, { uniforms, out: inPlace })
    assert.deepEqual(inPlace, { positions, normals })
    const expectRejected = (wrong, message) =>
      assert.throws(() => wave.evaluate(plane, { uniforms, out: wrong }), {
        name: 'WarpError',
        message,
      })
    expectRejected(
      { positions: new Float32Array(5) },
      /at least 6 numbers for out\.positions, got one of 5/,
    )
    expectRejected(
      { normals: [0, 0, 0] },
      /expected a Float32Array .* for out\.normals, got an array of 3/,
    )
    expectRejected({ normal: new Float32Array(6) }, /normal/)
  })

  test('allocates no array of the size of the mesh if all are passed', () => {
    const count = 3 * 10_000
    const mesh = { positions: new Float32Array(count), normals: new Float32Array(count) }
    const out = { positions: new Float32Array(count), normals: new Float32Array(count) }
    const largestAllocation = (options) => {
      const OriginalArray = Float32Array
      const lengths = []
      const construct = (target, from) => {
        const allocated = Reflect.construct(target, from)
        if (typeof from[0] === 'number') lengths.push(allocated.length)
        return allocated
      }
      globalThis.Float32Array = new Proxy(OriginalArray, { construct })
      try {
        wave.evaluate(mesh, options)
      } finally {
        globalThis.Float32Array = OriginalArray
      }
      return Math.max(0, ...lengths)
    }
    assert.equal(largestAllocation({ uniforms }), count)
    for (let i = 0; i < 3; i++) assert.ok(largestAllocation({ uniforms, out }) < 1000)
  })

  test('checks a Float32Array when it is passed for the first time, and none of its own results', () => {
    const notFinite = {
      name: 'WarpError',
      message: /expected a finite number for positions\[0\].*, got NaN/,
    }
    const positions = Float32Array.of(NaN, 0, 0)
    assert.throws(() => wave.evaluate({ positions }, { uniforms }), notFinite)
    assert.throws(() => wave.evaluate({ positions }, { uniforms }), notFinite)
    positions[0] = 1
    const { positions: result } = wave.evaluate({ positions }, { uniforms })
    for (const array of [positions, result]) {
      array[0] = NaN
      assert.ok(Number.isNaN(wave.evaluate({ positions: array }, { uniforms }).positions[0]))
    }
    const list = [1, 0, 0]
    wave.evaluate({ positions: list }, { uniforms })
    list[0] = NaN
    assert.throws(() => wave.evaluate({ positions: list }, { uniforms }), notFinite)
  })

  test('accepts any number of vertices, including 0', () => {
    assert.deepEqual(wave.evaluate({ positions: [], normals: [] }, { uniforms }), {
      positions: new Float32Array(0),
      normals: new Float32Array(0),
    })
    // Counts just below and above the number of vertices per batch.
    for (const count of [1, 5, 4095, 4096, 4097, 9001]) {
      const xs = Float32Array.from({ length: count }, (_, i) => Math.sin(i))
      const positions = Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 ? 0 : xs[i / 3]))
      const normals = Float32Array.from({ length: 3 * count }, (_, i) => Number(i % 3 === 1))
      const moved = wave.evaluate({ positions, normals }, { uniforms })
      assert.equal(moved.positions.length, 3 * count)
      for (let i = 0; i < count; i += 97) {
        const one = wave.evaluateAt([xs[i], 0, 0], { normal: [0, 1, 0], uniforms })
        assert.deepEqual([...moved.positions.subarray(3 * i, 3 * i + 3)], one.position)
        assert.deepEqual([...moved.normals.subarray(3 * i, 3 * i + 3)], one.normal)
      }
      assert.equal(
        moved.positions.at(-2),
        wave.evaluateAt([xs.at(-1), 0, 0], { uniforms }).position[1],
      )
    }
  })

  test('returns normals only if normals were passed, and tangents if both were passed', () => {
    const keys = (mesh) => Object.keys(wave.evaluate(mesh, { uniforms }))
    const { positions, normals } = plane
    const tangents = [1, 0, 0, 1, 1, 0, 0, -1]
    assert.deepEqual(keys({ positions }), ['positions'])
    assert.deepEqual(keys({ positions, tangents }), ['positions'])
    assert.deepEqual(keys({ positions, normals, tangents }), ['positions', 'normals', 'tangents'])
    assert.deepEqual(Object.keys(wave.evaluateAt([1, 2, 3], { uniforms })), ['position'])
    const bare = compileWarp(({ position }) => position, { normals: false })
    assert.deepEqual(Object.keys(bare.evaluate({ positions, normals })), ['positions'])
  })

  test('transforms tangents with the surface: y = 0.2 sin(3x + t) has the slope 0.6 cos(3x + t)', () => {
    const { normals, tangents } = wave.evaluate(
      { ...plane, tangents: [1, 0, 0, 1, 0, 0, 2, -1] },
      { uniforms },
    )
    const slope = 0.6 * Math.cos(0.5)
    const length = Math.hypot(1, slope)
    const expected = [1 / length, slope / length, 0, 1, 0, 0, 1, -1]
    expected.forEach((x, i) => assert.ok(Math.abs(tangents[i] - x) < 1e-6, `${i}: ${tangents[i]}`))
    for (const i of [0, 1]) {
      const [n, t] = [normals.subarray(3 * i, 3 * i + 3), tangents.subarray(4 * i, 4 * i + 3)]
      assert.ok(Math.abs(n[0] * t[0] + n[1] * t[1] + n[2] * t[2]) < 1e-6)
    }
  })

  test('finds inputs by the names of the warp, whatever their names in the shader', () => {
    const renamed = compileWarp(
      ({ glsl, position, millis, uv, mouseX }) =>
        position
          .mult(millis)
          .add(glsl.vec3(uv, mouseX))
          .add(glsl.mat3Param('turn').mult(position))
          .mult(glsl.param('amount')),
      { names: { position: 'aPosition', millis: 'uTime', mouse: 'uMouse.xy' } },
    )
    const turn = [0, 1, 0, -1, 0, 0, 0, 0, 1]
    const { position } = renamed.evaluateAt([1, 2, 3], {
      uv: [10, 20],
      uniforms: { millis: 2, mouse: [30, 40], amount: 0.5, turn },
    })
    const moved = [2 + 10 - 2, 4 + 20 + 1, 6 + 30 + 3]
    assert.deepEqual(
      position,
      [1, 2, 3].map((x, i) => x + moved[i] / 2),
    )
  })

  test('leaves no memory behind: a thousand calls need as much as one', () => {
    const before = process.memoryUsage().arrayBuffers
    const positions = new Float32Array(3 * 5000)
    for (let i = 0; i < 1000; i++) wave.evaluate({ positions }, { uniforms })
    global.gc?.()
    assert.ok(process.memoryUsage().arrayBuffers - before < 100e6)
  })
})

describe('foldover', () => {
  test('marks vertices where det(I + J) <= 0', () => {
    // x -> x + 2 sin(x) has the derivative 1 + 2 cos(x).
    const folded = compileWarp(({ glsl, position }) => glsl.vec3(position.x().sin().mult(2), 0, 0))
    const xs = Array.from({ length: 1000 }, (_, i) => i / 100)
    const { mask, count } = folded.foldover({ positions: xs.flatMap((x) => [x, 5, -7]) })
    const expected = xs.map((x) => Number(1 + 2 * Math.cos(x) <= 0))
    assert.deepEqual([...mask], expected)
    assert.equal(count, expected.filter(Boolean).length)
    assert.ok(mask instanceof Uint8Array)
  })

  test('a mirror is inside out everywhere, and so is a flattened surface', () => {
    const positions = [1, 2, 3, 4, 5, 6]
    const count = (warp) => compileWarp(warp).foldover({ positions }).count
    assert.equal(
      count(({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0)),
      2,
    )
    assert.equal(
      count(({ glsl, position }) => glsl.vec3(position.x().neg(), 0, 0)),
      2,
    )
    assert.equal(
      count(({ glsl }) => glsl.vec3(1, 2, 3)),
      0,
    )
    assert.equal(wave.foldover({ positions: [] }, { uniforms }).count, 0)
  })
})

describe('inputs and results that share memory', () => {
  const bend = compileWarp(({ glsl, position }) =>
    glsl.vec3(position.y.mult(0.5), position.x.sin(), position.z.mult(position.x)),
  )
  const count = 10_000
  const values = Float32Array.from({ length: 4 * count }, (_, i) => Math.sin(1.7 * i))
  const normals = Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 1 ? 1 : 0))
  const tangents = Float32Array.from({ length: 4 * count }, (_, i) =>
    Number(i % 4 === 0 || i % 4 === 3),
  )
  const positions = values.slice(0, 3 * count)
  const expected = bend.evaluate({ positions, normals, tangents })

  /** Makes a Float32Array of `numbers` in a buffer, which starts `at` floats after the start of the buffer. */
  function arrayInBuffer(buffer, at, numbers) {
    const view = new Float32Array(buffer, 4 * at, numbers.length)
    view.set(numbers)
    return view
  }

  test('do not change the result, wherever it is in memory', () => {
    for (let run = 0; run < 3; run++)
      for (const shift of [
        -30_001, -12_288, -3, -1, 0, 1, 2, 3, 4, 12_287, 12_288, 15_000, 29_999, 30_000,
      ]) {
        const buffer = new ArrayBuffer(4 * 100_000)
        const input = arrayInBuffer(buffer, 40_000, positions)
        const out = { positions: new Float32Array(buffer, 4 * (40_000 + shift), 3 * count) }
        const { positions: moved } = bend.evaluate({ positions: input }, { out })
        assert.deepEqual(moved, expected.positions, `by ${shift}`)
      }
  })

  test('do not change the result if normals overlap positions, or tangents overlap normals, or arrays are Float64Array', () => {
    for (const shift of [-9000, -1, 0, 1, 5000]) {
      const buffer = new ArrayBuffer(4 * 200_000)
      const mesh = {
        positions: arrayInBuffer(buffer, 50_000, positions),
        normals: arrayInBuffer(buffer, 90_000, normals),
        tangents: arrayInBuffer(buffer, 130_000, tangents),
      }
      const at = (offset, size) => new Float32Array(buffer, 4 * (offset + shift), size * count)
      const out = { positions: at(130_000, 3), normals: at(50_000, 3), tangents: at(90_000, 4) }
      assert.deepEqual(bend.evaluate(mesh, { out }), expected, `by ${shift}`)
    }
    const buffer = new ArrayBuffer(8 * 40_000)
    for (const shift of [0, 8, 60_000, 120_000]) {
      const doubles = new Float64Array(buffer, 0, 3 * count)
      doubles.set(positions)
      const out = { positions: new Float32Array(buffer, shift, 3 * count) }
      assert.deepEqual(bend.evaluate({ positions: doubles }, { out }).positions, expected.positions)
    }
  })

  test('two results must not share memory', () => {
    const same = new Float32Array(4 * count)
    const expectRejected = (out, message) =>
      assert.throws(() => bend.evaluate({ positions, normals, tangents }, { out }), {
        name: 'WarpError',
        message,
      })
    expectRejected(
      { positions: same, normals: same },
      /^evaluate: out\.positions and out\.normals must not share memory, but are the same array\.$/,
    )
    expectRejected(
      { normals: same, tangents: same },
      /out\.normals and out\.tangents .* same array/,
    )
    const buffer = new ArrayBuffer(4 * 80_000)
    const at = (place) => new Float32Array(buffer, 4 * place)
    expectRejected(
      { positions: at(0), tangents: at(3 * count - 1) },
      /out\.positions and out\.tangents .* same part of a buffer/,
    )
    expectRejected(
      { positions: at(3 * count - 1), normals: at(0) },
      /out\.positions and out\.normals/,
    )
    // Adjacent arrays are allowed, and so are arrays that are not written.
    const out = { positions: at(0), normals: at(3 * count) }
    assert.deepEqual(
      bend.evaluate({ positions, normals }, { out }).normals.slice(0, 3 * count),
      expected.normals,
    )
    assert.equal(
      bend.evaluate({ positions }, { out: { positions: same, normals: same } }).positions,
      same,
    )
  })
})

describe('unused uniforms', () => {
  const box = { min: [0, 0, 0], max: [1, 1, 1] }
  const mesh = { positions: [1, 2, 3] }
  /** Calls each method with these uniforms. */
  function callAll(warp, uniforms) {
    warp.evaluate(mesh, { uniforms })
    warp.evaluateAt([1, 2, 3], { uniforms })
    warp.bounds(box, { uniforms })
    warp.foldover(mesh, { uniforms })
    warp.inverseAt([1, 2, 3], { uniforms })
    warp.frameUniforms(uniforms)
  }
  const sources = [
    'return p;',
    'float k = amount * 2.0; return p;',
    'float k = amount * 2.0; k = 1.0; return p * k;',
    'if (false) return p * amount; return p;',
    'return vec3(p.xy, amount).xxy;',
    'return p * (amount - amount);',
    'return p * pow(amount, 0.0);',
  ]
  for (const perFrame of [false, true])
    test(`may be passed, ${perFrame ? 'with' : 'without'} frame constants`, () => {
      for (const body of sources) {
        const offset = glslOffset(`uniform float amount;\nvec3 offset(vec3 p) { ${body} }`)
        for (const declared of [{}, { uniforms: { amount: 2 } }]) {
          const warp = compileWarp(offset, { perFrame, ...declared })
          callAll(warp, { amount: 3 })
          assert.throws(() => warp.evaluateAt([1, 2, 3], { uniforms: { amout: 3 } }), /"amout"/)
          assert.throws(
            () => warp.evaluateAt([1, 2, 3], { uniforms: { amount: [1, 2] } }),
            /"amount"/,
          )
          if (declared.uniforms || !body.includes('amount')) callAll(warp, {})
        }
      }
      const built = compileWarp(
        ({ position, uniforms: { amount, center }, glsl }) =>
          position
            .mult(amount.sub(amount))
            .add(position.sub(center).mult(0), glsl.param('other').mult(0)),
        { perFrame, uniforms: { amount: 1, center: [1, 2, 3] } },
      )
      callAll(built, { amount: 3, center: { x: 1, y: 2, z: 3 }, other: 5, millis: 7 })
      callAll(built, {})
    })

  test('may have every type that GLSL source can declare', () => {
    const types = {
      int: -3,
      uint: 3e9,
      bool: true,
      vec3: [1, 2, 3],
      ivec2: [1, -2],
      mat3: Array(9).fill(1),
    }
    for (const [type, value] of Object.entries(types)) {
      const source = `#version 300 es\nuniform ${type} amount; uniform sampler2D image; vec3 offset(vec3 p) { return p; }`
      callAll(compileWarp(glslOffset(source)), { amount: value })
    }
  })
})
