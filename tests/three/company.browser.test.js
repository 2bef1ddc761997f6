// Tests 'warpjet/three' in company, which means together with other code: what users, three's passes and three's examples do with objects,
// materials and shaders. Each row draws a warped object and one whose vertices are moved on the CPU: at most 5 pixels of 25,600 may differ by
// more than 12 of 255 in a channel.
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

const topics = ['materials', 'shaders', 'objects', 'shadows', 'passes']

for (const version of isRun('three 0.159') ? versions : versions.slice(0, 1))
  describe(version, () => {
    let page, messages
    before(async () => ({ page, messages } = await pages.open(version, 'company/page.js')))
    after(() => leavePage(page))

    for (const topic of topics)
      test(`${topic}: a warp looks like vertices moved on the CPU`, async (t) => {
        const names = await page.evaluate((topic) => company.names[topic], topic)
        for (const name of names)
          await t.test(name, async (t) => {
            messages.length = 0
            const { differing, moved, worst } = await page.evaluate(
              ([topic, name]) => company.run(topic, name),
              [topic, name],
            )
            t.diagnostic(`${differing} pixels differ, by at most ${worst}; ${moved} are moved`)
            assert.deepEqual(messages, [])
            assert.ok(moved > 400, `${moved} pixels are moved`)
            assert.ok(differing <= 5, `${differing} pixels differ, by at most ${worst}`)
          })
      })
  })
