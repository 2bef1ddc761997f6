// Tests 'warpjet/babylon' in all passes of Babylon.js, with copies of materials, and with a warp along normals: pictures must equal those
// of the same motion without a warp.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { bundledPage } from '../support/browser/bundled-page.js'

/** The number of pixels that may differ by more than 12 of 255 in a channel. */
const maxDiffering = 5

let opened
before(async () => (opened = await bundledPage('babylon/page-passes.js', { hasWebGPU: true })))
after(() => opened.close())

/** Returns the new console messages, without Babylon.js's greeting. */
const takeMessages = () => opened.messages.splice(0).filter((text) => !text.startsWith('BJS - '))

function assertSame({ differing, moved }, minMoved = 200) {
  assert.deepEqual(takeMessages(), [])
  assert.ok(differing <= maxDiffering, `${differing} pixels differ from the motion by Babylon.js`)
  assert.ok(moved > minMoved, `${moved} pixels are moved`)
}

for (const backend of ['webgl', 'webgpu'])
  describe(backend, () => {
    const evaluate = (work, ...args) => opened.page.evaluate(work, [backend, ...args])

    test('each pass shows the warped mesh', async (t) => {
      for (const [kind, pass, variant] of await opened.page.evaluate(() => rows))
        await t.test(`${pass}, ${variant}`, async () => {
          // Picking is tested at one pixel in 9, so fewer pixels can differ.
          const minMoved = pass === 'picking' ? 30 : 200
          assertSame(await evaluate((args) => compare(...args), kind, pass, variant), minMoved)
        })
    })

    for (const kind of ['Standard', 'PBR']) {
      for (const how of ['clone', 'Parse'])
        test(`a ${kind}Material copied by ${how} has its own warp`, async () =>
          assertSame(await evaluate((args) => compareCopy(...args), kind, how)))

      test(`a ${kind}Material that moves a torus along its normals has exact normals`, async () => {
        assertSame(await evaluate((args) => torus(...args), kind, true))
        const { differing } = await evaluate((args) => torus(...args), kind, false)
        assert.ok(differing > 100, `${differing} pixels differ without surface variation`)
      })
    }
  })

test('a material that was saved on another page is loaded without its warp, with a warning', async () => {
  takeMessages()
  assert.equal(await opened.page.evaluate(() => parseForeign()), true)
  const [message, ...others] = takeMessages()
  assert.match(
    message,
    /^BabylonWarp: the material "standard" was saved with a warp, .*after loading\.$/,
  )
  assert.deepEqual(others, [])
})
