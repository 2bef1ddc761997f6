// Sketches draw the same picture on p5 1.11 as on p5 2: all of the docs, the README and the gallery that have no comment "p5 2", and the
// playground's default sketch.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { walk } from '../../.scripts/lib/files.mjs'
import { sections } from '../../web/catalogue.js'
import { convert } from '../../web/playground/convert.js'
import { tagsOf } from '../../web/playground/hosts.js'
import { blocksOf } from '../../web/site/markdown.js'
import { path } from '../support/browser/bench.js'
import { launchBrowser, leavePage, openPage } from '../support/browser/browser.js'
import { coarseShapes } from '../support/browser/examples.js'
import { beyondEdges, readPixels } from '../support/browser/pixels.js'
import { serveSources } from '../support/browser/site.js'
import { encodeImage } from '../support/png.js'

// The module with the playground's default sketch reads the address of the page.
globalThis.location ??= new URL('http://localhost/playground/index.html')
const { starters } = await import('../../web/playground/examples.js')

const screenshots = path('.build/screenshots/p5-1')

/** Tests for a comment with "p5 2", which marks sketches that 1.11 cannot run. */
const isForP5v2 = ([, text]) => /^ *\/\/ .*\bp5 2\b/m.test(text)

/** [name, source, additional scripts] of each sketch. */
const all = [
  ['the playground', starters.p5.text ?? starters.p5, []],
  ...['README.md', ...walk('web/docs', /\.md$/)]
    .filter((file) => !/\/plots/.test(file))
    .flatMap((file) =>
      blocksOf(readFileSync(path(file), 'utf8'))
        .filter(({ sketch }) => sketch?.host === 'p5')
        .map(({ sketch, line }) => [`${file}:${line}`, sketch.text, sketch.chosen]),
    ),
  ...sections.flatMap(({ examples, scripts = [] }) =>
    examples
      .filter(({ name }) => !name.startsWith('three-'))
      .map(({ name, scripts: own = [] }) => [
        `examples/${name}`,
        readFileSync(path(`examples/${name}/sketch.js`), 'utf8'),
        [...scripts, ...own],
      ]),
  ),
]
const sketches = all.filter((sketch) => !isForP5v2(sketch))

/** Code that fixes the time, seeds random numbers, draws one frame, and reduces pixels and shapes. */
const setUpStill = `
{
  let seed = 1
  Math.random = () => (seed = (seed * 16807) % 2147483647) / 2147483647
  p5.prototype.millis = () => 1700
  // Removes the edges of shapes. Warps do not draw them, and p5 takes seconds to compute those of a model.
  p5.Geometry.prototype._edgesToVertices = function () { return this }
  const { createCanvas, pixelDensity } = p5.prototype
  p5.prototype.createCanvas = function (...size) {
    const canvas = createCanvas.apply(this, size)
    pixelDensity.call(this, 0.5)
    this.noLoop()
    return canvas
  }
  p5.prototype.pixelDensity = function (density) {
    return density ? this : pixelDensity.call(this)
  }
  ${coarseShapes}
}`

const pages = []
/** Vite plugin: serves `pages` in the playground's folder of files, from which sketches load models and fonts by relative addresses. */
const servePages = {
  name: 'pages',
  configureServer({ middlewares }) {
    middlewares.use((request, response, next) => {
      const page = pages[/^\/playground\/files\/(\d+)\.html$/.exec(request.url)?.[1]]
      if (page === undefined) return next()
      response.setHeader('Content-Type', 'text/html; charset=utf-8')
      response.end(page)
    })
  },
}

let browser, server, url
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  server = await serveSources(5270, [servePages])
  url = server.resolvedUrls.local[0]
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Draws a sketch on a host. Returns { image, messages }. */
async function drawSketch([name, text, chosen], host) {
  const number = pages.push(`<!doctype html>
<meta charset="utf-8">
<link rel="icon" href="data:,">
<style>body { margin: 0 }</style>
${tagsOf({ host, chosen })
  .map((file) => `<script src="${file}"></script>`)
  .join('\n')}
<script>${setUpStill}</script>
<script>${convert(text, host)}
{
  const { setup } = window
  window.setup = () => (window.ready = setup())
}
</script>`)
  const { page, messages } = await openPage(browser, `${url}playground/files/${number - 1}.html`)
  await page.waitForFunction(() => window.frameCount >= 1, null, { timeout: 120_000 })
  // p5 1.11 does not wait for an async setup.
  await page.evaluate('ready')
  // Fonts and graphics create canvases, too: moves that of the sketch to the front.
  await page.evaluate(() => document.body.prepend(document.getElementById('defaultCanvas0')))
  await page.evaluate('redraw()')
  const image = await readPixels(page)
  writeFileSync(`${screenshots}/${name.replaceAll(/\W/g, '-')}.${host}.png`, encodeImage(image))
  await leavePage(page)
  return { image, messages }
}

const countColours = ({ data }) =>
  new Set(new Uint32Array(data.buffer, data.byteOffset, data.length / 4)).size

for (const sketch of sketches)
  test(sketch[0], async () => {
    const [newP5, oldP5] = [await drawSketch(sketch, 'p5'), await drawSketch(sketch, 'p5-1')]
    const prints = /\bprint\(/.test(sketch[1])
    assert.deepEqual(newP5.messages, prints ? oldP5.messages : [], 'printed by p5 2')
    assert.deepEqual(oldP5.messages, prints ? newP5.messages : [], 'printed by p5 1.11')
    if (prints) return
    const { width, height } = newP5.image
    assert.ok(countColours(newP5.image) >= 5, `${countColours(newP5.image)} colours`)
    const beyond = beyondEdges(oldP5.image, newP5.image, 12)
    assert.ok(beyond <= 0.01 * width * height, `${beyond} pixels differ`)
  })

test('few sketches need p5 2', () => {
  assert.ok(sketches.length >= 0.75 * all.length, `${sketches.length} of ${all.length}`)
})
