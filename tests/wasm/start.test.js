// What is said where WebAssembly does not start. Browsers that refuse it are imitated, in a process of their own.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../../', import.meta.url))

/** The errors of compileWarp and of loadMesh after `change` was done to the global WebAssembly. */
function problems(change) {
  const code = `
    const { Module } = WebAssembly
    ${change}
    const problem = ({ name, message }) => name + ': ' + message
    const tried = async (work) => work().then(() => 'works', problem)
    const { compileWarp } = await import('${root}dist/warpjet.js')
    const { loadMesh } = await import('${root}dist/mesh.js')
    console.log(JSON.stringify([
      await tried(async () => compileWarp(({ glsl }) => glsl.vec3(0, 0, 0)).evaluateAt([0, 0, 0])),
      await tried(() => loadMesh(new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n'))),
    ]))`
  const output = execFileSync(process.execPath, ['--input-type=module', '--eval', code], {
    encoding: 'utf8',
  })
  return JSON.parse(output)
}

/** A class for `new WebAssembly.Module(bytes)` that throws where `refusal` says so. */
const withModule = (refusal) =>
  `WebAssembly.Module = class { constructor(bytes) { ${refusal}; return new Module(bytes) } }`

test('starts as it is', () => {
  assert.deepEqual(problems(''), ['works', 'works'])
})

test('a Content-Security-Policy: what to add to it, whatever the browser calls it', () => {
  for (const refusal of [
    "throw new WebAssembly.CompileError('call to WebAssembly.Module() blocked by CSP')",
    "throw new EvalError('Refused to create a WebAssembly object')",
  ])
    for (const problem of problems(withModule(refusal)))
      assert.match(problem, /^WarpError: .*'wasm-unsafe-eval' to its script-src/)
})

test('a browser that compiles no large module at once: its version', () => {
  const refusal =
    "if (bytes.length > 4096) throw new RangeError('WebAssembly.Compile is disallowed on the main thread, if the buffer size is larger than 4KB.')"
  for (const problem of problems(withModule(refusal)))
    assert.match(problem, /^WarpError: .*update it \(Chrome and Edge do since version 114\)/)
})

test('no WebAssembly: that it is needed', () => {
  for (const problem of problems('delete globalThis.WebAssembly'))
    assert.match(problem, /^WarpError: warpjet needs WebAssembly, which this browser lacks/)
})
