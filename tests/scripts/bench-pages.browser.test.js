// Tests the interactive page of the benchmark as a visitor uses it, and both built pages of the benchmark.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { methods } from '../../web/bench/methods.js'
import {
  cells,
  choose,
  desktop,
  difference,
  phone,
  pixels,
  readFigures,
  timeoutOptions,
  waitUntilMeasured,
} from '../support/browser/bench.js'
import { launchBrowser, openPage } from '../support/browser/browser.js'
import { serveSite, serveSources } from '../support/browser/site.js'

const names = methods.map(({ name }) => name)
/** Reduced motion pauses the animation at first, so that all methods show the same moment. */
const stillDesktop = { ...desktop, reducedMotion: 'reduce' }

let browser, server, url
before(async () => {
  browser = await launchBrowser()
  server = await serveSources(5210)
  url = server.resolvedUrls.local[0]
})
after(async () => {
  await browser.close()
  await server.close()
})

describe('the interactive benchmark', () => {
  /** Opens the page after `prepare(context)` has changed its browser context. */
  async function openInteractive(options, prepare) {
    const context = await browser.newContext(options)
    await prepare?.(context)
    return openPage(context, `${url}bench/index.html?size=240`)
  }

  describe('on a desktop', () => {
    let page, messages
    before(async () => {
      ;({ page, messages } = await openInteractive(stillDesktop))
      await waitUntilMeasured(page)
    })
    after(() => page.context().close())

    test('draws, and does not move if the visitor prefers reduced motion', async () => {
      const first = await pixels(page)
      const empty = Buffer.alloc(first.length)
      for (let i = 0; i < empty.length; i += 4) empty.set([0x15, 0x18, 0x23, 0xff], i)
      const covered = difference(first, empty)
      assert.ok(covered > 0.03 && covered < 0.6, `${(100 * covered).toFixed()}% are mesh`)
      assert.equal(difference(first, await pixels(page)), 0)
    })

    test('shows the size of the mesh and the offset', async () => {
      assert.deepEqual(
        await readFigures(page, ['vertices', 'triangles', 'nodes']),
        [14363, 27360, 15],
      )
    })

    for (const name of names)
      test(`draws with the method ${name}`, async () => {
        await choose(page, name)
        const [rate, frame, first, error] = await readFigures(page, [
          'rate',
          'frame',
          'first',
          'error',
        ])
        for (const value of [rate, frame, first]) assert.ok(value > 0 && value < 60_000, value)
        const range = {
          warpjet: [1e-4, 0.02],
          'by hand': [1e-4, 0.02],
          'central differences': [1e-3, 0.2],
          'forward differences': [1e-3, 0.5],
          'positions only': [50, 100],
        }
        const [min, max] = range[name] ?? [1e-4, 180]
        assert.ok(error > min && error < max, `off by ${error}°`)
      })

    test('shows wrong lighting for moved positions with unchanged normals', async () => {
      const shots = {}
      for (const name of ['warpjet', 'by hand', 'positions only']) {
        await choose(page, name)
        shots[name] = await pixels(page)
      }
      assert.ok(difference(shots.warpjet, shots['by hand']) < 0.001)
      assert.ok(difference(shots.warpjet, shots['positions only']) > 0.02)
    })

    test('finds a better step for finite differences', async () => {
      await choose(page, 'forward differences')
      const step = page.getByText(/^h = /)
      assert.equal(await step.textContent(), 'h = 0.1')
      const [before] = await readFigures(page, ['error'])
      await page.getByRole('button', { name: 'find the best h' }).click()
      await page.getByText(/^h = (?!0\.1$)/).waitFor(timeoutOptions)
      await page.waitForFunction(
        (before) => parseFloat(document.querySelector('dd.error').textContent) !== before,
        before,
        timeoutOptions,
      )
      const [after] = await readFigures(page, ['error'])
      assert.ok(after < before, `${after}° is not less than ${before}°`)
    })

    test('moves over time if motion is switched on', async () => {
      const before = await pixels(page)
      await page.getByRole('checkbox').check()
      const end = Date.now() + 30_000
      while (difference(before, await pixels(page)) <= 0.01) {
        assert.ok(Date.now() < end, 'nothing moved for 30 s')
        await page.waitForTimeout(200)
      }
      await page.getByRole('checkbox').uncheck()
    })

    test('rotates the mesh when dragged', async () => {
      const before = await pixels(page)
      const { x, y, width, height } = await page.locator('canvas').boundingBox()
      await page.mouse.move(x + width / 2, y + height / 2)
      await page.mouse.down()
      await page.mouse.move(x + width / 2 + 80, y + height / 2, { steps: 4 })
      await page.mouse.up()
      // On a busy machine the next frame can be late.
      let changed = 0
      for (let i = 0; i < 100 && !(changed > 0.01); i++) {
        await page.waitForTimeout(100)
        changed = difference(before, await pixels(page))
      }
      assert.ok(changed > 0.01)
    })

    test('measures the selected mesh and offset, and stops on request', async () => {
      await page.getByRole('button', { name: 'Measure this row' }).click()
      await page.getByText(/^Measuring: round/).waitFor(timeoutOptions)
      await page.getByRole('button', { name: 'Stop measuring' }).click()
      await page.getByRole('button', { name: 'Measure this row' }).click(timeoutOptions)
      assert.equal(await page.locator('table').count(), 0)

      const table = page.locator('.measured table')
      await table.waitFor(timeoutOptions)
      const lines = await cells(table)
      assert.deepEqual(
        lines.map(([name]) => name),
        names,
      )
      // The columns: method, median of the frame times, lower quartile, upper quartile, ratio to positions only, ratio to warpjet, first draw
      // with compilation, its ratio to positions only.
      for (const [name, ...figures] of lines)
        for (const figure of figures.slice(0, 7))
          assert.ok(Number(figure) > 0, `${name}: ${figure}`)
      const [, , ...warpjetFigures] = lines[names.indexOf('warpjet')]
      assert.equal(warpjetFigures[3], '1.00')
    })

    test('logs nothing, and shows no error', async () => {
      assert.deepEqual(messages, [])
      assert.equal(await page.getByRole('alert').textContent(), '')
    })
  })

  test('draws the mesh and offset that are selected', async () => {
    const { page, messages } = await openInteractive(stillDesktop)
    await waitUntilMeasured(page)
    await page.locator('.panel select').first().selectOption('14,000 × 3,000')
    await page.locator('dd.nodes').getByText('3,000').waitFor(timeoutOptions)
    await waitUntilMeasured(page)
    const [error] = await readFigures(page, ['error'])
    assert.ok(error < 0.001, `off by ${error}°`)
    await page.context().close()
    assert.deepEqual(messages, [])
  })

  test('fits a phone', async () => {
    const { page, messages } = await openInteractive(phone)
    await waitUntilMeasured(page)
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360)
    await page.context().close()
    assert.deepEqual(messages, [])
  })

  test('shows a message and a picture if there is no WebGL 2', async () => {
    const { page, messages } = await openInteractive(desktop, (context) =>
      context.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null)),
    )
    assert.match(await page.getByRole('alert').textContent(), /needs WebGL 2/)
    assert.equal(await page.locator('canvas').count(), 0)
    await page.locator('main img').evaluate((image) => image.decode())
    await page.context().close()
    assert.deepEqual(messages, [])
  })

  test('shows a message if a shader does not compile, and continues with another one', async () => {
    const { page } = await openInteractive(stillDesktop, (context) =>
      context.addInitScript(() => {
        const prototype = WebGL2RenderingContext.prototype
        const { shaderSource } = prototype
        prototype.shaderSource = function (shader, text) {
          shaderSource.call(this, shader, text.replace('uniform float h;', 'uniform nonsense h;'))
        }
      }),
    )
    await waitUntilMeasured(page)
    await page.locator('.panel select').nth(1).selectOption('central differences')
    const alert = page.getByRole('alert')
    await alert
      .getByText('The shader of central differences does not compile')
      .waitFor(timeoutOptions)
    await choose(page, 'dFdx')
    assert.equal(await alert.textContent(), '')
    await page.context().close()
  })
})

test('both built pages work in any folder, and the gallery links to them', async () => {
  const base = '/any/folder/'
  const built = await serveSite(5310, base)
  try {
    const { page, messages } = await openPage(
      await browser.newContext(stillDesktop),
      new URL(base, built.resolvedUrls.local[0]).href,
    )
    await page.getByRole('link', { name: 'Measured', exact: true }).click()
    await page.getByRole('heading', { name: 'What correct normals cost' }).waitFor(timeoutOptions)
    await page.locator('.plot svg, .nothing:not([hidden])').first().waitFor(timeoutOptions)
    await page.getByRole('link', { name: 'The interactive benchmark' }).click()
    await waitUntilMeasured(page)
    await page.getByRole('link', { name: 'gallery' }).click()
    await page.getByRole('heading', { name: 'warpjet', exact: true }).waitFor(timeoutOptions)
    await page.context().close()
    assert.deepEqual(messages, [])
  } finally {
    await built.close()
  }
})
