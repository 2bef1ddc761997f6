// 'warpjet/three' with packages that have their own rendering, deformation or instancing. Rows work as in company.browser.test.js.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { bundledPage } from '../support/browser/bundled-page.js'

let opened, page, messages
before(async () => {
  opened = await bundledPage('three/company/libraries.js')
  ;({ page, messages } = opened)
})
after(() => opened.close())

test('each package draws a warp like vertices moved on the CPU', async (t) => {
  for (const name of await page.evaluate(() => company.names.libraries))
    await t.test(name, async (t) => {
      messages.length = 0
      const { differing, moved, worst } = await page.evaluate(
        (name) => company.run('libraries', name),
        name,
      )
      t.diagnostic(`${differing} pixels differ, by at most ${worst}; ${moved} are moved`)
      // Ignores a message of the font reader of troika-three-text.
      const others = messages.filter((message) => !message.startsWith('unsupported GPOS'))
      assert.deepEqual(others, [])
      assert.ok(moved > 400, `${moved} pixels are moved`)
      assert.ok(differing <= 5, `${differing} pixels differ, by at most ${worst}`)
    })
})

test('rays hit warped instances of @three.ez/instanced-mesh where they are drawn', async () => {
  const heights = await page.evaluate(() => company.hitHeights())
  for (const space of ['local', 'world'])
    for (const [i, expected] of [3, 5].entries())
      assert.ok(Math.abs(heights[space][i] - expected) < 1e-3, JSON.stringify(heights))
})
