// Tests the gallery: each example draws, alone and on its page, its shader code appears, and the console stays empty.
import assert from 'node:assert/strict'
import { mkdirSync, readdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { path } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import {
  assertPicture,
  measurePicture,
  reduceSketches,
  sketchesForTests,
  still,
  withoutEdges,
} from '../../tests/support/browser/examples.js'
import { drawLittle, fewFrames, keepFrames } from '../../tests/support/browser/frames.js'
import { serveSite, serveSources } from '../../tests/support/browser/site.js'
import { sections } from '../catalogue.js'

const screenshots = path('.build/screenshots')
const names = sections.flatMap(({ examples }) => examples.map(({ name }) => name))

/** Examples tested on their page in every run: a model, a shader from a file, and one with a second script. */
const everyday = ['airplane-twist', 'text-bulge', 'deformer-bend']
const testedOnPage = isRun('every example in the gallery') ? names : everyday
/** The example that is drawn with all its pixels. In the everyday run, this is not the model, whose edges take p5 seconds to compute. */
const fullExample = isRun('every example in the gallery') ? 'airplane-twist' : 'deformer-bend'

// Without a GPU, a frame can take seconds on a busy machine.
const patience = { timeout: 180_000 }

const desktop = { viewport: { width: 1280, height: 900 } }
const phone = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true }

/**
 * Returns whether an example is opened on a phone: if its sketch reads the window's size, and a few more. For the others the page is
 * resized.
 */
const isOpenedOnPhone = (name) =>
  name === names[0] || everyday.includes(name) || name.startsWith('three-')

let browser
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowser()
})
after(() => browser.close())

test('the gallery shows every folder of examples', () => {
  assert.deepEqual([...names].sort(), readdirSync(path('examples')).sort())
})

/** Stops a sketch when its page shows its frame rate. */
function stopWhenTimed() {
  const rate = () => frameElement?.closest('main').querySelector('.rate').textContent
  const timer = setInterval(() => {
    if (!rate()) return
    clearInterval(timer)
    if (window.noLoop) noLoop()
    else window.requestAnimationFrame = () => 0
  }, 100)
}

