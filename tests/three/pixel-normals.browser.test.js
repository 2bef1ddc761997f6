// Normals at each pixel with WebGLRenderer: what MeshNormalMaterial shows against differences in double, at the interpolated vertex.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
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

    const measure = (settings) => page.evaluate((settings) => pixels.measure(settings), settings)

    async function isExact(t, settings) {
      messages.length = 0
      const { covered, skipped, median, most, finite } = await measure(settings)
      t.diagnostic(
        `${Object.values(settings).join(', ')}: ${covered} pixels, ${skipped} at kinks, ${most}° at 99.9%, median ${median}°`,
      )
      assert.deepEqual(messages, [])
      assert.ok(finite)
      assert.ok(covered > 500, `${covered} pixels`)
      assert.ok(skipped < 0.02 * covered, `${skipped} pixels at kinks`)
      assert.ok(most < 0.1, `${most}°`)
    }

    for (const shape of ['plane', 'sphere', 'box', 'torus', 'icosahedron'])
      test(`${shape}`, async (t) => {
        const names = await page.evaluate(() => pixels.warps)
        for (const name of names.slice(0, shape === 'plane' ? 4 : undefined))
          await isExact(t, { shape, name })
      })
  })
