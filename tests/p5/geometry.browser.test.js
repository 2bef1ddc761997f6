// Warps that are called while p5 builds a geometry, compared with a computation by hand; and subdivide().
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { font, openP5Hosts } from '../support/browser/p5-hosts.js'
import { litPixels, readPixels, readWebGPUPixels } from '../support/browser/pixels.js'
import { setup } from './scenes/build.js'

for (const { name, isV1, isWebGPU, canvas, run, open } of await openP5Hosts())
  describe(name, () => {
    /** Returns a sketch that runs `code` in setup(); `code` may set `result`. */
    const sketch = (code) => `const warps = {}
      async function setup() {
        ${canvas(100, 100)}
        noLoop()
        ${setup}
        window.result = undefined
        ${code}
        window.done = true
      }`

    test('buildGeometry() with a warp has the vertices and normals computed by hand', async () => {
      const { result, messages } = await run(
        sketch(`
        const numbers = ({ vertices, vertexNormals }) =>
          [vertices, vertexNormals].map((all) => all.map(({ x, y, z }) => [x, y, z]))
        const shape = (warp) => buildGeometry(() => {
          warp()
          push(); translate(10, 0, 0); rotateZ(0.5); sphere(60, 12, 8); pop()
          resetShader()
          beginShape(TRIANGLES); vertex(0, 0, 0); vertex(5, 0, 0); vertex(0, 5, 0); endShape()
        })
        result = [() => {}, warps.wave, warps.sway].map((warp) => numbers(shape(warp)))
        // p5's own shapes stay unchanged.
        result.push(numbers(shape(() => {})))`),
      )
      assert.deepEqual(messages, [])
      const [plain, wave, sway, again] = result
      assert.deepEqual(again, plain)
      const [c, s] = [Math.cos(0.5), Math.sin(0.5)]
      const count = plain[0].length - 3
      assert.ok(count > 90)
      const rotate = ([x, y, z]) => [c * x - s * y, s * x + c * y, z]
      const rotateBack = ([x, y, z]) => [c * x + s * y, c * y - s * x, z]
      const assertNear = (actual, expected, tolerance, what) =>
        actual.forEach((value, k) =>
          assert.ok(
            Math.abs(value - expected[k]) < tolerance,
            `${what}: expected ${expected}, got ${actual}`,
          ),
        )
      const unit = (v) => v.map((x) => x / Math.hypot(...v))
      for (let i = 0; i < count; i++) {
        const [p, n] = [plain[0][i], plain[1][i]]
        // Position and normal on p5's sphere of radius 1.
        const [x, y, z] = rotateBack([p[0] - 10, p[1], p[2]]).map((value) => value / 60)
        const [a, b, d] = rotateBack(n)
        const moved = rotate([60 * x, 60 * (y + 0.2 * Math.sin(5 * x)), 60 * z])
        assertNear(wave[0][i], [moved[0] + 10, moved[1], moved[2]], 1e-3, 'place')
        const normal = rotate([a - Math.cos(5 * x) * b, b, d])
        assertNear(unit(wave[1][i]), unit(normal), 1e-4, 'normal')
        // `sway` moves points in world space, in pixels.
        assertNear(
          sway[0][i],
          [p[0] + 20 * Math.sin(0.05 * p[1]), p[1], p[2]],
          1e-3,
          'place in the world',
        )
        assertNear(
          unit(sway[1][i]),
          unit([n[0], n[1] - Math.cos(0.05 * p[1]) * n[0], n[2]]),
          1e-4,
          'normal in the world',
        )
      }
      for (const warped of [wave, sway])
        assert.deepEqual(warped[0].slice(count), plain[0].slice(count), 'after resetShader()')
    })

    test('text() under a warp warns once, with advice for the sketch', async () => {
      const load = isV1 ? 'await new Promise((done) => loadFont' : 'await loadFont'
      const { messages } = await run(
        sketch(`
        textFont(${load}('${font}'${isV1 ? ', done)' : ''}))
        text('a', 0, 0)
        warps.wave()
        text('a', 0, 0)
        text('b', 0, 0)`),
      )
      assert.equal(messages.length, 1, messages.join('; '))
      assert.match(messages[0], /^text: a warp cannot move text, .*textToModel.*createGraphics/)
    })

    test('subdivide follows the warp', async () => {
      const { page, messages } = await open(
        `async function setup() {
        ${canvas(50, 50)}
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
        window.isComplete = dense.vertices.length === dense.vertexNormals.length && 2 * dense.vertices.length === dense.uvs.length
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
      assert.equal(await page.evaluate('isComplete'), true)
      assert.deepEqual(await page.evaluate('byWarp'), [dense, 12, 12, dense])
      if (!isWebGPU) await page.evaluate('redraw()')
      const image = isWebGPU ? await readWebGPUPixels(page, 'redraw()') : await readPixels(page)
      const seen = litPixels(image).length
      assert.ok(seen > 2000, `${seen} pixels of the subdivided shape`)
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })
