// Compares our grammar of GLSL with an independent parser: both accept and reject the same source.
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { test } from 'node:test'
import { glslOffset } from 'warpjet/glsl'
import { corpus } from '../glsl/corpus.js'
import { above, randomFunction, randomOf } from '../glsl/generate.js'

const require = createRequire(import.meta.url)
const { parser } = require('@shaderfrog/glsl-parser')
const { preprocess } = require('@shaderfrog/glsl-parser/preprocessor')

/** Returns the message of the independent parser; `undefined` if it accepts the source. */
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
    const text = above + randomFunction(seed).glsl
    assert.equal(ourMessage(text), undefined, text)
    assert.equal(messageOfParser(text), undefined, text)
  }
})

test('of source with a token missing, added or misplaced, we reject whatever the independent parser rejects', () => {
  const random = randomOf(15)
  const int = (count) => Math.floor(random() * count)
  const rejected = { there: 0, here: 0 }
  for (const { name, text } of corpus.filter((each) => !/^\s*#/m.test(each.text)))
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
      const why = messageOfParser(changed)
      const here = ourMessage(changed)
      if (here !== undefined) rejected.here++
      // A ; between functions, which desktop GLSL accepts, and which people leave after a }.
      if (why === undefined || /function prototype.*but ";" found/.test(why)) continue
      rejected.there++
      assert.notEqual(here, undefined, `${name}: we accept what it rejects (${why})\n${changed}`)
    }
  assert.ok(rejected.there > 100, `${rejected.there} were rejected there, ${rejected.here} here`)
})
