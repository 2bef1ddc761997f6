// Tests the search for unclear wording in comments, messages and names.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { addedWording, findWording } from '../../.scripts/plain-english.mjs'

const rulesIn = (source, file = 'a.js') => findWording(file, source).map(({ rule }) => rule)

describe('wording to reread, and what to write', () => {
  for (const [bad, good] of [
    ['// What of p5 makes things.', '// The p5 constructors we need.'],
    ['// By input, its number in the module.', '// Maps input name → index in the module.'],
    ['/** 20 unless given. */', '/** Default: 20. */'],
    ['// Takes so many numbers a vertex.', '// Takes 3 floats per vertex.'],
    ['// WebGL 1 is told the size.', '// WebGL 1 needs a size uniform.'],
    [
      "fail('a vec3 was expected, but undefined came')",
      "fail('expected a vec3 of this size, got undefined')",
    ],
    ['// The caller laid the words into memory.', '// The caller copies the words into memory.'],
    ['// Returns nothing if there are none.', '// Returns `undefined` if there are none.'],
    ['// Reads from what is in the graph.', '// Reads from the graph.'],
    ['// The usual size.', '// The default size.'],
    ['function settled() {}', 'function snapshotUniforms() {}'],
    ['const mostTriangles = 5', 'const maxTriangles = 5'],
  ])
    test(bad, () => {
      assert.equal(rulesIn(bad).length, 1)
      assert.deepEqual(rulesIn(good), [])
    })
})

test('reads Markdown line by line', () => {
  assert.deepEqual(
    findWording('a.md', 'Fine.\n\nIt tells you.').map(({ line }) => line),
    [3],
  )
})

test('reports the line of a finding', () => {
  assert.deepEqual(findWording('a.js', 'x()\n/**\n * Fine.\n */\n// Of p5.\n')[0].line, 5)
})

test('a finding that only moved to another file or line is not new, but a second occurrence is', () => {
  const before = findWording('a.js', '// Of p5.\n')
  const after = findWording('b.js', 'x()\n// Of p5.\n')
  assert.deepEqual(addedWording(before, after), [])
  assert.deepEqual(addedWording(before, [...after, ...after]), after)
})
