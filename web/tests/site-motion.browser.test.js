// Tests motion on the site: the first page's warp follows the pointer, nothing draws while it is out of view, reduced motion is respected,
// and without WebGL there are pictures.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { desktop, phone } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { disableAntialiasing, drawLittle, keepFrames } from '../../tests/support/browser/frames.js'
import { waitUntilSettled } from '../../tests/support/browser/playground.js'
import { serveSite, withReducedMotion, withoutWorker } from '../../tests/support/browser/site.js'

const patience = { timeout: 120_000 }

let browser, server, url
before(async () => {
  browser = await launchBrowser()
  server = await serveSite(5345, '/some/folder/')
  url = server.resolvedUrls.local[0]
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Fixes the time, so that only the pointer moves anything, and counts draw calls. */
function fixTime() {
  const { requestAnimationFrame } = window
  window.requestAnimationFrame = (work) => requestAnimationFrame(() => work(2000))
  const { drawElements } = WebGL2RenderingContext.prototype
  window.draws = 0
  WebGL2RenderingContext.prototype.drawElements = function (...args) {
    window.draws++
    return drawElements.apply(this, args)
  }
}

/** Returns how far the ball extends to the left and right of the center of its element, as fractions of its width. */
const measureReach = (page) =>
  page.locator('.hero canvas').evaluate((canvas) => {
    const { width, height } = canvas
    const copy = new OffscreenCanvas(width, height).getContext('2d')
    copy.drawImage(canvas, 0, 0)
    const { data } = copy.getImageData(0, 0, width, height)
    const isEmpty = (x) => {
      for (let y = 0; y < height; y++) if (data[4 * (y * width + x) + 3]) return false
      return true
    }
    let [left, right] = [0, width - 1]
    while (left < width && isEmpty(left)) left++
    while (right > left && isEmpty(right)) right--
    return { left: 0.5 - left / width, right: (right + 1) / width - 0.5 }
  })

const countDraws = async (page, milliseconds) => {
  const before = await page.evaluate(() => window.draws)
  await page.waitForTimeout(milliseconds)
  return (await page.evaluate(() => window.draws)) - before
}

test('the first page’s ball swells towards the pointer, and draws only while it is in view', async () => {
  // Use a sixteenth of the pixels.
  const context = await browser.newContext({ ...desktop, deviceScaleFactor: 0.25 })
  for (const script of [withoutWorker, keepFrames, disableAntialiasing, fixTime])
    await context.addInitScript(script)
  const { page, messages } = await openPage(context, url)
  await page.waitForSelector('.hero canvas', patience)
  const { x, y, width, height } = await page.locator('.hero .picture').boundingBox()
  const reach = {}
  for (const [side, fraction] of [
    ['left', 0.1],
    ['right', 0.9],
  ]) {
    await page.mouse.move(x + fraction * width, y + height / 2)
    const from = await page.evaluate(() => window.draws)
    await page.waitForFunction((from) => window.draws > from + 60, from, patience)
    reach[side] = await measureReach(page)
  }
  const { left, right } = reach
  assert.ok(left.left > right.left + 0.04, JSON.stringify(reach))
  assert.ok(right.right > left.right + 0.04, JSON.stringify(reach))

  await page.evaluate(() => scrollTo({ top: document.body.scrollHeight, behavior: 'instant' }))
  // Waits for the end of a frame in progress.
  for (let i = 0; i < 20 && (await countDraws(page, 300)); i++);
  assert.equal(await countDraws(page, 500), 0)
  await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }))
  const from = await page.evaluate(() => window.draws)
  await page.waitForFunction((from) => window.draws > from + 2, from, patience)
  await context.close()
  assert.deepEqual(messages, [])
})

test('an example runs only while it is in view', async () => {
  const context = await browser.newContext({ viewport: { width: 700, height: 500 } })
  await context.addInitScript(withoutWorker)
  await drawLittle(context)
  const { page, messages } = await openPage(context, `${url}gallery/deformer-shear/index.html`)
  await page.locator('.stage').evaluate((stage) => stage.scrollIntoView())
  await page.waitForSelector('iframe.shown', patience)
  await page.evaluate(() => scrollTo({ top: document.body.scrollHeight, behavior: 'instant' }))
  await page.waitForFunction(() => !document.querySelector('iframe'), null, patience)
  assert.equal(await page.locator('.stage img').count(), 1)
  await page.locator('.stage').evaluate((stage) => stage.scrollIntoView())
  await page.waitForSelector('iframe.shown', patience)
  await context.close()
  assert.deepEqual(messages, [])
})

