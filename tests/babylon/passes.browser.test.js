// 'warpjet/babylon' in all passes of Babylon.js, in copies of materials, and along normals: the same as without a warp.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { openBabylonPage } from '../support/browser/babylon/open.js'

/** Pixels that may differ by more than 12 of 255 in a channel. */
const allowed = 5

let opened
before(async () => (opened = await openBabylonPage('page-passes.js')))
after(() => opened.close())

const printed = () => opened.messages.splice(0).filter((text) => !text.startsWith('BJS - '))

function assertSame({ differing, moved }, seen = 200) {
  assert.deepEqual(printed(), [])
  assert.ok(differing <= allowed, `${differing} pixels differ from the motion by Babylon.js`)
  assert.ok(moved > seen, `${moved} pixels are moved`)
}

for (const backend of ['webgl', 'webgpu'])
  describe(backend, () => {
    const ask = (work, ...given) => opened.page.evaluate(work, [backend, ...given])

    test('passes', async (t) => {
      for (const [kind, pass, variant] of await opened.page.evaluate(() => rows))
        await t.test(`${pass}, ${variant}`, async () => {
          // One point in 9 is picked.
          const seen = pass === 'picking' ? 30 : 200
          assertSame(await ask((given) => compare(...given), kind, pass, variant), seen)
        })
    })

    for (const kind of ['Standard', 'PBR']) {
      for (const how of ['clone', 'Parse'])
        test(`${how} of a ${kind}Material has its own warp`, async () =>
          assertSame(await ask((given) => copied(...given), kind, how)))

      test(`along the normals of a torus, ${kind}Material`, async () => {
        assertSame(await ask((given) => torus(...given), kind, true))
        const { differing } = await ask((given) => torus(...given), kind, false)
        assert.ok(differing > 100, `${differing} pixels differ without surface variation`)
      })
    }
  })

test('a material that was saved in another page comes without its warp, and says so', async () => {
  printed()
  assert.equal(await opened.page.evaluate(() => parseForeign()), true)
  const [message, ...others] = printed()
  assert.match(
    message,
    /^BabylonWarp: the material "standard" was saved with a warp, .*after loading\.$/,
  )
  assert.deepEqual(others, [])
})
