// Tests the compiler with only 8 MB of memory: it throws one message if it runs out of memory, and the next warp works.
import assert from 'node:assert/strict'
import { afterEach, test } from 'node:test'

// The maximum size of the memory in the module: 32,768 pages, in the bytes of LEB128.
const maxPages = Buffer.from([0x80, 0x80, 0x02])
const { Module } = WebAssembly
WebAssembly.Module = function (bytes) {
  const copy = Buffer.from(bytes)
  const memory = copy.indexOf(Buffer.concat([Buffer.from([1, 1]), Buffer.from([0x20]), maxPages]))
  if (memory >= 0) copy.set([0x80, 0x81, 0x00], memory + 3)
  return new Module(copy)
}
const { compile, compileWarp } = await import('../../dist/warpjet.js')
const { throwsWarpError } = await import('../support/warp-errors.js')
const { memoryInUse } = await import('../../dist/memory.js')

const zeroOffset = ({ glsl }) => glsl.vec3(0, 0, 0)
compileWarp(zeroOffset)
const before = memoryInUse()

afterEach(() => {
  assert.match(compileWarp(zeroOffset).code, /warpedPosition/)
  assert.equal(memoryInUse(), before)
})

const outOfMemory =
  /^There is not enough memory for so large a warp: the compiler already holds [2-8] MB\.$/

/** Returns an expression of `count` nested sines. */
function nestSines(start, count) {
  let sum = start
  for (let i = 0; i < count; i++) sum = sum.add(i).sin()
  return sum
}

test('rejects a warp that is too large', () => {
  const large = ({ glsl, millis }) => glsl.vec3(nestSines(millis, 1e6), 0, 0)
  throwsWarpError(() => compileWarp(large), outOfMemory)
})

test('rejects evaluating a warp that compiles, but is too large to evaluate', () => {
  const warp = compileWarp(({ glsl, position }) => glsl.vec3(nestSines(position.x(), 10_000), 0, 0))
  const vertices = { positions: new Float32Array(30_000), normals: new Float32Array(30_000) }
  throwsWarpError(
    () => warp.evaluate(vertices),
    /^There is not enough memory to evaluate so large a warp on the CPU, which already takes [2-8] MB\.$/,
  )
})

test('rejects too many nested warps', () => {
  let deepest = 0
  const nested = (depth) => () =>
    compileWarp(({ glsl, millis }) => {
      deepest = depth
      nestSines(millis, 5000)
      if (depth < 100) nested(depth + 1)()
      return glsl.vec3(0, 0, 0)
    })
  throwsWarpError(nested(1), outOfMemory)
  assert.ok(deepest > 1 && deepest < 100, `${deepest}`)
})

test('rejects a name longer than the memory', () => {
  throwsWarpError(() => compile((glsl) => ({ y: glsl.param('x'.repeat(2 ** 23)) })), outOfMemory)
})

test('a warp fails, too, if a nested one runs out of memory', () => {
  throwsWarpError(
    () =>
      compileWarp(({ glsl, millis }) => {
        throwsWarpError(
          () => compile((glsl) => ({ y: nestSines(glsl.param('x'), 1e6) })),
          outOfMemory,
        )
        return glsl.vec3(millis, 0, 0)
      }),
    /^vec3: the compiler ran out of memory, and this warp was lost with it; make it again\.$/,
  )
})