test('the full page of an example describes it, fills the window, and links back', async () => {
  const context = await browser.newContext(desktop)
  await context.addInitScript(withoutWorker)
  await drawLittle(context)
  const { page, messages } = await openPage(context, `${url}gallery/deformer-shear/index.html`)
  await page.getByRole('link', { name: 'Full page' }).click()
  await page.waitForSelector('iframe.shown', patience)
  assert.match(await page.title(), /^Italics, full page/)
  assert.match(await page.locator('h1').textContent(), /Italics/)
  assert.match(await page.locator('.text').textContent(), /Points move sideways/)
  const { width, height } = await page.locator('iframe').boundingBox()
  assert.ok(width === desktop.viewport.width && height > 0.7 * desktop.viewport.height)
  // The picture is centered and as large as fits.
  const canvas = await page.frameLocator('iframe').locator('.p5Canvas').boundingBox()
  const maxWidth = Math.min(width, (height * 4) / 3)
  assert.ok(Math.abs(canvas.width - maxWidth) < 1, `${canvas.width} of ${maxWidth}`)
  assert.ok(Math.abs((4 / 3) * canvas.height - maxWidth) < 2)
  await page.getByRole('button', { name: 'Pause' }).click()
  assert.equal(await page.locator('iframe').count(), 0)
  await page.getByRole('link', { name: 'Sketch and sliders' }).click()
  await page.waitForURL(/deformer-shear\/$/)
  await context.close()
  assert.deepEqual(messages, [])
})

test('with reduced motion the first page does not move, and an example starts paused', async () => {
  const context = await browser.newContext({ ...withReducedMotion(desktop) })
  await context.addInitScript(withoutWorker)
  const { page } = await openPage(context, url)
  await page.waitForSelector('.hero canvas', patience)
  await page.waitForTimeout(300)
  const first = await page.locator('.hero canvas').screenshot()
  await page.mouse.move(900, 300)
  await page.waitForTimeout(500)
  assert.deepEqual(await page.locator('.hero canvas').screenshot(), first)
  await page.goto(`${url}gallery/deformer-bend/index.html`)
  assert.equal(await page.locator('iframe').count(), 0)
  await page.getByRole('button', { name: 'Play' }).click()
  await page.waitForSelector('iframe.shown', patience)
  await context.close()
})

test('without WebGL there are pictures, which fit a phone, and no pause button', async () => {
  const context = await browser.newContext({ ...phone })
  await context.addInitScript(withoutWorker)
  await context.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null))
  const { page, messages } = await openPage(context, url)
  await page.waitForTimeout(500)
  const isLoaded = (selector) => page.locator(selector).evaluate((image) => image.naturalWidth > 0)
  const assertFits = async () =>
    assert.equal(
      await page.evaluate(() => document.documentElement.scrollWidth),
      phone.viewport.width,
      page.url(),
    )
  assert.equal(await page.locator('.hero canvas').count(), 0)
  assert.ok(await isLoaded('.hero img'))
  await assertFits()
  for (const file of ['index', 'full']) {
    await page.goto(`${url}gallery/deformer-bend/${file}.html`)
    assert.ok(await isLoaded('.stage img'))
    assert.match(await page.locator('.rate').textContent(), /no WebGL/)
    assert.equal(await page.locator('.pause').isVisible(), false)
    await assertFits()
  }
  await page.goto(`${url}playground/index.html#example=lotus`)
  await waitUntilSettled(page)
  await page.locator('.still').evaluate((image) => image.decode())
  assert.match(await page.locator('.still').getAttribute('src'), /lotus/)
  assert.match(await page.locator('.stage').textContent(), /no WebGL/)
  await assertFits()
  for (const file of ['drop', 'bench']) {
    await page.goto(`${url}${file}/index.html`)
    await page.locator('main img').evaluate((image) => image.decode())
    assert.match(await page.getByRole('alert').textContent(), /WebGL ?2/)
    await assertFits()
  }
  assert.deepEqual(messages, [])
  await context.close()
})
