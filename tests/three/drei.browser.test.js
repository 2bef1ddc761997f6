// `exactNormals` with drei's materials that move vertices: compares normals with finite differences in double precision, and tests shadows.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { bundledPage } from '../support/browser/bundled-page.js'

let opened
before(async () => {
  opened = await bundledPage('three/exact-normals/drei.js')
})
after(() => opened.close())

/** Leaves out a message about a deprecated class of three.js that @react-three/fiber uses. */
const withoutDeprecation = (messages) =>
  messages.filter((text) => !text.startsWith('THREE.Clock: '))

test('normals of both materials are exact at vertices and at pixels', async (t) => {
  const { page, messages } = opened
  for (const name of await page.evaluate(() => drei.names)) {
    const own = await page.evaluate((name) => drei.measure(name), name)
    assert.ok(own.median > 4, `without exactNormals, normals are only ${own.median}° off`)
    for (const normals of ['vertex', 'pixel']) {
      messages.length = 0
      const found = await page.evaluate((row) => drei.measure(...row), [name, normals])
      const { count, median, worst, farthest, finite } = found
      t.diagnostic(
        `${name}, ${normals}: ${count} vertices, median ${median}°, at most ${worst}°; without exactNormals ${own.median}°`,
      )
      assert.deepEqual([withoutDeprecation(messages), finite], [[], true])
      assert.ok(count > 900 && worst < 0.03, `${worst}°`)
      assert.ok(farthest < 1e-3, `the position is off by ${farthest}`)
    }
  }
})

test('shadows of both materials follow the displacement', async (t) => {
  const { page, messages } = opened
  messages.length = 0
  for (const name of await page.evaluate(() => drei.names)) {
    const { differing, moved } = await page.evaluate((name) => drei.shadow(name), name)
    t.diagnostic(`${name}: ${differing} pixels differ, ${moved} without the displacement`)
    assert.ok(moved > 200 && differing <= 10, `${differing} of ${moved}`)
  }
  assert.deepEqual(withoutDeprecation(messages), [])
})
