// createWarp on unusual pages: in instance mode, with several sketches or versions of p5, as a module, and on canvases that change.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage, openPage } from '../support/browser/browser.js'
import { addon } from '../support/browser/p5-hosts.js'
import { colorAt, readPixels } from '../support/browser/pixels.js'
import {
  drawScenes,
  openHost,
  p5InThisRun,
  p5Versions,
  runSketch,
} from '../support/browser/sketch.js'

const size = 200

const { browser, server } = await openHost()

/** The arguments of createWarp for a warp that moves shapes by 40 pixels to the right. */
const toTheRight = `({ glsl }) => glsl.vec3(40, 0, 0), { space: 'world' }`

const assertRedAt = (image, x, y) =>
  assert.deepEqual(colorAt(image, size / 2 + x, size / 2 + y), [255, 0, 0])

for (const [version, p5] of p5InThisRun) {
  describe(`a page with createWarp and p5 ${version}`, () => {
    test('works in instance mode and in a p5.Graphics', async () => {
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, addon],
        `new p5((p) => {
          let layer, down, right
          p.setup = () => {
            p.pixelDensity(1)
            p.createCanvas(${size}, ${size}, p.WEBGL)
            right = p.createWarp(${toTheRight})
            layer = p.createGraphics(100, 100, p.WEBGL)
            down = layer.createWarp(
              ({ glsl, size, millis }) => glsl.vec3(0, size.x().mult(0.2).add(millis.min(10)), 0),
              { space: 'world' },
            )
            p.noLoop()
          }
          p.draw = () => {
            p.background(0)
            layer.fill('red')
            down()
            layer.plane(20)
            p.image(layer, -50, -50)
            p.fill('red')
            right()
            p.plane(20)
            window.done = true
          }
        })`,
      )
      const image = await readPixels(page)
      await leavePage(page)
      assert.deepEqual(messages, [])
      assertRedAt(image, 0, 30)
      assertRedAt(image, 40, 0)
    })

    test('leaves the length of stack traces as it is', async () => {
      const { image } = await drawScenes(browser, server, [p5, addon], {
        size,
        setup: `
          Error.stackTraceLimit = 7
          distort = createWarp(${toTheRight})
          if (Error.stackTraceLimit !== 7) throw new Error('got ' + Error.stackTraceLimit)`,
        scenes: { image: `distort(); fill('red'); plane(20)` },
      })
      assertRedAt(image, 40, 0)
    })

    test('works if its script precedes that of p5, and if it is included twice', async () => {
      const { image } = await drawScenes(browser, server, [addon, p5, addon], {
        size,
        setup: `distort = createWarp(${toTheRight})`,
        scenes: { image: `distort(); fill('red'); plane(20)` },
      })
      assertRedAt(image, 40, 0)
    })

    test('follows the canvas when setAttributes replaces it, here by a WebGL 1 canvas', async () => {
      const { image } = await drawScenes(browser, server, [p5, addon], {
        size,
        setup: `
          distort = createWarp(${toTheRight})
          distort()
          setAttributes({ version: 1 })`,
        scenes: { image: `distort(); fill('red'); plane(20)` },
      })
      assertRedAt(image, 40, 0)
    })
  })
}

/** Returns code that starts a sketch in instance mode; `code` runs at the end of draw(). */
const instance = (name, code) => `
  const ${name} = new P5(p => {
    let right
    p.setup = () => {
      p.pixelDensity(1)
      p.createCanvas(100, 100, p.WEBGL)
      right = p.createWarp(({ glsl }) => glsl.vec3(20, 0, 0), { space: 'world' })
      p.noLoop()
    }
    p.draw = () => { p.background(0); right(); p.fill('red'); p.plane(20); ${code} }
  })`

