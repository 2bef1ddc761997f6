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

/** Returns the violations of rules in the copy, as { rule, severity }. */
function findViolations() {
  const cruiser = join(root, 'node_modules/dependency-cruiser/bin/dependency-cruise.mjs')
  const args = ['js-bindings', '--config', '.dependency-cruiser.cjs', '--output-type', 'json']
  const { stdout, stderr } = spawnSync(process.execPath, [cruiser, ...args], {
    cwd: copy,
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
  assert.equal(stderr, '')
  const { violations } = JSON.parse(stdout).summary
  return violations.map(({ rule: { name, severity } }) => ({ rule: name, severity }))
}

const mistakes = [
  ['no-circular-files', 'errors/describe.ts', "import type {} from './errors.js'"],
  ['no-circular-modules', 'errors/notes.ts', "import type {} from '../options/guards.js'"],
  ['no-entry-from-below', 'mesh/load.ts', "import type {} from '../deformers.js'"],
  ['adapters-use-host-layer', 'babylon/warp.ts', "import type {} from '../core/inputs/inputs.js'"],
  ['no-orphans', 'mesh/forgotten.ts', 'export const forgotten = 1'],
  ['no-unresolved', 'mesh/load.ts', "import './no-such-file.js'"],
]

test('js-bindings violates no rule, and each rule catches its violation', () => {
  const before = findViolations()
  assert.deepEqual(
    before.filter(({ severity }) => severity === 'error'),
    [],
  )
  // All mistakes are made at once, since each search takes 4 s.
  for (const [, file, line] of mistakes)
    appendFileSync(join(copy, 'js-bindings', file), `\n${line}\n`)
  const after = findViolations()
  const count = (violations, name) => violations.filter(({ rule }) => rule === name).length
  for (const [rule, , line] of mistakes)
    assert.ok(count(after, rule) > count(before, rule), `${rule} misses ${line}`)
})
