// Tests that a built file that grows causes a warning, which never fails the build.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { growthWarnings } from '../../.scripts/lib/sizes.mjs'

const before = { 'dist/a.js': 10_240, 'dist/b.js': 10_240 }

test('a file that grew by more than 5% is named with its size', () => {
  const rows = [
    { file: 'dist/a.js', gzipped: 11_264 },
    { file: 'dist/b.js', gzipped: 10_752 },
  ]
  assert.deepEqual(growthWarnings(rows, before), [
    'Warning: dist/a.js grew by 10%, to 11264 bytes gzipped. If that is intended, `npm run sizes` records it.',
  ])
})

test('new files and files that became smaller cause no warning', () => {
  const rows = [
    { file: 'dist/new.js', gzipped: 99_999 },
    { file: 'dist/a.js', gzipped: 1 },
  ]
  assert.deepEqual(growthWarnings(rows, before), [])
})
