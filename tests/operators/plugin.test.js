// Tests the plugin that translates operators when a project is built: modules, the loader of webpack, and source maps.
import assert from 'node:assert/strict'
import { SourceMap } from 'node:module'
import { test } from 'node:test'
import loader, { operators as plugin, translateModule } from '../../dist/operators-plugin.js'

test('a module without warps is unchanged, and closures are preserved in a module with warps', () => {
  assert.equal(translateModule('const a = b * c'), undefined)
  const code = translateModule(
    `const amount = 2\ncreateWarp(sketch, ({ position }) => position * amount, {})`,
  )
  assert.match(
    code,
    /^const amount = 2\n.*\nimport \{ withOperators as \w+ \} from 'warpjet\/operators\/runtime'\n$/,
  )
  assert.match(code, /warpjetOperators\.mult\(position, amount\)/)
})

test("a module's own imports stay intact, and its directive stays first", () => {
  const code = translateModule(
    `'use client'\nimport { map } from './mine'\nimport sin, * as all from './other'\ncreateWarp(({ position }) => map(sin(position.x), all) * 2) // end`,
  )
  assert.match(code, /^'use client'\n/)
  assert.match(code, /mult\(map\(sin\(position\.x\), all\), 2\)/)
  assert.match(code, /\/\/ end\nimport \{ withOperators as \w+ \} from/)
})

test('the loader of webpack generates the same code as the plugin, with a map', () => {
  const load = (code) => {
    let result
    loader.call({ resourcePath: 'sketch.js', callback: (...args) => (result = args) }, code)
    return result
  }
  const code = 'createWarp(({ position }) => position * 2)'
  const [error, translated, map] = load(code)
  const expected = plugin().transform(code, 'sketch.js')
  assert.equal(error, null)
  assert.equal(translated, expected.code)
  assert.equal(map.toString(), expected.map.toString())
  assert.deepEqual(load('const a = b * c'), [null, 'const a = b * c'])
})

test('a source map maps each word of a translated module to its origin', () => {
  const code = `import { createWarp } from 'warpjet/p5'
const twice = (value) => value * 2
createWarp(({ position, millis }) => {
  let height = 1
  height += millis
  if (position.x > height) return [twice(height), 0, 0]
  const rest = position.y
    - height
  return [0, Math.sin(rest), 0]
})
`
  const { code: translated, map } = plugin().transform(code, 'sketch.js')
  assert.deepEqual(map.sources, ['sketch.js'])
  const sourceMap = new SourceMap(JSON.parse(map.toString()))
  const lines = translated.split('\n')
  const mappedPlaces = new Set()
  for (const [line, text] of lines.entries())
    for (const { 0: word, index } of text.matchAll(
      /\b(position|millis|height|rest|twice|value)\b/g,
    )) {
      const { originalLine, originalColumn } = sourceMap.findEntry(line, index)
      const original = code.split('\n')[originalLine]?.slice(originalColumn)
      // Generated code, such as a list of variables, maps to the beginning of the code that it replaces.
      if (original?.startsWith(word)) mappedPlaces.add(`${originalLine}:${originalColumn}`)
    }
  const words = code
    .split('\n')
    .flatMap((text, line) =>
      [...text.matchAll(/\b(position|millis|height|rest|twice|value)\b/g)].map(
        ({ index }) => `${line}:${index}`,
      ),
    )
  assert.deepEqual(
    words.filter((place) => !mappedPlaces.has(place)),
    [],
  )
})
