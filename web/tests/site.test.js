// Tests the pages of the site: links lead to existing files, sketches survive the round trip through their link, and every listed file has
// its page.
import assert from 'node:assert/strict'
import { existsSync, readFileSync, readdirSync } from 'node:fs'
import { dirname, join } from 'node:path/posix'
import { before, describe, test } from 'node:test'
import { viteBuild } from '../../.scripts/lib/vite.mjs'
import { sections } from '../catalogue.js'
import { sketchOf } from '../playground/link.js'
import { blocksOf, makeMarkdown } from '../site/markdown.js'
import { pages as listedPages } from '../site/navigation.js'
import { sitePages } from '../site/pages.js'
import { linkTo, runnable } from '../site/runnable.js'
import { makeSearch } from '../site/search.js'
import { findSliders } from '../sliders.js'

const root = new URL('../../', import.meta.url)
const read = (path) => readFileSync(new URL(path, root), 'utf8')
const names = sections.flatMap(({ examples }) => examples.map(({ name }) => name))
const markdown = readdirSync(new URL('web/docs', root)).filter((file) => file.endsWith('.md'))

let pages, html
before(async () => {
  pages = await sitePages()
  html = [...pages].filter(([path]) => path.endsWith('.html'))
})

test('the navigation lists every file of the docs once, and nothing else', () => {
  assert.deepEqual(listedPages.map(({ file }) => `${file}.md`).sort(), markdown.sort())
})

/** Returns whether Vite generates or serves a file at a path. */
const isServed = (path) =>
  /^(?:playground|bench|drop)\/\w+\.html$/.test(path)
    ? existsSync(new URL(`web/${path}`, root))
    : /^site\/\w+\.(?:js|css|webp)$/.test(path) || /^(?:posters|docs)\/[\w-]+\.\w+$/.test(path)
      ? existsSync(new URL(`web/${path}`, root))
      : /^examples\/[\w-]+\/index\.html$/.test(path)
        ? existsSync(new URL(path, root))
        : /^examples\/[\w-]+\/\w+\.(?:obj|woff)$/.test(path)

test('every link and picture of every page exists, including anchors', () => {
  const wrong = []
  for (const [path, text] of html)
    for (const [, link] of text.matchAll(/(?:href|src)="([^"]+)"/g)) {
      if (/^(?:https:|data:)/.test(link)) continue
      const [file, anchor] = link.split('#')
      const target = file ? join(dirname(path), file, file.endsWith('/') ? 'index.html' : '') : path
      const page = pages.get(target)
      const hasAnchor =
        !anchor || /^(?:sketch|example)=/.test(anchor) || page?.includes(`id="${anchor}"`)
      if (!(page || isServed(target)) || !hasAnchor) wrong.push(`${path}: ${link}`)
    }
  assert.deepEqual(wrong, [])
})

test('links to folders end with a slash, since some hosts redirect x/index.html to x', () => {
  const wrong = html.filter(([, text]) => /href="(?!https:)[^"]*\bindex\.html/.test(text))
  assert.deepEqual(wrong, [])
})

