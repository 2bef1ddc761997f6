// Tests how the bytes of the wasm modules, which the built scripts contain as hexadecimal digits, are decoded: by the engine, by Node's
// Buffer or by a loop.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'

const dist = new URL('../../dist/warpjet.js', import.meta.url).href

/** Runs code in a new process, compiles sin(x) there, and returns the shader code and the decoders that were called. */
function compileAfter(code) {
  const script = `const calls = []
${code}
const { compile } = await import(${JSON.stringify(dist)})
const { code } = compile((glsl) => ({ y: glsl.param('x').sin() }))
process.stdout.write(JSON.stringify({ code, calls }))`
  return JSON.parse(
    execFileSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' }),
  )
}

const withoutFromHex = 'delete Uint8Array.fromHex;'
const withFromHex = `const from = Buffer.from
Uint8Array.fromHex = function (text) {
  if (this !== Uint8Array) throw new TypeError('wrong receiver')
  calls.push('fromHex')
  return new Uint8Array(from(text, 'hex'))
};`
const countBuffer = `const { from } = Buffer
Buffer.from = (...args) => (args[1] === 'hex' && calls.push('Buffer'), from.apply(Buffer, args));`

for (const [name, code, expected] of [
  ['the engine', withFromHex, ['fromHex']],
  ['Buffer', withoutFromHex + countBuffer, ['Buffer']],
  ['a loop', `${withoutFromHex} delete globalThis.Buffer`, []],
])
  test(`${name} decodes the modules`, () => {
    const { code: shader, calls } = compileAfter(code)
    assert.deepEqual(calls, expected)
    assert.match(shader, /y = sin\(x\);/)
  })
