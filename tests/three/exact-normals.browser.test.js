// `exactNormals` for materials of WebGLRenderer: normals at each vertex against differences of formulas in double precision.
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

const stages = ['vertex', 'pixel', 'auto']

/** Rows whose normals stay at vertices, with a part of the message that says why. */
const atVertices = {
  'instanced grass': /attribute instanceMatrix, which pixels do not have/,
}

/** Habits with a message. Those that move vertices by an attribute that is constant here are exact. */
const notes = {
  'gl_Position changes after the projection': /changes gl_Position after projectionMatrix/,
  'a branch without braces that changes gl_Position': /changes gl_Position after projectionMatrix/,
  'tangents of the geometry': /by the attribute tangent, which counts as constant/,
  'a position snapped to pixels': /changes clip after projectionMatrix/,
  gl_VertexID: /the attribute gl_VertexID has no value/,
  'attribute per vertex': /by the attribute aHeight, which counts as constant/,
  vertexColors: /by the attribute color, which counts as constant/,
  'a function that sets the varying': /line 3, column 63: .* reads the attribute normal/,
  'position and light in one branch': /line 2, column 34: .* write these as two/,
}

const wrongCalls = [
  'expected a material or a Mesh of three.js, got undefined.',
  'expected a material or a Mesh of three.js, got a Group.',
  'the LineBasicMaterial has no normals.',
  "the MeshStandardNodeMaterial is a node material, which only WebGPURenderer draws; import exactNormals from 'warpjet/three/webgpu'.",
  `expected 'auto', 'vertex' or 'pixel' for the option "normals", got the text "face".`,
  'there is no option "normal"; did you mean normals? The options are normals, surfaceVariation.',
].map((message) => `WarpError: exactNormals: ${message}`)

for (const version of isRun('three 0.159') ? versions : versions.slice(0, 1))
  describe(version, () => {
    let page, messages, names
    before(async () => {
      ;({ page, messages } = await pages.open(version, 'exact-normals/page.js'))
      names = await page.evaluate(() => exact.names)
    })
    after(() => leavePage(page))

    const measure = (table, name, normals) =>
      page.evaluate((row) => exact.measure(...row), [table, name, normals])

    for (const table of ['chunks', 'ofCustomShaderMaterial', 'ofShaderMaterial', 'objects'])
      test(`every displacement of ${table}`, async (t) => {
        for (const name of names[table])
          await t.test(name, async (t) => {
            const own = await measure(table, name)
            assert.ok(own.median > 1, `its own normals are off by ${own.median}°`)
            for (const normals of stages) {
              messages.length = 0
              const found = await measure(table, name, normals)
              const { count, skipped, median, worst, farthest, finite } = found
              t.diagnostic(
                `${normals}: ${count} vertices, ${skipped} at kinks, median ${median}°, at most ${worst}°; without it ${own.median}°`,
              )
              assert.ok(finite && count > 140)
              assert.ok(worst < 0.03, `${worst}°`)
              assert.ok(farthest < 1e-3, `the position is off by ${farthest}`)
              const isNoted =
                normals === 'pixel' && (table === 'ofShaderMaterial' || name in atVertices)
              assert.equal(messages.length, Number(isNoted), messages.join('\n'))
              if (isNoted) assert.match(messages[0], /at vertices, although/)
              if (isNoted && name in atVertices) assert.match(messages[0], atVertices[name])
            }
          })
      })

    test('other habits: exact, or with a message', async (t) => {
      for (const name of names.habits)
        await t.test(name, async (t) => {
          messages.length = 0
          const {
            own,
            exact: error,
            isSamePlace,
          } = await page.evaluate((name) => exact.measureHabit(name), name)
          t.diagnostic(`${error}° at 95%; without exactNormals ${own}°`)
          assert.ok(isSamePlace)
          const note = notes[name]
          assert.equal(messages.length, Number(note !== undefined), messages.join('\n'))
          if (note) assert.match(messages[0], note)
          // The differences themselves are off by 0.16°.
          else assert.ok(own > 1 && error < 0.2, `${error}°`)
        })
    })

    test('what cannot be read stays as it is, with a message', async (t) => {
      for (const name of names.unsupported)
        await t.test(name, async () => {
          messages.length = 0
          const { message, isSame } = await page.evaluate((name) => exact.unsupported(name), name)
          assert.ok(isSame)
          const own = messages.filter((text) => text.startsWith('exactNormals: '))
          assert.equal(own.length, 1, messages.join('\n'))
          assert.match(own[0], new RegExp(message))
        })
    })

    test('shadows follow a mesh', async (t) => {
      for (const kind of ['directional', 'spot', 'point']) {
        messages.length = 0
        const { isSame, differing, moved } = await page.evaluate((kind) => exact.shadow(kind), kind)
        t.diagnostic(`${kind}: ${differing} pixels differ, ${moved} without the displacement`)
        assert.deepEqual([messages, isSame], [[], true])
        assert.ok(moved > 1000 && differing <= 10, `${differing} of ${moved}`)
      }
      const { differing } = await page.evaluate(() => exact.shadow('directional', false))
      assert.ok(differing > 100, 'the shadow of a mesh whose material alone is exact')
    })

    test('a displacement map moves a shadow once', async (t) => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => exact.shadowOfMap())
      t.diagnostic(`${differing} pixels differ, ${moved} without the displacement`)
      assert.deepEqual(messages, [])
      assert.ok(moved > 200 && differing <= 10, `${differing} of ${moved}`)
    })

    test('shadows and rays follow a material that is compiled again', async (t) => {
      for (const kind of ['onBeforeCompile', 'defines']) {
        messages.length = 0
        const { differing, stale, ray, expected } = await page.evaluate(
          (k) => exact.recompile(k),
          kind,
        )
        t.diagnostic(`${kind}: ${differing} pixels differ, ${stale} from those before`)
        assert.deepEqual(messages, [])
        assert.ok(stale > 500 && differing <= 10, `${differing} of ${stale}`)
        assert.ok(Math.abs(ray - expected) < 1e-3, `${ray} instead of ${expected}`)
      }
    })

    test('rays and bounds follow a mesh, also before it is drawn', async () => {
      const found = await page.evaluate(() => exact.cpu())
      assert.ok(Math.abs(found.later - found.expected) < 1e-3, JSON.stringify(found))
      assert.ok(Math.abs(found.before - found.after) < 1e-6, JSON.stringify(found))
      assert.ok(Math.abs(found.before - found.later) > 0.05, JSON.stringify(found))
      assert.deepEqual([found.covers, found.isTight], [true, true], JSON.stringify(found))
    })

    test('a mesh is culled by where it is drawn', async () => {
      const drawn = await page.evaluate(() => [true, false].map((is) => exact.culling(is)))
      assert.deepEqual(drawn, [true, false])
    })

    test('a warp on top transforms the exact normals', async (t) => {
      for (const normals of ['vertex', 'pixel']) {
        messages.length = 0
        const { differing, moved } = await page.evaluate((n) => exact.warpOnTop(n), normals)
        t.diagnostic(`${normals}: ${differing} pixels differ, ${moved} without the warp`)
        assert.deepEqual(messages, [])
        assert.ok(moved > 400 && differing <= 5, `${differing} of ${moved}`)
      }
    })

    test('materials that differ in their onBeforeCompile do not share a program', async () => {
      assert.ok((await page.evaluate(() => exact.twins())) > 400)
    })

    test('wrong calls throw', async () => {
      assert.deepEqual(await page.evaluate(() => exact.wrongCalls()), wrongCalls)
    })
  })