describe('the gallery of npm start', () => {
  let server, url
  before(async () => {
    server = await serveSources(5200, [sketchesForTests()])
    url = server.resolvedUrls.local[0]
  })
  after(() => server.close())

  describe('draws a frame of', () => {
    let context, page, messages
    before(async () => {
      context = await browser.newContext(desktop)
      await reduceSketches(context, url, { before: still })
      // Fix the time: on a busy machine the first frame is late and may show a thin side.
      await context.addInitScript('let now = 0; performance.now = () => (now += 100)')
      await context.addInitScript(keepFrames)
      // Use one page for all, so that p5 is compiled once.
      ;({ page, messages } = await openPage(context, `${url}recorder.js`))
    })
    after(() => context.close())

    // Skip the examples that are drawn on their page.
    const isDrawn = (name) =>
      !testedOnPage.includes(name) &&
      (name !== 'domain-warping-3d' || isRun('deep domain warping')) &&
      (!['three-glass', 'three-lanterns'].includes(name) || isRun('glass and lanterns'))
    for (const name of names.filter(isDrawn))
      test(name, async () => {
        await page.goto(`${url}examples/${name}/gallery.html`, patience)
        await page.waitForFunction(() => window.frameCount >= 1, null, patience)
        assertPicture(await measurePicture(page))
        assert.deepEqual(messages.splice(0), [])
      })
  })

  describe('on a desktop', () => {
    let page, messages, session
    before(async () => {
      const context = await browser.newContext(desktop)
      await reduceSketches(context, url, { exceptions: [fullExample], before: withoutEdges })
      for (const script of [stopWhenTimed, keepFrames, fewFrames])
        await context.addInitScript(script)
      ;({ page, messages } = await openPage(context, url))
      session = await context.newCDPSession(page)
    })
    after(() => page.context().close())

    /** Emulates the size and touch of another screen on the open page, until the session ends. */
    async function emulate({ viewport, isMobile = false }) {
      const screen = { ...viewport, deviceScaleFactor: 1, mobile: isMobile }
      await session.send('Emulation.setDeviceMetricsOverride', screen)
      await session.send('Emulation.setTouchEmulationEnabled', { enabled: isMobile })
    }

    test('begins with a warp, and a picture of each example', async () => {
      await page.waitForSelector('.hero canvas', patience)
      assert.equal(await page.locator('.tiles img').count(), names.length)
    })

    for (const name of testedOnPage)
      test(`shows ${name}`, async () => {
        const frame = await openPlaying(page, url, name)
        await page.getByText(/^frame \d+ · [\d.]+ fps$/).waitFor(patience)
        assertPicture(await measurePicture(frame))
        const code = page.locator('.block code')
        assert.match(await code.textContent(), /^(\/\/|import) /)
        await page.getByRole('button', { name: 'GLSL' }).click()
        await code
          .filter({ hasText: /^\/\/ \w+\n[^]*\b(float|vec[234]) \w+ ?[=(]/ })
          .waitFor(patience)
        await page.screenshot({ path: `${screenshots}/${name}.png` })
        assert.equal(await page.locator('iframe').count(), 1)
        if (isOpenedOnPhone(name)) return
        await emulate(phone)
        assert.equal(await page.evaluate('innerWidth'), phone.viewport.width)
        await assertFits(page, frame, name)
        await emulate(desktop)
      })

    test('lets the wheel scroll the page over a sketch', async () => {
      // This sketch rotates and zooms with the mouse.
      await openPlaying(page, url, 'deformer-bend')
      await page.locator('.stage').hover()
      const before = await page.evaluate(() => scrollY)
      await page.mouse.wheel(0, 400)
      await page.waitForFunction((y) => scrollY > y + 20, before, patience)
    })

    test('logs nothing', () => assert.deepEqual(messages, []))
  })

  if (isRun('the built gallery, and the gallery on a phone'))
    test('fits a phone screen, and so does each example', async () => {
      const context = await browser.newContext(phone)
      await reduceSketches(context, url, { before: still })
      const { page, messages } = await openPage(context, url)
      const width = await page.evaluate(() => document.documentElement.scrollWidth)
      assert.equal(width, phone.viewport.width)
      await page.screenshot({ path: `${screenshots}/phone-top.png` })

      for (const name of names.filter(isOpenedOnPhone)) {
        const frame = await openPlaying(page, url, name, 1)
        if (name === names[0]) assertPicture(await measurePicture(frame))
        await assertFits(page, frame, name)
        assert.equal(await frame.locator('.lil-gui.root:not(.closed)').count(), 0, name)
        await page.screenshot({ path: `${screenshots}/phone-${name}.png` })
      }
      await context.close()
      assert.deepEqual(messages, [])
    })
})

if (isRun('the built gallery, and the gallery on a phone'))
  test('the built gallery works from a folder of files', async () => {
    const server = await serveSite(5300)
    try {
      const url = server.resolvedUrls.local[0]
      const context = await browser.newContext(desktop)
      await drawLittle(context)
      const { page, messages } = await openPage(context, url)
      assertPicture(await measurePicture(await openPlaying(page, url, 'text-bulge')))
      await context.close()
      assert.deepEqual(messages, [])
    } finally {
      await server.close()
    }
  })

/** Opens the example's page, waits until it has drawn some frames, and returns the Playwright frame of its sketch. */
async function openPlaying(page, url, name, frames = 3) {
  await page.goto(`${url}gallery/${name}/index.html`, patience)
  const element = await page.waitForSelector('iframe.shown', patience)
  const frame = await element.contentFrame()
  await frame.waitForFunction((frames) => window.frameCount >= frames, frames, patience)
  return frame
}

async function assertFits(page, frame, name) {
  for (const place of [page, frame])
    assert.equal(
      await place.evaluate('innerWidth >= document.documentElement.scrollWidth'),
      true,
      `${name}, ${place === page ? 'its page' : 'the sketch'}`,
    )
}
