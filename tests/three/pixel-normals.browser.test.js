// Normals at each pixel with WebGLRenderer: compares the normals that MeshNormalMaterial draws with finite differences, in double, at the
// interpolated vertex.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage } from '../support/browser/browser.js'
import { threePages, versions } from '../support/browser/three/open.js'

let pages
before(async () => {
  pages = await threePages()
})
after(() => pages.close())

for (const version of isRun('three 0.159') ? versions : versions.slice(0, 1))
  describe(version, () => {
    let page, messages
    before(async () => {
      ;({ page, messages } = await pages.open(version, 'pixel-normals/page-webgl.js'))
    })
    after(() => leavePage(page))

    const measure = (settings) => page.evaluate((settings) => pixels.measure(settings), settings)

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

    const shapes = ['plane', 'sphere', 'box', 'torus', 'icosahedron']
    const isOldest = version !== 'three'
    for (const shape of isRun('every shape') && !isOldest ? shapes : ['sphere'])
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
        for (const name of ['simplex', 'blob along the normal']) {
          // In three.js 0.159, batches have no instances. In no version do they copy attributes that share a buffer.
          if (kind === 'batch' && (version !== 'three' || name !== 'simplex')) continue
          await assertExact(t, { kind, name })
        }
      for (const name of ['simplex', 'waves']) await assertExact(t, { space: 'world', name })
      await assertExact(t, { space: 'rest', name: 'simplex' })
    })

    if (isRun('maps and sides'))
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

    if (isRun('maps and sides'))
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
      assert.equal(await page.evaluate(() => pixels.countFacetDifferences('simplex')), 0)
    })

    test('a surface that collapses is lit by the normals of its triangles', async (t) => {
      for (const name of ['floor', 'pinch'])
        for (const normals of ['pixel', 'vertex'])
          for (const side of ['FrontSide', 'DoubleSide', 'BackSide']) {
            messages.length = 0
            const found = await page.evaluate(
              ([name, settings]) => pixels.collapse(name, settings),
              [name, { normals, side }],
            )
            t.diagnostic(`${name}, ${normals}, ${side}: ${JSON.stringify(found)}`)
            assert.deepEqual([messages, found.wrong, found.finite], [[], 0, true])
            // Some triangles at the outline do face away from the light.
            assert.ok(found.dark < 0.03 * found.covered, `${found.dark} dark pixels`)
            assert.ok(found.covered > 400)
            if (name === 'pinch') continue
            assert.equal(found.differingInLight, 0)
            if (normals === 'pixel') assert.equal(found.differing, 0)
          }
    })

    if (isRun('maps and sides'))
      test('maps, clearcoats, anisotropy and transmission use normals at pixels, and are finite', async (t) => {
        for (const name of await page.evaluate(() => pixels.mapNames)) {
          messages.length = 0
          const found = await page.evaluate((name) => pixels.drawWithMap(name), name)
          t.diagnostic(`${name}: ${JSON.stringify(found)}`)
          assert.deepEqual([messages, found.wrong], [[], 0], name)
          assert.ok(found.differing > 0.5 * found.covered, name)
        }
      })

    if (isRun('obstacles'))
      test("if normals at pixels are impossible, they are computed at vertices, with a warning if the option is 'pixel'", async () => {
        for (const name of await page.evaluate(() => pixels.obstacles))
          for (const [normals, warnings] of [
            ['auto', 0],
            ['pixel', 1],
          ]) {
            messages.length = 0
            const found = await page.evaluate(
              ([name, normals]) => pixels.obstacle(name, normals),
              [name, normals],
            )
            assert.deepEqual(
              [messages.length, found.differing],
              [warnings, 0],
              `${name}, ${normals}`,
            )
            assert.ok(found.covered > 400, name)
            if (warnings) assert.match(messages[0], /^warp: the normals of .* at vertices/)
          }
      })

    test('shaders with normals at vertices have no code for normals at pixels', async () => {
      const [vertex, pixel] = await page.evaluate(() => [
        pixels.sources('vertex'),
        pixels.sources('pixel'),
      ])
      assert.doesNotMatch(vertex[0], /warpjetPixel|WARPJET_VIEW/)
      assert.doesNotMatch(vertex[1], /warpjetPixel/)
      assert.match(pixel[0], /warpjetPixel_position/)
      assert.match(pixel[1], /precision highp float;[^]*warpjetNormalOfPixel/)
    })

    test('auto computes normals at pixels for noise and bends', async () => {
      const stages = await page.evaluate(() => pixels.stages())
      for (const name of ['fbm', 'simplex', 'worley', 'waves'])
        assert.deepEqual(stages[name], ['pixel', 'pixel'], name)
      assert.deepEqual(stages.shift, ['vertex', 'vertex'])
    })
  })
