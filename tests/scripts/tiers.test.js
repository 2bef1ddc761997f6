import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import { test } from 'node:test'
import { rareFiles } from '../../.scripts/lib/tiers.mjs'

test('all files that the default run skips exist', () => {
  for (const file of rareFiles) assert.ok(existsSync(file), file)
})
