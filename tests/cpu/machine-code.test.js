// Warps compiled to machine code on the CPU return the same bits as the interpreter, which handles the first call; and unused code is
// freed. NaNs may differ in their bits, which WebAssembly does not define.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { setTimeout } from 'node:timers/promises'
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { noises, propertiesOf } from '../operations/noise.js'

setFlagsFromString('--expose-gc')
const collect = runInNewContext('gc')

let moduleCount = 0
const { Module } = WebAssembly
WebAssembly.Module = function (bytes) {
  moduleCount++
  return new Module(bytes)
}

const { compileWarp } = await import('../../dist/warpjet.js')
await import('../../dist/glsl.js')
const { evaluationMemoryInUse } = await import('../../dist/memory.js')
const { sharedDeclarations, randomFunction } = await import('../glsl/generate.js')
const { moments } = await import('../support/browser/compare.js')
const { seededRandom } = await import('../warps/random.js')
const { warps } = await import('../warps/index.js')

const sizes = {
  positions: 3,
  normals: 3,
  uvs: 2,
  colors: 4,
  tangents: 4,
  normalXGradients: 3,
  normalYGradients: 3,
  normalZGradients: 3,
  uGradients: 3,
  vGradients: 3,
}

function meshOf(vertices, numberAt) {
  const entries = Object.entries(sizes).map(([name, size], array) => [
    name,
    Float32Array.from({ length: size * vertices }, (_, i) => numberAt(i, array)),
  ])
  return Object.fromEntries(entries)
}

const random = seededRandom(7)
const ordinary = meshOf(1000, () => 2 * random() - 1)

/**
 * Numbers at which formulas switch between cases: zeros, denormals, the limits of float32, and arguments too large for the formula of a
 * sine.
 */
const extremes = [
  0,
  -0,
  1,
  -1,
  0.5,
  1.5,
  -2.5,
  1e-45,
  -1e-39,
  1e-20,
  3e38,
  -3e38,
  1e10,
  12799.9,
  12800.1,
  -99999,
  1048577,
  3,
  -7,
  88.8,
  -104,
  2 ** 24,
  0.999999,
  4091,
  16777217,
]
const extreme = meshOf(extremes.length ** 2, (i, array) => {
  const vertex = Math.floor(i / 3)
  const [first, second] = [vertex % extremes.length, Math.floor(vertex / extremes.length)]
  return extremes[[first, second, first + second + array][i % 3] % extremes.length]
})

const firstVertices = (mesh, vertices) =>
  Object.fromEntries(
    Object.entries(mesh).map(([name, all]) => [name, all.subarray(0, vertices * sizes[name])]),
  )

const bits = (floats) => new Uint32Array(floats.buffer, floats.byteOffset, floats.length)

function assertSame(actual, expected, message) {
  for (const [name, floats] of Object.entries(actual)) {
    const [a, b] = [bits(floats), bits(expected[name])]
    for (let i = 0; i < a.length; i++)
      if (a[i] !== b[i] && !(Number.isNaN(floats[i]) && Number.isNaN(expected[name][i])))
        assert.fail(`${message}: ${name}[${i}] is ${floats[i]}, not ${expected[name][i]}`)
  }
}

/**
 * Evaluates a new warp with the interpreter, then with machine code for each number of vertices in `counts`; all must return the same bits.
 */
function assertBothSame(warp, mesh, uniforms, counts, message) {
  const expected = warp.evaluate(mesh, { uniforms })
  const before = moduleCount
  for (const count of counts)
    assertSame(
      warp.evaluate(firstVertices(mesh, count), { uniforms }),
      expected,
      `${message}, ${count}`,
    )
  assert.equal(moduleCount, before + 1, `${message}: expected one module`)
}

const counts = [1, 3, 5, 17, 1000]

