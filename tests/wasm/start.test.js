// Tests the errors if WebAssembly does not start. Simulates each browser that rejects it in a process of its own.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../../', import.meta.url))

/** Returns 'works' or the error of compileWarp and of loadMesh, after `change` has modified the global WebAssembly. */
function outcomesAfter(change) {
  const code = `
    const { Module } = WebAssembly
    ${change}
    const problem = ({ name, message }) => name + ': ' + message
    const outcome = async (work) => work().then(() => 'works', problem)
    const { compileWarp } = await import('${root}dist/warpjet.js')
    const { loadMesh } = await import('${root}dist/mesh.js')
    console.log(JSON.stringify([
      await outcome(async () => compileWarp(({ glsl }) => glsl.vec3(0, 0, 0)).evaluateAt([0, 0, 0])),
      await outcome(() => loadMesh(new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n'))),
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
  assert.deepEqual(outcomesAfter(''), ['works', 'works'])
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

test('without WebAssembly, the message says that it is required', () => {
  for (const problem of outcomesAfter('delete globalThis.WebAssembly'))
    assert.match(problem, /^WarpError: warpjet needs WebAssembly, which this browser lacks/)
})
