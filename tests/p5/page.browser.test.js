// How createWarp is loaded in a page, adapts to changes of the canvas, and reports mistakes.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { colorAt, readPixels } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 200

const { browser, server } = await openHost()

/** The arguments of a createWarp that moves by 40 pixels. */
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

    test('works if its script precedes that of p5, and if it is included twice', async () => {
      const { image } = await drawScenes(browser, server, [addon, p5, addon], {
        size,
        setup: `distort = createWarp(${toTheRight})`,
        scenes: { image: `distort(); fill('red'); plane(20)` },
      })
      assertRedAt(image, 40, 0)
    })

    test('reports mistakes by a WarpError, and continues to draw', async () => {
      const cases = {
        'createWarp(3)': /expected a function, got the number 3/,
        'createWarp(() => 3)': /must return a vec3/,
        'createWarp(warp, 3)': /expected an object of options, got/,
        'createWarp(warp, { colour: 1 })': /no option "colour"/,
        'createWarp(warp, { type: "shiny" })':
          /expected 'specular' or 'normal' for the option "type"/,
        'createWarp(warp, { space: "moon" })':
          /expected 'local', 'world' or 'camera' for the option "space"/,
        'createWarp(warp, { defs: 3 })':
          /expected a string of GLSL such as "uniform float size;" for the option "defs"/,
        'createWarp(warp)': /reads "turn", which nothing declares; add .* "uniform mat3 turn;"/,
        'createWarp(({ glsl }) => glsl.vec3Param("shift"))':
          /reads "shift", .* "uniform vec3 shift;"/,
        'flat2d.createWarp(warp)': /needs a 3D canvas/,
        'distort(3)': /expected an object of uniforms/,
        'distort([3])': /expected an object of uniforms/,
        'distort({ speed: 3 })': /no uniform "speed"/,
        'distort({ amount: undefined })': /uniform "amount": expected a number, got undefined/,
        'distort({ amount: NaN })': /uniform "amount": expected a number/,
        'distort({ amount: "a" })': /uniform "amount": expected a number, got the text "a"/,
        'distort({ shift: 3 })': /uniform "shift": expected an array of numbers/,
        'distort({ turn: [1, 2, 3, 4] })':
          /uniform "turn": expected an array of 9 numbers, column by column, got an array of 4/,
        'layer.remove(); inLayer()': /canvas that this warp was made for is gone/,
        'remove(); distort()': /canvas that this warp was made for is gone/,
      }
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, addon],
        `const warp = ({ glsl }) =>
          glsl.mat3Param('turn').mult(glsl.vec3Param('shift')).add(glsl.param('amount'))
        function setup() {
          createCanvas(100, 100, WEBGL)
          const defs = 'uniform vec3 shift; uniform float amount, unused; uniform mat3 turn;'
          distort = createWarp(warp, { defs })
          flat2d = createGraphics(10, 10)
          layer = createGraphics(10, 10, WEBGL)
          inLayer = layer.createWarp(warp, { defs })
          noLoop()
        }
        function draw() {
          inLayer()
          layer.sphere(5)
          distort({ unused: 1 })
          sphere(20)
          window.done = true
        }`,
      )
      for (const [code, message] of Object.entries(cases)) {
        const error = await page.evaluate(`(() => {
          try { ${code} } catch (error) { return { name: error.name, message: error.message } }
        })()`)
        assert.equal(error?.name, 'WarpError', code)
        assert.match(error.message, message)
      }
      await leavePage(page)
      assert.deepEqual(messages, [])
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
    for (const [wrong, what] of [
      [undefined, 'undefined'],
      [{ default: Sketch }, 'an object'],
      [() => {}, 'a function'],
    ])
      assert.throws(() => warpjet(wrong), {
        name: 'WarpError',
        message: `warpjet: expected p5 itself, as in: import p5 from 'p5', then warpjet(p5); got ${what}.`,
      })
  })
})