describe('machine code returns the same bits as the interpreter', () => {
  test('for every warp of the tests', () => {
    let compared = 0
    for (const { name, compile, params } of warps) {
      const warp = compile('glsl300')
      if (!warp.evaluate) continue
      assertBothSame(warp, ordinary, { ...moments[1], ...params }, counts, name)
      assertSame(
        warp.evaluate(ordinary, { uniforms: { ...moments[2], ...params } }),
        compile('glsl300').evaluate(ordinary, { uniforms: { ...moments[2], ...params } }),
        `${name}, later`,
      )
      compared++
    }
    assert.ok(compared > 60, `${compared} warps`)
  })

  const unary =
    'neg sqrt inversesqrt exp exp2 log log2 sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh abs sign floor ceil round trunc fract not'
  const binary = 'add sub mult div pow atan mod min max step lt le gt ge eq ne and or'
  const ternary = 'clamp mix ifElse smoothstep'
  for (const [list, arity] of [
    [unary, 1],
    [binary, 2],
    [ternary, 3],
    [noises.join(' '), 0],
  ])
    for (const name of list.split(' '))
      for (const isUniform of arity ? [false, true] : [false])
        test(`for ${name} of ${['a position', 'a number', 'two numbers', 'three numbers'][arity]}${isUniform ? ' that all vertices share' : ''}`, () => {
          const offset = ({ glsl, position, millis, mouseX, mouseY }) => {
            const operands = isUniform
              ? [millis, mouseX, mouseY]
              : ['x', 'y', 'z'].map((c) => position[c]())
            const result = arity ? glsl[name](...operands.slice(0, arity)) : position[name]()
            const value = propertiesOf[name]?.size > 1 ? result.x() : result
            return glsl.vec3(glsl.ifElse(glsl.gt(value, 3e38), 7, value), 0, 0)
          }
          for (const millis of isUniform ? extremes.slice(0, 16) : [0]) {
            const uniforms = { millis, mouse: [millis / 3, 2 - millis] }
            const mesh = isUniform ? firstVertices(extreme, 3) : extreme
            assertBothSame(
              compileWarp(offset),
              mesh,
              uniforms,
              [5, mesh.positions.length / 3],
              name,
            )
          }
        })

  const functionCount = isRun('every random expression') ? 400 : 100
  test(`for ${functionCount} random functions in GLSL, with loops, conditions and integers`, () => {
    for (let seed = 1; seed <= functionCount; seed++) {
      const { glsl: text } = randomFunction(seed)
      const warp = compileWarp(({ glsl, position }) =>
        glsl.source(sharedDeclarations + text)(position),
      )
      assertBothSame(warp, firstVertices(ordinary, 37), {}, [1, 37], `function ${seed}`)
    }
  })

  test('for a warp whose code is split into several functions, which pass values to each other', () => {
    const warp = compileWarp(({ glsl, position, millis }) => {
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const waves = Array.from({ length: 300 }, (_, i) =>
        [x, y, z][i % 3]
          .mult(1 + i / 10)
          .add(millis)
          .add(i)
          .sin(),
      )
      const forth = waves.reduce((sum, wave) => sum.mult(0.9).add(wave), x)
      const back = waves.reduceRight((sum, wave) => sum.mult(0.9).add(wave.mult(wave)), y)
      return glsl.vec3(forth, back, forth.mult(back))
    })
    assertBothSame(warp, ordinary, { millis: 3 }, counts, 'waves')
  })

  test('for more vertices than a batch has, and into arrays of the caller', () => {
    const warp = compileWarp(({ position, millis }) => position.yzx().mult(3).add(millis).sin())
    const mesh = {
      positions: Float32Array.from({ length: 3 * 9001 }, (_, i) => Math.sin(i)),
      normals: Float32Array.from({ length: 3 * 9001 }, (_, i) => Math.cos(i)),
    }
    const uniforms = { millis: 2 }
    const expected = warp.evaluate(mesh, { uniforms })
    assertSame(warp.evaluate(mesh, { uniforms }), expected, 'all')
    warp.evaluate(mesh, { uniforms, out: mesh })
    assertSame(mesh, expected, 'in place')
  })

  test('for a single vertex', () => {
    const warp = compileWarp(({ position, millis }) => position.yzx().mult(3).add(millis).sin())
    const at = () =>
      warp.evaluateAt([0.1, 0.2, 0.3], { normal: [0, 1, 0], uniforms: { millis: 1 } })
    const expected = at()
    for (let i = 0; i < 3; i++) assert.deepEqual(at(), expected)
  })
})

const makeOffset =
  (i) =>
  ({ glsl, position }) =>
    glsl.vec3(position.y().mult(i).sin(), position.z().add(i).exp(), 0)

test('code of unreachable warps is freed', async () => {
  const count = isRun('thousands of warps') ? 3000 : 300
  const mesh = firstVertices(ordinary, 64)
  compileWarp(makeOffset(0)).evaluate(mesh) // starts the evaluation module
  const { Instance } = WebAssembly
  const instances = []
  WebAssembly.Instance = function (...args) {
    const instance = new Instance(...args)
    instances.push(new WeakRef(instance))
    return instance
  }
  const memoryBefore = evaluationMemoryInUse()
  let last
  for (let i = 0; i < count; i++) {
    last = compileWarp(makeOffset(i))
    for (let k = 0; k < 2; k++) last.evaluate(mesh)
  }
  WebAssembly.Instance = Instance
  assert.equal(instances.length, count)
  assert.equal(evaluationMemoryInUse(), memoryBefore)
  for (let i = 0; i < 5; i++) {
    collect()
    await setTimeout(20)
  }
  const alive = instances.filter((instance) => instance.deref()).length
  assert.ok(alive >= 1 && alive < 20, `${alive} of ${count} are still in memory`)
  assert.ok(last.evaluate(mesh), 'the last warp does not work')
})

// Must be the last test: no code is compiled after it.
test('if compiling is forbidden, the interpreter takes over', () => {
  const allowed = compileWarp(makeOffset(1))
  const expected = [1, 2].map(() => allowed.evaluate(ordinary))[1]
  let tried = 0
  WebAssembly.Module = function () {
    tried++
    throw new WebAssembly.CompileError('Wasm code generation disallowed by embedder')
  }
  const forbidden = compileWarp(makeOffset(1))
  for (let i = 0; i < 3; i++) assertSame(forbidden.evaluate(ordinary), expected, 'forbidden')
  const other = compileWarp(makeOffset(1))
  for (let i = 0; i < 3; i++) assertSame(other.evaluate(ordinary), expected, 'another')
  assert.equal(tried, 1, 'expected only one attempt')
})
