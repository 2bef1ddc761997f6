// `exactNormals` for node materials on both backends of WebGPURenderer: compares normals at pixels with finite differences, in double
// precision, of the same motion as a function of numbers.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

let pages, page, messages
before(async () => {
  pages = await threePages(webgpuFlags)
  ;({ page, messages } = await pages.open('three', 'exact-normals/page-nodes.js'))
})
after(() => pages.close())

const maxDegrees = 0.05

/** Maps a showcase → how often its own normals evaluate the height: [in the vertex stage, in the fragment stage]. */
const heightsByHand = { sea: [1, 3], terrain: [3, 0] }

for (const backend of ['webgl', 'webgpu'])
  describe(`the backend ${backend}`, () => {
    test('displacements as people write them', async (t) => {
      const only = process.env.WARPJET_ONLY
      const failures = []
      for (const name of await page.evaluate(() => exact.names)) {
        if (only && !name.includes(only)) continue
        messages.length = 0
        const { covered, skipped, median, max, finite } = await page.evaluate(
          (args) => exact.measure(...args),
          [name, { backend }],
        )
        t.diagnostic(
          `${name}: ${covered} pixels, ${skipped} at kinks, ${max}° at 99.9%, median ${median}°`,
        )
        if (messages.length) failures.push(`${name}: ${messages.join('\n')}`)
        if (!(finite && covered > 500 && skipped < 0.02 * covered && max < maxDegrees))
          failures.push(`${name}: ${max}°, ${covered} pixels, ${skipped} at kinks`)
      }
      assert.deepEqual(failures, [])
    })

    test('loops run until they end', async (t) => {
      for (const name of await page.evaluate(() => exact.longLoops))
        for (const normals of ['vertex', 'pixel']) {
          messages.length = 0
          const { covered, moved, max, finite } = await page.evaluate(
            (args) => exact.measure(...args),
            [name, { backend, normals }],
          )
          t.diagnostic(`${name}, ${normals}: ${covered} pixels, ${max}° at 99.9%`)
          assert.deepEqual(messages, [])
          assert.equal(moved, 0, name)
          assert.ok(finite && covered > 500, name)
          // Three.js interpolates normals of vertices.
          if (normals === 'pixel') assert.ok(max < maxDegrees, `${name}: ${max}°`)
        }
    })

    test('a loop that cannot stay a loop is cut off, with a message', async () => {
      const measure = async (settings) => {
        messages.length = 0
        return page.evaluate(
          (args) => exact.measure(...args),
          ['', { backend, normals: 'pixel', ...settings }],
        )
      }
      const cut = await measure({ iterations: 256 })
      assert.equal(messages.length, 1, messages.join('\n'))
      assert.match(
        messages[0],
        /^exactNormals: the MeshNormalNodeMaterial cuts off a loop: only the shader knows .* after 256 iterations; .* maxIterations \(1 to 4096\)\.\n\s+for /,
      )
      // The original loop moves the vertices of the other picture further.
      assert.ok(cut.moved > 0, `${cut.moved} pixels`)
      const { max, moved } = await measure({ iterations: 400, maxIterations: 500 })
      assert.deepEqual(messages, [])
      assert.equal(moved, 0)
      assert.ok(max < maxDegrees, `${max}°`)
      const short = await measure({ iterations: 90, maxIterations: 90 })
      assert.deepEqual(messages, [])
      assert.ok(short.moved > 0)
    })

    for (const name of ['sea', 'terrain'])
      test(`the showcase ${name}, at 102,400 pixels`, async (t) => {
        messages.length = 0
        const measured = {}
        for (const by of ['hand', 'us'])
          measured[by] = await page.evaluate(
            (args) => exact.measureShowcase(...args),
            [name, { backend, by }],
          )
        const { hand, us } = measured
        t.diagnostic(`${us.max}° at 99.9%, mean ${us.mean}°, by hand ${hand.mean}°`)
        assert.deepEqual(messages, [])
        assert.equal(us.covered, 102_400)
        assert.ok(us.skipped < 100, `${us.skipped} pixels at kinks`)
        assert.ok(us.max < maxDegrees, `${us.max}°`)
        // The example's normals, from heights at shifted points, are not exact.
        assert.ok(hand.mean > 1, `${hand.mean}°`)
      })

    for (const [name, byHand] of Object.entries(heightsByHand))
      test(`the showcase ${name} evaluates its height once per stage`, async () => {
        const heights = (settings) =>
          page.evaluate((args) => exact.heightsOf(...args), [name, { backend, ...settings }])
        assert.deepEqual(await heights({ by: 'hand' }), byHand)
        assert.deepEqual(await heights({ by: 'us', normals: 'vertex' }), [1, 0])
        assert.deepEqual(await heights({ by: 'us', normals: 'pixel' }), [1, 1])
      })

    // In its first material, three.js also builds the bodies of its noise functions.
    test('the first material of a page evaluates its height once, too', async () => {
      for (const name of Object.keys(heightsByHand)) {
        const { page, messages } = await pages.open('three', 'exact-normals/page-nodes.js')
        const heights = await page.evaluate(
          (args) => exact.heightsOf(...args),
          [name, { backend, by: 'us', normals: 'vertex' }],
        )
        await page.close()
        assert.deepEqual(messages, [])
        assert.deepEqual(heights, [1, 0], name)
      }
    })

    test('varyings that a position assigns stay as they are', async () => {
      messages.length = 0
      for (const name of await page.evaluate(() => exact.varyings))
        for (const normals of ['vertex', 'pixel'])
          for (const hasTangents of [false, true]) {
            const what = `${name}, ${normals}${hasTangents ? ', tangents' : ''}`
            const { covered, difference, spread, heights } = await page.evaluate(
              (args) => exact.differenceOfVaryings(...args),
              [name, { backend, normals, hasTangents }],
            )
            assert.ok(covered > 800 && spread > 0.5, what)
            assert.ok(difference < 1e-4, `${what}: ${difference}`)
            // With too many varyings for our function, the vertex stage evaluates the position again.
            assert.equal(heights, name === 'too many' && normals === 'vertex' ? 2 : 1, what)
          }
      assert.deepEqual(messages, [])
    })

    test('a position without a derivative keeps its normals, and the console says why', async () => {
      for (const [name, message] of await page.evaluate(() => exact.unsupported)) {
        messages.length = 0
        const changed = await page.evaluate(
          (args) => exact.countChanges(...args),
          [name, { backend }],
        )
        assert.equal(changed, 0, name)
        assert.equal(messages.length, 1, name)
        assert.match(
          messages[0],
          /exactNormals: the normals of the MeshNormalNodeMaterial of this Mesh stay/,
        )
        assert.match(messages[0], new RegExp(message))
      }
    })

    test('a warp of the mesh and exactNormals of its material are combined', async (t) => {
      for (const name of await page.evaluate(() => exact.warpsBeside)) {
        messages.length = 0
        const { differing, plain, covered } = await page.evaluate(
          (args) => exact.besideWarp(...args),
          [name, { backend }],
        )
        t.diagnostic(
          `${name}: ${differing} of ${covered} pixels differ, ${plain} without exactNormals`,
        )
        assert.deepEqual(messages, [], name)
        assert.ok(covered > 800 && plain > 0.3 * covered && differing <= 12, name)
      }
    })

    test('velocities are those of the uniforms in the frame before', async () => {
      messages.length = 0
      const [first, raised, still] = await page.evaluate((args) => exact.velocities(args), {
        backend,
      })
      assert.deepEqual(messages, [])
      assert.ok(Math.abs(first) < 1e-6 && Math.abs(still) < 1e-6, `${first}, ${still}`)
      assert.ok(Math.abs(raised - 0.3) < 1e-4, `${raised}`)
    })

    test('these tests would detect normals that stay as they are', async () => {
      const { median } = await page.evaluate(
        (args) => exact.measure(...args),
        ['a sine', { backend, isExact: false }],
      )
      assert.ok(median > 10, `${median}°`)
    })
  })
