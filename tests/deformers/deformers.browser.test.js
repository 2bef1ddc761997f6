// The deformers in a page, loaded by a second script tag in p5 sketches, and by a bundler.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { launchBrowser, leavePage } from '../support/browser/browser.js'
import { colorAt } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { drawScenes, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const scripts = ['/dist/p5.warpjet.min.js', '/dist/warpjet.deformers.min.js']

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

for (const [version, p5] of p5InThisRun)
  describe(`script tags and p5 ${version}:`, () => {
    test('the global warpjet has the deformers, and a sketch draws warps made with them', async () => {
      const { right, local } = await drawScenes(browser, server, [p5, ...scripts], {
        size: 200,
        setup: `
          const { chain, inflate, inSpace, mask } = warpjet
          const along = inflate({ amount: 40, direction: [1, 0, 0] })
          const down = inflate({ direction: [1, 0, 0], amount: ({ uniforms }) => uniforms.far })
          const turned = [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
          warps.right = createWarp(chain(along, inSpace(turned, down)), {
            space: 'world',
            uniforms: { far: 10 },
          })
          warps.local = createWarp(mask(along, 0))`,
        scenes: {
          right: `warps.right({ far: 30 }); fill('red'); plane(20)`,
          local: `warps.local(); fill('red'); plane(20)`,
        },
      })
      const redAt = (image) => {
        const isRed = ([x, y]) => colorAt(image, 100 + x, 100 + y)[0] === 255
        return [
          [0, 0],
          [40, 0],
          [40, 30],
          [40, -30],
        ].map(isRed)
      }
      assert.deepEqual(redAt(right), [false, false, true, false])
      assert.deepEqual(redAt(local), [true, false, false, false])
    })

    test('there is only one class WarpError', async () => {
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, ...scripts],
        `let caught
        try { warpjet.twist({ angle: 'fast' }) } catch (error) { caught = error }
        window.same = caught instanceof warpjet.WarpError
        window.errorMessage = caught.message
        window.done = true`,
      )
      assert.equal(await page.evaluate('same'), true)
      assert.match(
        await page.evaluate('errorMessage'),
        /^twist: expected a number, .* for the option "angle", got the text "fast"/,
      )
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })

test('the second script throws a message if the first one is missing', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    scripts.slice(1),
    'window.done = true',
  )
  await leavePage(page)
  assert.deepEqual(messages, [
    'uncaught: warpjet: the script p5.warpjet.min.js must be loaded by a tag before this one.',
  ])
})
