// `exactNormals` for materials of WebGLRenderer: compares normals at each vertex with finite differences of formulas in double precision.
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

/**
 * Maps a habit of shader authors → its warning. (Habits that read an attribute are exact nevertheless if the attribute is constant here.)
 */
const warnings = {
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
  'expected a whole number from 1 to 4096 for the option "maxIterations", got the number 0.',
  'there is no option "normal"; did you mean normals? The options are normals, surfaceVariation, maxIterations.',
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

    for (const table of ['chunks', 'customShaderMaterials', 'shaderMaterials', 'objects'])
      test(`every displacement of ${table}`, async (t) => {
        for (const [i, name] of names[table].entries()) {
          if (!isRun('every displacement') && i % 3) continue
          await t.test(name, async (t) => {
            const own = await measure(table, name)
            assert.ok(own.median > 1, `without exactNormals, normals are only ${own.median}° off`)
            for (const normals of stages) {
              messages.length = 0
              const found = await measure(table, name, normals)
              const { count, skipped, median, worst, farthest, finite } = found
              t.diagnostic(
                `${normals}: ${count} vertices, ${skipped} at kinks, median ${median}°, at most ${worst}°; without exactNormals ${own.median}°`,
              )
              assert.ok(finite && count > 140)
              assert.ok(worst < 0.03, `${worst}°`)
              assert.ok(farthest < 1e-3, `the position is off by ${farthest}`)
              const hasWarning =
                normals === 'pixel' && (table === 'shaderMaterials' || name in atVertices)
              assert.equal(messages.length, Number(hasWarning), messages.join('\n'))
              if (hasWarning) assert.match(messages[0], /at vertices, although/)
              if (hasWarning && name in atVertices) assert.match(messages[0], atVertices[name])
            }
          })
        }
      })

    test('loops run until they end', async (t) => {
      for (const name of names.longLoops) {
        messages.length = 0
        const own = await measure('longLoops', name)
        const { count, worst, farthest, finite } = await measure('longLoops', name, 'vertex')
        t.diagnostic(`${name}: at most ${worst}°, off by ${farthest}; without ${own.median}°`)
        assert.deepEqual(messages, [])
        assert.ok(own.median > 1 && finite && count > 140)
        assert.ok(worst < 0.03, `${name}: ${worst}°`)
        assert.ok(farthest < 1e-3, `${name}: the position is off by ${farthest}`)
      }
    })

    test('a loop that cannot stay a loop is cut off, with a message', async () => {
      const measureManyStates = async (options) => {
        messages.length = 0
        return page.evaluate((options) => exact.measureManyStates(options), options)
      }
      const cut = await measureManyStates({ iterations: 256 })
      assert.equal(messages.length, 1, messages.join('\n'))
      assert.match(
        messages[0],
        /^exactNormals: the MeshStandardMaterial has normals as if a loop ended early: line \d+, column \d+: only the shader knows .* after 256 iterations; .* maxIterations \(1 to 4096\)\.\n {2}while \(n < uEnd\)/,
      )
      assert.ok(cut.worst < 0.03, `${cut.worst}°`)
      // The shader still computes the position.
      const whole = await measureManyStates({ iterations: 400 })
      assert.ok(whole.worst > 0.1 && whole.farthest < 1e-3, `${whole.worst}°, ${whole.farthest}`)
      for (const maxIterations of [500, 90]) {
        const iterations = Math.min(maxIterations, 400)
        const { worst } = await measureManyStates({ iterations, maxIterations })
        assert.deepEqual(messages, [])
        assert.ok(worst < 0.03, `${maxIterations}: ${worst}°`)
      }
    })

    if (isRun('every habit'))
      test('shaders with other habits have exact normals, or a warning', async (t) => {
        for (const name of names.habits)
          await t.test(name, async (t) => {
            messages.length = 0
            const {
              own,
              exact: error,
              hasSamePositions,
            } = await page.evaluate((name) => exact.measureHabit(name), name)
            t.diagnostic(`${error}° at 95%; without exactNormals ${own}°`)
            assert.ok(hasSamePositions)
            const warning = warnings[name]
            assert.equal(messages.length, Number(warning !== undefined), messages.join('\n'))
            if (warning) assert.match(messages[0], warning)
            // The finite differences themselves are up to 0.16° off.
            else assert.ok(own > 1 && error < 0.2, `${error}°`)
          })
      })

    test('shaders that cannot be read stay as they are, with a message', async (t) => {
      for (const name of names.unsupported)
        await t.test(name, async () => {
          messages.length = 0
          const { message, isSame } = await page.evaluate((name) => exact.unsupported(name), name)
          assert.ok(isSame)
          const ours = messages.filter((text) => text.startsWith('exactNormals: '))
          assert.equal(ours.length, 1, messages.join('\n'))
          assert.match(ours[0], new RegExp(message))
        })
    })

    test('the shadow of a mesh follows the displacement', async (t) => {
      for (const kind of ['directional', 'spot', 'point']) {
        messages.length = 0
        const { isSame, differing, moved } = await page.evaluate((kind) => exact.shadow(kind), kind)
        t.diagnostic(`${kind}: ${differing} pixels differ, ${moved} without the displacement`)
        assert.deepEqual([messages, isSame], [[], true])
        assert.ok(moved > 1000 && differing <= 10, `${differing} of ${moved}`)
      }
      const { differing } = await page.evaluate(() => exact.shadow('directional', false))
      assert.ok(differing > 100, 'the shadow follows although only the material has exactNormals')
    })

    test('a displacement map moves a shadow only once', async (t) => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => exact.shadowOfMap())
      t.diagnostic(`${differing} pixels differ, ${moved} without the displacement`)
      assert.deepEqual(messages, [])
      assert.ok(moved > 200 && differing <= 10, `${differing} of ${moved}`)
    })

    test('shadows and rays follow a material that is recompiled', async (t) => {
      for (const kind of ['onBeforeCompile', 'defines']) {
        messages.length = 0
        const { differing, stale, ray, expected } = await page.evaluate(
          (k) => exact.recompile(k),
          kind,
        )
        t.diagnostic(`${kind}: ${differing} pixels differ, ${stale} differ from the picture before`)
        assert.deepEqual(messages, [])
        assert.ok(stale > 500 && differing <= 10, `${differing} of ${stale}`)
        assert.ok(Math.abs(ray - expected) < 1e-3, `expected a hit at ${expected}, got ${ray}`)
      }
    })

    test('rays and bounds follow the displacement, also before the mesh is drawn', async () => {
      const found = await page.evaluate(() => exact.cpu())
      assert.ok(Math.abs(found.later - found.expected) < 1e-3, JSON.stringify(found))
      assert.ok(Math.abs(found.before - found.after) < 1e-6, JSON.stringify(found))
      assert.ok(Math.abs(found.before - found.later) > 0.05, JSON.stringify(found))
      assert.deepEqual([found.covers, found.isTight], [true, true], JSON.stringify(found))
    })

    test('culling follows the displacement', async () => {
      const drawn = await page.evaluate(() =>
        [true, false].map((isFollowing) => exact.culling(isFollowing)),
      )
      assert.deepEqual(drawn, [true, false])
    })

    test('a warp of the same mesh transforms the exact normals', async (t) => {
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
