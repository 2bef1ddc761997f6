import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import { test } from 'node:test'
import { everydayFiles, rareFiles } from '../../.scripts/lib/tiers.mjs'

test('all files that the tiers name exist', () => {
  for (const file of [...everydayFiles, ...rareFiles]) assert.ok(existsSync(file), file)
})
