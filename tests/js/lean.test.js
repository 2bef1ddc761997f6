// The compiler's texts are short: value and derivative share their sines.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { warps } from '../warps/index.js'
import { stackedSines } from '../warps/stress.js'
import { compileWarp } from '../../dist/warpjet.js'

const calls = (text, name) => text.match(new RegExp(`\\b${name}\\(`, 'g'))?.length ?? 0

test('a twist has one sine and one cosine', () => {
  const { code } = warps.find(({ name }) => name === 'twist').compile()
  assert.deepEqual([calls(code, 'sin'), calls(code, 'cos')], [1, 1])
})

for (const count of [1, 30, 300])
  test(`${count} stacked sines have at most ${count} sines and ${count} cosines`, () => {
    const { code } = compileWarp(stackedSines(count).warp)
    assert.ok(calls(code, 'sin') <= count)
    assert.ok(calls(code, 'cos') <= count)
  })

test('300 stacked sines, 1,500 operations of a sketch, are at most 40,000 characters', () => {
  const { code } = compileWarp(stackedSines(300).warp)
  assert.ok(code.length <= 40_000, `${code.length} characters`)
})

test('positions alone carry no derivatives', () => {
  const { code } = compileWarp(stackedSines(30).warp, { normals: false })
  assert.equal(calls(code, 'cos'), 0)
  assert.doesNotMatch(code, /normal/i)
})
