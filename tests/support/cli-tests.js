// Files and helpers that the tests of `npx warpjet` share.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after } from 'node:test'
import { fileURLToPath } from 'node:url'
import { exportGLB } from 'warpjet/mesh'
import { sphere } from './meshes.js'
import { png } from './png.js'

export const program = fileURLToPath(new URL('../../dist/cli.js', import.meta.url))
export const folder = mkdtempSync(join(tmpdir(), 'warpjet cli '))
after(() => rmSync(folder, { recursive: true }))

export const write = (name, contents) => writeFileSync(join(folder, name), contents)
write('package.json', '{ "type": "module" }')
write(
  'wave.js',
  'export default ({ glsl, position, millis }) => glsl.vec3(0, position.x().mult(millis), 0)',
)
write(
  'named.js',
  'export const speed = 2\nexport function bend({ glsl, position }) { return glsl.vec3(position.y().sin(), 0, 0) }',
)
write(
  'bumps.js',
  'export default ({ normal, position }) => normal.mult(position.x().mult(5).sin().mult(0.1))',
)
write('mouse.js', 'export default ({ glsl, mouse }) => glsl.vec3(mouse, 0)')
export const material = {
  baseColor: [1, 0.5, 0, 1],
  baseColorTexture: { bytes: png(2, 2, () => [9, 9, 9]), mimeType: 'image/png' },
}
export const model = { ...sphere(), material }
write('model.glb', exportGLB(model))

/** Runs the program in the folder. Returns its exit code and output. */
export function warpjet(...args) {
  const child = spawn(process.execPath, [program, ...args], { cwd: folder })
  const result = { stdout: '', stderr: '' }
  for (const stream of ['stdout', 'stderr'])
    child[stream].setEncoding('utf8').on('data', (text) => (result[stream] += text))
  return new Promise((resolve) => child.on('close', (code) => resolve({ code, ...result })))
}

/** Runs the program, and asserts that it exits with this code, writes nothing to stdout, and a single message to stderr. */
async function fails(code, args, pattern) {
  const result = await warpjet(...args)
  assert.equal(result.stdout, '')
  assert.match(result.stderr, pattern)
  assert.equal(result.stderr.trim().split('\n').length, 1, result.stderr)
  assert.match(result.stderr, /^warpjet: /)
  assert.equal(result.code, code, result.stderr)
}

export const failsWithUsage = (args, pattern) => fails(2, args, pattern)
export const failsWithError = (args, pattern) => fails(1, args, pattern)

/** Runs the program, and asserts that it succeeds. Returns its output. */
export async function works(...args) {
  const result = await warpjet(...args)
  assert.equal(result.code, 0, result.stderr)
  return result
}
