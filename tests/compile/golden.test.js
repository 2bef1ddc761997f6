// The shader texts of the gallery and the stress test, kept in tests/golden, are as they were and read well.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { goldenTexts, keptTexts } from '../warps/golden.js'

const texts = goldenTexts()
const kept = keptTexts()

describe('shader texts', () => {
  test('are one file each', () => {
    const message = 'Renew the files with `npm run golden`.'
    assert.deepEqual(Object.keys(kept).sort(), Object.keys(texts).sort(), message)
  })

  for (const [file, text] of Object.entries(texts))
    test(`${file} is as it was`, () =>
      assert.equal(text, kept[file], 'If the new text is right, keep it with `npm run golden`.'))
})

test('no two shader texts are the same', () => {
  const files = Object.keys(texts)
  const same = files.filter((file, i) => files.slice(0, i).some((f) => texts[f] === texts[file]))
  assert.deepEqual(same, [], 'What is kept twice proves nothing more, and may be a mistake.')
})

describe('shader texts read well:', () => {
  for (const [file, text] of Object.entries(texts))
    test(file, () => {
      assert.doesNotMatch(text, /(\*|\/) 1\.0(?!\d)|(?<![\w.])1\.0 \*/, 'a product with 1')
      assert.doesNotMatch(text, /[*+-] -?0\.0(?!\d)|(?<![\w.])0\.0 [*+]/, 'a sum or product with 0')
      assert.doesNotMatch(text, /--|[+-] -/, 'a double sign')
      assert.deepEqual(doubledParentheses(text), [])
      assert.doesNotMatch(text, /\S {2}| $/m, 'stray spaces')
    })
})

/** The spots of `((…))` where the inner pair encloses all that the outer one does. */
function doubledParentheses(text) {
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