test('no page uses an absolute path', () => {
  const wrong = html.filter(([, text]) => /(?:href|src)="\//.test(text))
  assert.deepEqual(wrong, [])
})

test('a block survives the round trip through its link', async () => {
  const text = read('web/docs/tutorial-1-first-warp.md')
  const [{ text: block, sketch }] = blocksOf(text)
  assert.equal(sketch.text, block)
  assert.deepEqual(await sketchOf(linkTo(sketch)), { text: block, host: 'p5', chosen: [] })
})

test('a part of a sketch is completed', () => {
  const { text } = runnable('createWarp(({ position }) => position)\n', 'js')
  assert.match(text, /^let warp\n[^]*\n  warp = createWarp\([^]*\n  warp\(\)\n/)
  const framed = runnable('b()\n', 'js', 'deformers\nfunction setup() {\n  …\n}\n')
  assert.deepEqual(framed, {
    text: 'function setup() {\n  b()\n}\n',
    host: 'p5',
    chosen: ['deformers'],
  })
  assert.equal(runnable('npm i\n', 'sh'), undefined)
  assert.equal(runnable('createWarp(f)\n', 'js', ' not '), undefined)
})

test('in a table a figure keeps its unit and its exponent, and only long code breaks', () => {
  const line =
    '| `a.b(c)` | 0, 6e-13 | 100 % | `glsl.faceforward(normal, incident, reference)` | 3 of them are long |'
  const table = makeMarkdown().render(`| a | b | c | d | e |\n| - | - | - | - | - |\n${line}\n`)
  assert.deepEqual(
    [...table.matchAll(/<td[^>]*?(?: class="(\w+)")?>/g)].map(([, name]) => name),
    [undefined, 'number', 'number', 'long', undefined],
  )
})

test('a table of words has a heading for each cell, and keeps its roles when its rows are cards', () => {
  const render = (...lines) => makeMarkdown().render(`${lines.join('\n')}\n`)
  const words = render('| a | `b` c | d |', '| - | - | - |', '| `x` | one | |', '| `y` | 2 | two |')
  assert.match(words, /class="table words"/)
  assert.deepEqual(
    [...words.matchAll(/data-head="([^"]*)"/g)].map(([, head]) => head),
    ['b c', 'd', 'b c', 'd'],
  )
  for (const role of ['table', 'rowgroup', 'row', 'columnheader', 'cell'])
    assert.match(words, new RegExp(`<t\\w+ role="${role}"`))
  assert.doesNotMatch(render('| a | b |', '| - | - |', '| x | one |'), /data-head/)
  const figures = render('| a | b | c |', '| - | - | - |', '| x | 1 | 2 ms |')
  assert.match(figures, /class="table figures"/)
  assert.doesNotMatch(figures, /role="(?:table|cell)"|data-head/)
})

test('no sketch leaves a warp active for the shapes that the next frame draws before its first warp', () => {
  const blocks = markdown.flatMap((file) =>
    [...read(`web/docs/${file}`).matchAll(/```js\n([^]*?)```/g)].map(([, text]) => ({
      file,
      text,
    })),
  )
  const sketches = names.map((file) => ({ file, text: read(`examples/${file}/sketch.js`) }))
  const shape = /\b(?:sphere|box|cylinder|plane|torus|model|cone|ellipsoid|warpBox|rect)\(/
  const wrong = []
  for (const { file, text } of [...blocks, ...sketches]) {
    const [, draw] = /function draw\(\) \{\n([^]*?)^\}/m.exec(text) ?? []
    const warps = [...text.matchAll(/(\w+) = createWarp/g)].map(([, name]) => name)
    if (!draw || !warps.length) continue
    const before = draw.split(new RegExp(`\\b(?:${warps.join('|')})\\(`))[0]
    const count = (call) => before.split(call).length - 1
    const isIsolated = count('push()') > count('pop()')
    if (before !== draw && shape.test(before) && !isIsolated) wrong.push(file)
  }
  assert.deepEqual(wrong, [])
})

test('every example has a page and a picture of at most 20 KB', () => {
  for (const name of names) {
    assert.ok(pages.has(`gallery/${name}/index.html`), name)
    const bytes = readFileSync(new URL(`web/posters/${name}.webp`, root))
    assert.equal(bytes.toString('latin1', 8, 12), 'WEBP', name)
    assert.ok(bytes.length <= 20_000, `${name}: ${bytes.length}`)
  }
})

test('the HTML copied from an example has the script tags that the sketch needs', () => {
  const page = pages.get('gallery/deformer-twist/index.html')
  const { page: copied } = JSON.parse(/id="sketch">([^]*?)<\/script>/.exec(page)[1])
  for (const file of ['p5.min.js', 'p5.warpjet.min.js', 'warpjet.deformers.min.js'])
    assert.match(
      copied,
      new RegExp(`<script src="https://cdn\\.jsdelivr\\.net/npm/\\S+@\\d\\S*/${file}"></script>`),
    )
  assert.ok(copied.includes(read('examples/deformer-twist/sketch.js').trimEnd()))
})

test('each example has a slider for a number of its sketch, which starts within its range', () => {
  for (const name of names) {
    const sketch = read(`examples/${name}/sketch.js`)
    const sliders = findSliders(name, sketch)
    assert.ok(sliders.length, `${name} has no slider`)
    for (const { label, value, from, to, at, length } of sliders) {
      assert.equal(Number(sketch.slice(at, at + length)), value, `${name}: ${label}`)
      assert.ok(from <= value && value <= to, `${name}: ${label} is ${value}`)
    }
  }
})

test('the search covers headings of the docs and examples', () => {
  const parts = JSON.parse(pages.get('site/search.json'))
  const urls = parts.map(({ url }) => url)
  assert.equal(new Set(urls).size, urls.length)
  for (const url of [
    'docs/how-to-rotate.html',
    'docs/noise.html',
    'docs/spaces.html',
    'gallery/bunny/',
  ])
    assert.ok(urls.includes(url), url)
})

describe('the first search result answers', () => {
  let search
  before(async () => {
    const { fetch } = globalThis
    globalThis.fetch = async () => new Response(pages.get('site/search.json'))
    search = await makeSearch('https://example.org/')
    globalThis.fetch = fetch
  })

  for (const [question, answer] of [
    ['rotate about an axis', 'docs/how-to-rotate.html'],
    ['use noise', /^docs\/(?:tutorial-3-noise|noise)\.html$/],
    ["what is space: 'world'", 'docs/spaces.html'],
    ['spaces', 'docs/spaces.html'],
    ['waving flag', 'docs/how-to-flag.html'],
    ['melting', /^docs\/deformers\.html#melt$/],
    ['melting bunny', /^docs\/(?:deformers\.html#melt|tutorial-5-your-model\.html)$/],
    ['load a model', /^docs\/tutorial-5-your-model\.html/],
    ['how do I install it', /^docs\/tutorial-1-first-warp\.html/],
    ['where do I start', /^docs\/tutorial-1-first-warp\.html/],
    ['lotus', 'gallery/lotus/'],
  ])
    test(question, () => {
      const [first] = search(question)
      if (answer instanceof RegExp) assert.match(first.url, answer)
      else assert.equal(first.url, answer)
    })

  test('with plain text', () => {
    const { text } = JSON.parse(pages.get('site/search.json')).find(
      ({ url }) => url === 'docs/how-to-rotate.html',
    )
    assert.match(text, /createWarp\(\(\{ glsl, position, millis \}\) => \{/)
    assert.doesNotMatch(pages.get('site/search.json'), /&#\w+;/)
  })
})

test('a build is a production build and restores NODE_ENV, even if servers run before and after it', async () => {
  const { NODE_ENV } = process.env
  const environments = []
  const entry = {
    name: 'entry',
    resolveId: (id) => id,
    load: () => {
      environments.push(process.env.NODE_ENV)
      return 'export {}'
    },
  }
  const build = { write: false, lib: { entry: 'entry.js', formats: ['es'] } }
  try {
    for (const value of [undefined, 'development']) {
      delete process.env.NODE_ENV
      if (value) process.env.NODE_ENV = value
      await viteBuild({ configFile: false, logLevel: 'silent', plugins: [entry], build })
      assert.equal(process.env.NODE_ENV, value)
    }
    assert.deepEqual(environments, ['production', 'production'])
  } finally {
    delete process.env.NODE_ENV
    if (NODE_ENV) process.env.NODE_ENV = NODE_ENV
  }
})
