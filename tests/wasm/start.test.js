// Tests the errors if WebAssembly does not start. Simulates each browser that rejects it in a process of its own.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../../', import.meta.url))

/** Returns 'works' or the error of compileWarp, of loadMesh and of createDetail, after `change` has modified the global WebAssembly. */
function outcomesAfter(change) {
  const code = `
    const { Module } = WebAssembly
    ${change}
    const problem = ({ name, message }) => name + ': ' + message
    const outcome = async (work) => work().then(() => 'works', problem)
    const { compileWarp } = await import('${root}dist/warpjet.js')
    const { loadMesh } = await import('${root}dist/mesh.js')
    const { createDetail } = await import('${root}dist/detail.js')
    const offset = ({ glsl }) => glsl.vec3(0, 0, 0)
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0]
    const view = { matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], width: 1, height: 1 }
    console.log(JSON.stringify([
      await outcome(async () => compileWarp(offset).evaluateAt([0, 0, 0])),
      await outcome(() => loadMesh(new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n'))),
      await outcome(async () => createDetail({ positions, indices: [0, 1, 2] }, compileWarp(offset)).update(view)),
    ]))`
  const output = execFileSync(process.execPath, ['--input-type=module', '--eval', code], {
    encoding: 'utf8',
  })
  return JSON.parse(output)
}

/** Returns code that replaces WebAssembly.Module by a class whose constructor first runs `statement`, which may throw. */
const withModule = (statement) =>
  `WebAssembly.Module = class { constructor(bytes) { ${statement}; return new Module(bytes) } }`

test('WebAssembly starts in an unchanged environment', () => {
  assert.deepEqual(outcomesAfter(''), ['works', 'works', 'works'])
})

test('under a Content-Security-Policy the message says what to add, whatever the browser’s own message is', () => {
  for (const statement of [
    "throw new WebAssembly.CompileError('call to WebAssembly.Module() blocked by CSP')",
    "throw new EvalError('Refused to create a WebAssembly object')",
  ])
    for (const problem of outcomesAfter(withModule(statement)))
      assert.match(problem, /^WarpError: .*'wasm-unsafe-eval' to its script-src/)
})

test('in a browser that compiles no large module synchronously, the message names the required version', () => {
  const statement =
    "if (bytes.length > 4096) throw new RangeError('WebAssembly.Compile is disallowed on the main thread, if the buffer size is larger than 4KB.')"
  for (const problem of outcomesAfter(withModule(statement)))
    assert.match(problem, /^WarpError: .*update it \(Chrome and Edge do since version 114\)/)
})

test('in a browser without SIMD, the message says what needs it', () => {
  // Only the modules with SIMD are as short as this.
  const statement =
    "if (bytes.length > 8 && bytes.length < 250_000) throw new WebAssembly.CompileError('invalid numeric opcode 0xfd00')"
  const [evaluation, mesh, detail] = outcomesAfter(withModule(statement))
  assert.match(evaluation, /^WarpError: A warp on the CPU needs WebAssembly with SIMD/)
  assert.equal(mesh, 'works')
  assert.match(detail, /^WarpError: Detail needs WebAssembly with SIMD/)
})

test('without WebAssembly, the message says that it is required', () => {
  for (const problem of outcomesAfter('delete globalThis.WebAssembly'))
    assert.match(problem, /^WarpError: warpjet needs WebAssembly, which this browser lacks/)
})
