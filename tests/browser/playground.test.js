// The playground: what one writes is what one sees, mistakes cost nothing, and a link brings a sketch back.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { createServer } from 'vite'
import { config, desktop, difference, path } from './support/bench.js'
import { launchBrowser, openPage } from './support/browser.js'
import { canvasPixels, line, settled, text, write } from './support/playground.js'

const screenshots = path('.build/screenshots')

let browser, server, url
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowser()
  server = await createServer({ ...config, server: { port: 5240, watch: null } })
  await server.listen()
  url = `${server.resolvedUrls.local[0]}playground/index.html`
})
after(async () => {
  await browser.close()
  await server.close()
})

/** A still picture of one color, which `line` of the sketch moves. */
const still = (color, offset = 'glsl.vec3(0, 0, 0)', more = '') => `let warp
function setup() {
  createCanvas(120, 90, WEBGL)
  noStroke()
  warp = createWarp(({ glsl, position, uniforms }) => ${offset}${more})
}
function draw() {
  background('#151823')
  fill('${color}')
  warp()
  sphere(30, 24, 16)
}
`

describe('the playground', () => {
  let page, messages, context
  before(async () => {
    context = await browser.newContext({ ...desktop, reducedMotion: 'reduce' })
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    ;({ page, messages } = await openPage(context, url))
    await settled(page)
  })
  after(() => context.close())

  test('begins with a sketch that runs, and its text in three languages', async () => {
    assert.match(await text(page), /createWarp/)
    assert.match(await page.locator('#panel').textContent(), /vec3 offset, warpedPosition/)
    await page.getByRole('tab', { name: 'WGSL' }).click()
    assert.match(await page.locator('#panel').textContent(), /var offset: vec3f/)
    for (const name of ['WGSL', 'GLSL 1.00'])
      await page.getByRole('tab', { name }).press('ArrowLeft')
    assert.equal(
      await page.getByRole('tab', { name: 'GLSL 3.00' }).getAttribute('aria-selected'),
      'true',
    )
    await page.screenshot({ path: `${screenshots}/playground.png` })
  })

  test('shows what is typed once one pauses', async () => {
    await write(page, still('#ff0000'))
    const red = await canvasPixels(page)
    await write(page, still('#0000ff'))
    const blue = await canvasPixels(page)
    assert.ok(difference(red, blue) > 0.1)
    await write(page, still('#0000ff', 'glsl.vec3(1, 0, 0)'))
    assert.ok(difference(blue, await canvasPixels(page)) > 0.1)
  })

  test('keeps the last good picture at a mistake, and marks its line with a sentence', async () => {
    await write(page, still('#00ff00'))
    const before = await canvasPixels(page)
    const mistakes = [
      [still('#00ff00', 'glsl.vec2(0, 0)'), 5, /must return a vec3/],
      [still('#00ff00', 'position.mlt(2)'), 5, /mlt/],
      [still('#00ff00', 'position + 1'), 5, /\+/],
      [still('#00ff00').replace('noStroke()', 'noStroke('), 4, /^SyntaxError: /, 5],
      [still('#00ff00').replace('warp()', 'wrap()'), 10, /^ReferenceError: wrap/],
      [
        still('#00ff00')
          .replace('function setup', 'async function setup')
          .replace('noStroke()', "await loadModel('nowhere.obj')"),
        4,
        /./,
      ],
    ]
    for (const [sketch, number, sentence, other = number] of mistakes) {
      await write(page, sketch)
      const mistake = await page.locator('.mistake').textContent()
      assert.match(mistake.replace(/^Line \d+ /, ''), sentence)
      const named = Number(/^Line (\d+) /.exec(mistake)?.[1])
      assert.ok(named === number || named === other, `${mistake}, not line ${number}`)
      assert.equal(await page.locator('.cm-lint-marker-error').count(), 1, mistake)
      assert.equal(difference(before, await canvasPixels(page)), 0)
      assert.doesNotMatch(mistake, /blob:|warps\.js/)
    }
    await page.screenshot({ path: `${screenshots}/playground-mistake.png` })
    await page.getByRole('button', { name: /^Line / }).click()
    assert.match(await line(page), /loadModel/)
    await write(page, still('#00ff00'))
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.equal(await page.locator('.cm-lint-marker-error').count(), 0)
    // The browser and p5 have said of the model that it is not there.
    assert.equal(messages.splice(0).length, 2)
  })

  test('undoes what was typed, and redoes it', async () => {
    await write(page, still('#ffff00'))
    const yellow = await canvasPixels(page)
    await write(page, still('#ff00ff'))
    await page.keyboard.press('Control+z')
    await settled(page)
    assert.equal(await text(page), still('#ffff00'))
    assert.equal(difference(yellow, await canvasPixels(page)), 0)
    await page.keyboard.press('Control+y')
    await settled(page)
    assert.equal(await text(page), still('#ff00ff'))
  })

  test('brings a sketch back by its link', async () => {
    const sketch = still('#ff8000', 'glsl.vec3(0, 0.5, 0) /* ≠ “ä” 🌸 */')
    await write(page, sketch)
    const before = await canvasPixels(page)
    await page.getByRole('button', { name: 'Copy link' }).click()
    const link = await page.evaluate(() => navigator.clipboard.readText())
    assert.ok(link.length < 800, `${link.length} characters`)
    const other = await openPage(context, link)
    await settled(other.page)
    assert.equal(await text(other.page), sketch)
    assert.equal(difference(before, await canvasPixels(other.page)), 0)
    assert.deepEqual(other.messages, [])
    await other.page.close()
  })

  test('says that a link is damaged, and keeps the sketch', async () => {
    const before = await text(page)
    await page.evaluate(() => (location.hash = '#sketch=brokenlink'))
    await page.getByText('The sketch in this link is damaged').waitFor()
    assert.equal(await text(page), before)
  })

  test('has printed nothing of its own', () => assert.deepEqual(messages, []))
})
