// The shader code of the gallery and the stress test equals the golden files in tests/golden, and is readable.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { goldenTexts, readGoldenTexts } from '../warps/golden.js'

const texts = goldenTexts()
const golden = readGoldenTexts()

describe('shader code', () => {
  test('has one golden file per warp', () => {
    const message = 'Update the files with `npm run golden`.'
    assert.deepEqual(Object.keys(golden).sort(), Object.keys(texts).sort(), message)
  })

  for (const [file, text] of Object.entries(texts))
    test(`${file} is unchanged`, () =>
      assert.equal(text, golden[file], 'If the new code is right, store it with `npm run golden`.'))
})

test('no two golden files are the same', () => {
  const files = Object.keys(texts)
  const same = files.filter((file, i) => files.slice(0, i).some((f) => texts[f] === texts[file]))
  assert.deepEqual(same, [], 'Two equal golden files prove no more than one, and may be a mistake.')
})

describe('shader code is readable:', () => {
  for (const [file, text] of Object.entries(texts))
    test(file, () => {
      assert.doesNotMatch(text, /(\*|\/) 1\.0(?!\d)|(?<![\w.])1\.0 \*/, 'a product with 1')
      assert.doesNotMatch(text, /[*+-] -?0\.0(?!\d)|(?<![\w.])0\.0 [*+]/, 'a sum or product with 0')
      assert.doesNotMatch(text, /--|[+-] -/, 'a double sign')
      assert.deepEqual(findDoubledParentheses(text), [])
      assert.doesNotMatch(text, /\S {2}| $/m, 'stray spaces')
    })
})

/** Finds `((…))` whose inner pair encloses everything that the outer pair does. */
function findDoubledParentheses(text) {
  const [open, doubled] = [[], []]
  let lastClosed
  for (let i = 0; i < text.length; i++) {
    if (text[i] === '(') open.push(i)
    if (text[i] !== ')') continue
    const start = open.pop()
    if (lastClosed?.end === i - 1 && lastClosed.start === start + 1)
      doubled.push(text.slice(start, i + 1))
    lastClosed = { start, end: i }
  }
  return doubled
}
