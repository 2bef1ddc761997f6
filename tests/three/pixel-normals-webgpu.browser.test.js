// Normals at each pixel with WebGPURenderer, on both backends: does what pixel-normals.browser.test.js does with WebGLRenderer.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

let pages, page, messages
before(async () => {
  pages = await threePages(webgpuFlags)
  ;({ page, messages } = await pages.open('three', 'pixel-normals/page-webgpu.js'))
})
after(() => pages.close())

for (const backend of ['webgl', 'webgpu'])
  describe(`the backend ${backend}`, () => {
    const measure = (settings) =>
      page.evaluate((settings) => pixels.measure(settings), { backend, ...settings })

    async function assertExact(t, settings) {
      messages.length = 0
      const { covered, skipped, median, max, finite } = await measure(settings)
      t.diagnostic(
        `${Object.values(settings).join(', ')}: ${covered} pixels, ${skipped} at kinks, ${max}° at 99.9%, median ${median}°`,
      )
      assert.deepEqual(messages, [])
      assert.ok(finite)
      assert.ok(covered > 500, `${covered} pixels`)
      assert.ok(skipped < 0.02 * covered, `${skipped} pixels at kinks`)
      assert.ok(max < 0.1, `${max}°`)
    }

    for (const shape of ['plane', 'sphere', 'box', 'torus', 'icosahedron'])
      test(`a ${shape}`, async (t) => {
        const names = await page.evaluate(() => pixels.warps)
        for (const name of names.slice(0, shape === 'plane' ? 4 : undefined))
          await assertExact(t, { shape, name })
      })

    test('interpolated normals of the same pictures are wrong by degrees', async (t) => {
      for (const [name, minError] of [
        ['fbm', 15],
        ['simplex', 10],
        ['waves', 1.5],
      ]) {
        const { median } = await measure({ name, normals: 'vertex' })
        t.diagnostic(`${name}: ${median}°`)
        assert.ok(median > minError, `${name}: ${median}°`)
      }
    })

    test('negative scales, skins, morph targets, instances and batches, in each space', async (t) => {
      for (const kind of ['negative scale', 'skin', 'morphs', 'instances', 'batch'])
        await assertExact(t, { kind, name: 'simplex' })
      await assertExact(t, { kind: 'instances', name: 'blob along the normal' })
      for (const kind of ['plain', 'skin'])
        await assertExact(t, { space: 'world', name: 'simplex', kind })
      for (const kind of ['plain', 'instances'])
        await assertExact(t, { space: 'rest', name: 'simplex', kind })
    })

    test('both sides and the back', async (t) => {
      for (const side of ['DoubleSide', 'BackSide'])
        for (const isBehind of [false, true]) {
          if (side === 'BackSide' && !isBehind) continue
          const settings = { shape: 'plane', name: 'simplex', side, isBehind }
          await assertExact(t, settings)
          assert.equal((await measure(settings)).facing, 1)
        }
      await assertExact(t, { name: 'simplex', side: 'BackSide' })
    })

    test('normal maps in the frame of vertex tangents', async (t) => {
      for (const map of [
        [0.6, 0, 0.8],
        [0, 0.6, 0.8],
      ])
        for (const kind of ['plain', 'negative scale', 'instances'])
          await assertExact(t, { name: 'simplex', kind, map })
      await assertExact(t, { name: 'simplex', space: 'world', map: [0.48, 0.36, 0.8] })
    })

    test('facets stay facets', async () => {
      assert.equal(
        await page.evaluate((backend) => pixels.countFacetDifferences(backend, 'simplex'), backend),
        0,
      )
    })

    test('a surface that collapses is lit by the normals of its triangles', async (t) => {
      for (const name of ['floor', 'pinch'])
        for (const normals of ['pixel', 'vertex'])
          for (const side of ['FrontSide', 'DoubleSide', 'BackSide']) {
            messages.length = 0
            const found = await page.evaluate(
              (args) => pixels.collapse(...args),
              [backend, name, { normals, side }],
            )
            t.diagnostic(`${name}, ${normals}, ${side}: ${JSON.stringify(found)}`)
            assert.deepEqual([messages, found.wrong, found.finite], [[], 0, true])
            assert.ok(found.dark < 0.03 * found.covered, `${found.dark} dark pixels`)
            assert.ok(found.covered > 400)
            if (name === 'floor')
              assert.deepEqual([found.differing, found.differingInLight], [0, 0])
          }
    })

    test('a surface that collapses has the axes of the view as tangents', async (t) => {
      for (const direction of [
        [0.6, 0, 0.8],
        [0, 0.6, 0.8],
      ]) {
        const { covered, worst } = await page.evaluate(
          (args) => pixels.collapseWithMap(...args),
          [backend, direction],
        )
        t.diagnostic(`${direction}: ${covered} pixels, at most ${worst} off`)
        assert.ok(covered > 400, `${covered} pixels`)
        assert.ok(worst < 2e-3, `${worst}`)
      }
    })

    test('maps, clearcoats, anisotropy, transmission and reflections use normals at pixels, and are finite', async (t) => {
      for (const name of await page.evaluate(() => pixels.mapNames)) {
        messages.length = 0
        const found = await page.evaluate((args) => pixels.drawWithMap(...args), [backend, name])
        t.diagnostic(`${name}: ${JSON.stringify(found)}`)
        assert.deepEqual([messages, found.wrong], [[], 0], name)
        assert.ok(found.differing > 0.5 * found.covered, name)
      }
      const { differing, covered } = await page.evaluate(
        (backend) => pixels.reflection(backend),
        backend,
      )
      assert.ok(differing > 0.5 * covered, `${differing} pixels of a reflection differ`)
    })

    test('a normalNode of the material starts from the normal of the pixel', async () => {
      const worst = await page.evaluate((backend) => pixels.ownNode(backend, 'pixel'), backend)
      assert.ok(worst < 1e-3, `${worst}`)
    })

    test("if normals at pixels are impossible, they are computed at vertices, with a warning if the option is 'pixel'", async () => {
      for (const [normals, warnings] of [
        ['auto', 0],
        ['pixel', 1],
      ]) {
        messages.length = 0
        const differing = await page.evaluate(
          (args) => pixels.obstacle(...args),
          [backend, normals],
        )
        assert.deepEqual([messages.length, differing], [warnings, 0], messages.join())
      }
      assert.equal(await page.evaluate(() => pixels.stage()), 'pixel')
    })

    // The warp passes 2 vectors. For three.js we expect 6, 2 more for tangents, and one for each further uv.
    for (const [title, limit, settings] of [
      ['no textures', 8, {}],
      ['textures with the first uv', 8, { channels: [0, 0] }],
      ['textures with three uvs', 10, { channels: [0, 1, 2] }],
      ['tangents', 11, { channels: [0], hasTangents: true }],
    ])
      test(`${title}: normals are computed at pixels if the device passes ${limit} vectors, and at vertices if it passes fewer`, async () => {
        for (const [possible, warnings] of [
          [limit, 0],
          [limit - 1, 1],
        ]) {
          messages.length = 0
          await page.evaluate(
            (args) => pixels.drawWithLimit(...args),
            [backend, possible, settings],
          )
          assert.equal(messages.length, warnings, messages.join())
          if (warnings) assert.match(messages[0], /this device has \d left/)
        }
      })
  })
