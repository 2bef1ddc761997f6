// Runs the README's sketch and the blocks of the docs with a “Run” link in the playground, as a reader does: they draw or print without
// errors. The blocks below the plots are much alike: only one per group runs here, and web/tests/plots.test.js checks what each of them
// computes.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { walk } from '../../.scripts/lib/files.mjs'
import { desktop, path } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { coarse, disableAntialiasing, keepFrames } from '../../tests/support/browser/frames.js'
import {
  canvasPixels,
  editorText,
  waitUntilSettled,
} from '../../tests/support/browser/playground.js'
import { serveSite, withoutWorker } from '../../tests/support/browser/site.js'
import { blocksOf } from '../site/markdown.js'
import { linkTo } from '../site/runnable.js'

const blocks = ['README.md', ...walk('web/docs', /\.md$/)].flatMap((file) => {
  const text = readFileSync(path(file), 'utf8')
  const runnable = blocksOf(text).filter(({ sketch }) => sketch)
  const groups = text.split('\n').flatMap((line, i) => (line.startsWith('## ') ? [i + 1] : []))
  const findFirst = (i) => runnable.find(({ line }) => line > groups[i] && !(line > groups[i + 1]))
  const firsts = groups.map((_, i) => findFirst(i)).filter(Boolean)
  const tested = /\/plots/.test(file) ? firsts : runnable
  return tested.map((block) => ({ ...block, place: `${file}:${block.line}` }))
})

/** Stops a sketch after the frames it needs to be shown, since without a GPU frames take most of the time. */
const stopEarly = ({ host, text }) => text + (host === 'p5' ? stopAfterFrames : '')
const stopAfterFrames = `
{
  const { draw } = window
  window.draw = () => (frameCount > 2 ? noLoop() : draw())
}
`

let browser, server, url, page, messages
before(async () => {
  browser = await launchBrowser()
  server = await serveSite(5350)
  url = `${server.resolvedUrls.local[0]}playground/index.html`
  const context = await browser.newContext(desktop)
  for (const script of [withoutWorker, keepFrames, disableAntialiasing, coarse])
    await context.addInitScript(script)
  ;({ page, messages } = await openPage(context, url))
  await waitUntilSettled(page)
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Counts the colours of the picture. */
async function countColours() {
  const data = await canvasPixels(page)
  return new Set(new Uint32Array(Uint8Array.from(data).buffer)).size
}

for (const { place, sketch } of blocks)
  test(place, async () => {
    const changed = { ...sketch, text: stopEarly(sketch) }
    await page.evaluate((hash) => {
      document.querySelector('main').ariaBusy = 'true'
      location.hash = hash
    }, linkTo(changed))
    for (let i = 0; (await editorText(page)) !== changed.text && i < 200; i++)
      await page.waitForTimeout(50)
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    await page.getByRole('tab', { name: 'Console' }).click()
    const complaints = await page.locator('.printed :is(.warn, .error)').allTextContents()
    assert.deepEqual(complaints, [])
    if (/\bprint\(/.test(sketch.text)) assert.ok(await page.locator('.printed li').count())
    // A flat plane has one colour, besides that of the background.
    else assert.ok((await countColours()) > 1, 'expected a picture, got a single colour')
    // Sketches also print to the page's console.
    if (!/\bprint\(/.test(sketch.text)) assert.deepEqual(messages, [])
    messages.splice(0)
  })
