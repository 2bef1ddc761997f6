// Tests that each dependency rule reports a violation: breaks the rule in a copy of js-bindings.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { appendFileSync, cpSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))
let copy

before(() => {
  copy = mkdtempSync(join(tmpdir(), 'warpjet-dependencies-'))
  for (const name of ['js-bindings', 'package.json', 'tsconfig.json', '.dependency-cruiser.cjs'])
    cpSync(join(root, name), join(copy, name), { recursive: true })
  symlinkSync(join(root, 'node_modules'), join(copy, 'node_modules'))
})
after(() => rmSync(copy, { recursive: true }))

/** Returns the names of the rules of these severities that the copy violates. */
function findViolations(severities = ['error', 'warn']) {
  const cruiser = join(root, 'node_modules/dependency-cruiser/bin/dependency-cruise.mjs')
  const args = ['js-bindings', '--config', '.dependency-cruiser.cjs', '--output-type', 'json']
  const { stdout, stderr } = spawnSync(process.execPath, [cruiser, ...args], {
    cwd: copy,
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
  assert.equal(stderr, '')
  const violations = JSON.parse(stdout).summary.violations.map(({ rule }) => rule)
  return violations.filter(({ severity }) => severities.includes(severity)).map(({ name }) => name)
}

test('js-bindings violates no rule', () => assert.deepEqual(findViolations(['error']), []))

for (const [rule, file, line] of [
  ['no-circular-files', 'errors/describe.ts', "import type {} from './errors.js'"],
  ['no-circular-modules', 'errors/notes.ts', "import type {} from '../options/guards.js'"],
  ['no-entry-from-below', 'mesh/load.ts', "import type {} from '../deformers.js'"],
  ['adapters-use-host-layer', 'babylon/warp.ts', "import type {} from '../core/inputs/inputs.js'"],
  ['no-orphans', 'mesh/forgotten.ts', 'export const forgotten = 1'],
  ['no-unresolved', 'mesh/load.ts', "import './no-such-file.js'"],
])
  test(`${rule} catches ${line}`, () => {
    const path = join(copy, 'js-bindings', file)
    appendFileSync(path, `\n${line}\n`)
    try {
      assert.ok(findViolations().includes(rule), findViolations().join())
    } finally {
      const original = join(root, 'js-bindings', file)
      if (rule === 'no-orphans') rmSync(path)
      else cpSync(original, path)
    }
  })
