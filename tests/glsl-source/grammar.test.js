// Compares our grammar of GLSL with an independent parser: we accept valid source that it accepts, and reject all that it rejects.
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { test } from 'node:test'
import { glslOffset } from 'warpjet/glsl'
import { corpus } from '../glsl/corpus.js'
import { randomFunction, randomOf, sharedDeclarations } from '../glsl/generate.js'

const require = createRequire(import.meta.url)
const { parser } = require('@shaderfrog/glsl-parser')
const { preprocess } = require('@shaderfrog/glsl-parser/preprocessor')

/** Returns the error message of the independent parser; `undefined` if it accepts the source. */
function messageOfParser(text) {
  try {
    parser.parse(preprocess(text, { preserve: { version: () => true } }), { quiet: true })
    return undefined
  } catch (error) {
    return error.message
  }
}

function ourMessage(text) {
  try {
    glslOffset(text)
    return undefined
  } catch (error) {
    assert.equal(error.name, 'WarpError', error.stack)
    return error.message
  }
}

test('the independent parser accepts all source of the corpus, and so do we', () => {
  for (const { name, text } of corpus) {
    assert.equal(ourMessage(text), undefined, name)
    assert.equal(messageOfParser(text), undefined, name)
  }
})

test('the independent parser accepts random functions, and so do we', () => {
  for (let seed = 1; seed <= 60; seed++) {
    const text = sharedDeclarations + randomFunction(seed).glsl
    assert.equal(ourMessage(text), undefined, text)
    assert.equal(messageOfParser(text), undefined, text)
  }
})

test('of source with a token missing, added or misplaced, we reject whatever the independent parser rejects', () => {
  const random = randomOf(15)
  const int = (count) => Math.floor(random() * count)
  const rejected = { byParser: 0, byUs: 0 }
  for (const { name, text } of corpus.filter((source) => !/^\s*#/m.test(source.text)))
    for (let i = 0; i < 12; i++) {
      const tokens = text
        .replace(/\/\/.*|\/\*[^]*?\*\//g, ' ')
        .match(/[\w.]+|[-+*/<>=!&|^]=|&&|\|\||[+]{2}|--|\S/g)
      const at = int(tokens.length)
      const kind = int(3)
      if (kind === 0) tokens.splice(at, 1)
      else if (kind === 1) tokens.splice(at, 0, tokens[int(tokens.length)])
      else tokens[at] = tokens[int(tokens.length)]
      const changed = tokens.join(' ')
      const theirs = messageOfParser(changed)
      const ours = ourMessage(changed)
      if (ours !== undefined) rejected.byUs++
      // We accept a ; between functions: people leave it after a }, and desktop GLSL accepts it.
      if (theirs === undefined || /function prototype.*but ";" found/.test(theirs)) continue
      rejected.byParser++
      assert.notEqual(
        ours,
        undefined,
        `${name}: we accept what the parser rejects (${theirs})\n${changed}`,
      )
    }
  assert.ok(
    rejected.byParser > 100,
    `the parser rejected ${rejected.byParser}, we rejected ${rejected.byUs}`,
  )
})
