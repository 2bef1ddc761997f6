// Shapes with enough vertices to bend: warpBox against p5's own box, and subdivide.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { differingPixels, litPixels, readPixels } from '../support/browser/pixels.js'
import {
  drawScenes,
  openHosts,
  p5HostsInThisRun,
  p5InThisRun,
  runSketch,
} from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

const { browsers, server } = await openHosts(p5HostsInThisRun)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`shapes with more vertices, p5 ${version}, ${renderer}`, () => {
    test("warpBox looks like p5's box, and bends; a subdivided shape bends too", async () => {
      const turned = 'rotateX(0.5); rotateY(0.7)'
      const lit = `noStroke(); ambientLight(60); directionalLight(200, 200, 200, 0.5, 1, -1); ${turned}`
      const outlines = `noFill(); stroke(255); strokeWeight(4); ${turned}`
      const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
        renderer,
        setup: `
          const levels = ${version === '1.11' ? 'null' : 'await subdivide(buildGeometry(() => box(60, 100, 80)), 3)'}
          warps.dense = levels
          warps.bend = createWarp(({ glsl, position }) =>
            glsl.vec3(position.y.div(25).sin().mult(20), 0, 0), { space: 'world' })
          checks = createImage(8, 8)
          for (let y = 0; y < 8; y++)
            for (let x = 0; x < 8; x++) checks.set(x, y, color(30 * x, 30 * y, (x + y) % 2 * 200))
          checks.updatePixels()`,
        scenes: {
          'texture by p5': `${lit}; texture(checks); box(60, 100, 80)`,
          texture: `${lit}; texture(checks); warpBox(60, 100, 80)`,
          'outlines by p5': `${outlines}; box(60, 100, 80)`,
          outlines: `${outlines}; warpBox(60, 100, 80)`,
          'a cube by p5': `${lit}; box(70)`,
          'a cube': `${lit}; warpBox(70)`,
          bent: `${lit}; warps.bend(); warpBox(60, 100, 80, 16)`,
          'bent from triangles': `${lit}; warps.bend(); ${version === '1.11' ? 'warpBox(60, 100, 80, 16)' : 'model(warps.dense)'}`,
          'corners alone': `${lit}; warps.bend(); box(60, 100, 80)`,
        },
      })
      for (const name of ['texture', 'outlines', 'a cube']) {
        const seen = litPixels(images[name]).length
        assert.ok(seen > 1500, `${name}: ${seen} pixels`)
        const differing = differingPixels(images[name], images[`${name} by p5`], 6)
        // Smooth edges differ where a line is split into pieces; one missing line of twelve would be 8 %.
        assert.ok(
          differing <= (name === 'outlines' ? 0.03 : 0.01) * seen,
          `${name}: ${differing} of ${seen} pixels differ`,
        )
      }
      assert.ok(differingPixels(images.bent, images['corners alone'], 30) > 500)
      const differing = differingPixels(images.bent, images['bent from triangles'], 12)
      const seen = litPixels(images.bent).length
      assert.ok(differing < 0.02 * seen, `${differing} of ${seen} pixels differ`)
    })
  })

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}, subdivide follows the warp and rejects invalid arguments`, async () => {
    const { page, messages } = await runSketch(
      browsers.WEBGL,
      server,
      [p5, addon],
      `async function setup() {
      createCanvas(50, 50, WEBGL)
      noLoop()
      noStroke()
      window.shape = buildGeometry(() => box(100))
      const warp = warpjet.compileWarp(({ glsl, position }) => glsl.vec3(position.y.div(20).sin().mult(10), 0, 0))
      const dense = await subdivide(shape, { warp, tolerance: 0.5 })
      const coarse = await subdivide(shape, { warp, tolerance: 5, angle: Infinity })
      window.counts = [shape, coarse, dense].map(({ faces }) => faces.length)
      // The result of createWarp gives the same subdivision as the same warp of compileWarp, with current or overridden uniforms.
      let deep = 10
      window.wave = createWarp(({ glsl, position, uniforms, millis, width }) =>
        glsl.vec3(position.y.div(20).add(millis.mult(0)).sin().mult(uniforms.deep).mult(width).div(50), 0, 0), { uniforms: { deep: () => deep } })
      const countFor = async (uniforms) => (await subdivide(shape, { warp: wave, tolerance: 0.5, uniforms })).faces.length
      window.byWarp = [await countFor(), await countFor({ deep: 0 }), (deep = 0, await countFor()), await countFor({ deep: 10 })]
      window.isWhole = dense.vertices.length === dense.vertexNormals.length && 2 * dense.vertices.length === dense.uvs.length
      window.dense = dense
      window.done = true
    }
    function draw() {
      // p5 1.11 draws before an async setup has finished.
      if (!window.dense) return
      background(0)
      wave({ deep: 10 })
      model(dense)
    }`,
    )
    const [given, coarse, dense] = await page.evaluate('counts')
    assert.equal(given, 12)
    assert.ok(12 < coarse && coarse < dense, `${coarse}, ${dense}`)
    assert.equal(await page.evaluate('isWhole'), true)
    assert.deepEqual(await page.evaluate('byWarp'), [dense, 12, 12, dense])
    for (const [code, sentence] of Object.entries({
      'subdivide(shape, { warp: wave, tolerance: 0.5, uniforms: { high: 2 } })':
        /^subdivide: the warp has no uniform "high"; there are .*\bdeep\.$/,
      'subdivide(shape, { warp: wave })':
        /^subdivide: expected a number above 0 for the option "tolerance"/,
      'subdivide(shape, { warp: setup, tolerance: 1 })':
        /^subdivide: expected a result of createWarp or compileWarp for the option "warp", got a function/,
      'subdivide(3, 2)': /^subdivide: expected a p5.Geometry with triangles, .* got the number 3/,
      'subdivide(shape, 1.5)':
        /^subdivide: expected a whole number from 0 to 15 for the option "levels"/,
      'subdivide(shape)': /^subdivide: expected options such as .*, got undefined/,
      'warpBox(100, 100, 100, 0)': /^warpBox: detail, .* expected a whole number from 1 to 200/,
      'warpBox("a")': /^warpBox: width: expected a number, got the text "a"/,
    })) {
      const said = await page.evaluate(
        `(async () => { try { await ${code}; return 'no error' } catch (error) { return error.message } })()`,
      )
      assert.match(said, sentence)
    }
    await page.evaluate('redraw()')
    const seen = litPixels(await readPixels(page)).length
    assert.ok(seen > 2000, `${seen} pixels of the subdivided shape`)
    await leavePage(page)
    assert.deepEqual(messages, [])
  })
