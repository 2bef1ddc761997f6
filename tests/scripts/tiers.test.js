// What the everyday run leaves out is there, and is asked for.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { checks } from '../../.scripts/lib/checks.mjs'
import { walk } from '../../.scripts/lib/files.mjs'
import { isRun, leftOut } from '../../.scripts/lib/tiers.mjs'

const files = ['tests', 'web/tests'].flatMap((folder) => walk(folder, /\.js$/))

test('steps, files and parts that are left out exist', () => {
  const titles = checks.map(({ title }) => title)
  for (const title of Object.keys(leftOut.steps)) assert.ok(titles.includes(title), title)
  for (const file of Object.keys(leftOut.files)) assert.ok(files.includes(file), file)
  const texts = files.map((file) => readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8'))
  for (const part of Object.keys(leftOut.parts))
    assert.ok(
      texts.some((text) => text.includes(`isRun('${part}')`)),
      part,
    )
})

test('each has its reason', () => {
  for (const reason of Object.values(leftOut).flatMap(Object.values))
    assert.match(reason, /\w+ \w+ \w+/)
})

test('a part without a reason cannot be left out', () =>
  assert.throws(() => isRun('what is dull'), /gives no reason to leave out what is dull/))