/** Returns code that reads the red channel of a sketch's canvas → [at the centre, 20 pixels to the right]. */
const redsOf = (name) => `(() => {
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = 100
  const context = canvas.getContext('2d', { willReadFrequently: true })
  ${name}.redraw()
  context.drawImage(${name}.canvas, 0, 0, 100, 100)
  return [50, 70].map((x) => context.getImageData(x, 50, 1, 1).data[0])
})()`

test('works on several canvases, after remove() and a new sketch, and on a resized canvas', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x'], addon],
    `window.P5 = p5
    window.ready = 0
    ${instance('mine', 'ready++')}
    ${instance('yours', 'ready++')}
    const timer = setInterval(() => { if (ready >= 2) { clearInterval(timer); window.done = true } })`,
  )
  assert.deepEqual(await page.evaluate(redsOf('mine')), [0, 255])
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate('yours.resizeCanvas(60, 60); yours.resizeCanvas(100, 100)')
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate('mine.remove()')
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate(`ready = 0; ${instance('window.theirs', 'ready++').replace('const ', '')}`)
  await page.waitForFunction('ready > 0')
  assert.deepEqual(await page.evaluate(redsOf('theirs')), [0, 255])
  await leavePage(page)
  assert.deepEqual(messages, [])
})

if (isRun('unusual p5 pages'))
  test('works with two versions of p5 on one page, each followed by the script', async () => {
    const script = (src) => `<script src="${src}"></script>`
    const { page, messages } = await openPage(
      browser,
      server.page(`<!doctype html><body>
        ${script(p5Versions['1.11'])}${script(addon)}<script>const older = p5; p5 = undefined</script>
        ${script(p5Versions['2.x'])}${script(addon)}
        <script>
          window.ready = 0
          const newer = p5
          window.P5 = older
          ${instance('mine', 'ready++')}
          P5 = newer
          ${instance('yours', 'ready++')}
        </script>`),
    )
    await page.waitForFunction('ready >= 2')
    assert.deepEqual(await page.evaluate(redsOf('mine')), [0, 255])
    assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
    await leavePage(page)
    assert.deepEqual(messages, [])
  })

describe('the modules', () => {
  test('register their functions with an imported p5', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [],
      `import p5 from '/node_modules/p5/lib/p5.esm.js'
      import warpjet, { createWarp } from '/dist/p5.js'
      p5.registerAddon(warpjet)
      warpjet(p5)
      new p5((p) => {
        p.setup = () => {
          p.pixelDensity(1)
          p.createCanvas(${size}, ${size}, p.WEBGL)
          p.background(0)
          p.fill('red')
          for (const distort of [p.createWarp(${toTheRight}), createWarp(p, ${toTheRight})]) {
            distort()
            p.plane(20)
            p.translate(0, 30)
          }
          window.done = true
        }
      })`,
      'module',
    )
    const image = await readPixels(page)
    await leavePage(page)
    assert.deepEqual(messages, [])
    assertRedAt(image, 40, 0)
    assertRedAt(image, 40, 30)
  })

  test('can be loaded without a browser', async () => {
    const { default: warpjet, createWarp, setupWarp } = await import('../../dist/p5.js')
    assert.equal(setupWarp, warpjet)
    class Sketch {}
    Sketch.Graphics = class {}
    warpjet(Sketch)
    const { createWarp: method } = Sketch.prototype
    warpjet(Sketch)
    assert.equal(Sketch.prototype.createWarp, method)
    assert.equal(typeof Sketch.Graphics.prototype.createWarp, 'function')
    assert.throws(() => createWarp({}, () => 0), { name: 'WarpError', message: /3D canvas/ })
    for (const [argument, description] of [
      [undefined, 'undefined'],
      [{ default: Sketch }, 'an object'],
      [() => {}, 'a function'],
    ])
      assert.throws(() => warpjet(argument), {
        name: 'WarpError',
        message: `warpjet: expected p5 itself, as in: import p5 from 'p5', then warpjet(p5); got ${description}.`,
      })
  })
})
