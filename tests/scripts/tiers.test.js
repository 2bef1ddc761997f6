import assert from 'node:assert/strict'
import { test } from 'node:test'
import { checks } from '../../.scripts/lib/checks.mjs'
import { walk } from '../../.scripts/lib/files.mjs'
import { isRun, rareFiles, rareSteps } from '../../.scripts/lib/tiers.mjs'

test('all steps and files that the default run skips exist', () => {
  const titles = checks.map(({ title }) => title)
  for (const title of Object.keys(rareSteps)) assert.ok(titles.includes(title), title)
  const files = ['tests', 'web/tests'].flatMap((folder) => walk(folder, /\.js$/))
  for (const file of rareFiles) assert.ok(files.includes(file), file)
})

test('rejects an unknown part', () => assert.throws(() => isRun('boring'), /got boring/))
