// Tests the packages whose functions are in the corpus: their licence allows us to run the functions, each package is used, none is
// shipped.
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { corpus, packages } from '../glsl/corpus.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const { dependencies = {}, devDependencies } = JSON.parse(
  readFileSync(`${root}package.json`, 'utf8'),
)

for (const name of Object.keys(packages))
  test(`${name} has the MIT licence, in full`, () => {
    const folder = `${root}node_modules/${name}`
    const { license, version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'))
    assert.equal(license, 'MIT')
    const file = readdirSync(folder).find((name) => /^licen[cs]e/i.test(name))
    assert.match(
      readFileSync(`${folder}/${file}`, 'utf8').replace(/\s+/g, ' '),
      /Permission is hereby granted, free of charge, to any person obtaining a copy/,
    )
    assert.equal(devDependencies[name], version)
    assert.ok(!(name in dependencies))
    assert.ok(
      corpus.some((source) => source.name.startsWith(`${name}/`)),
      'the corpus has no function of the package',
    )
  })

test('every development package with GLSL is in the corpus', () => {
  // This excludes @shaderfrog/glsl-parser, the independent parser.
  const all = Object.keys(devDependencies).filter((name) => /^glsl-/.test(name))
  assert.deepEqual(all.sort(), Object.keys(packages).sort())
})
