// Tests 'warpjet/three/webgpu' like three.browser.test.js, with WebGPURenderer on both backends.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

const minMoved = 200

let pages, page, messages
before(async () => {
  pages = await threePages([
    ...webgpuFlags,
    '--js-flags=--expose-gc',
    '--enable-precise-memory-info',
  ])
  ;({ page, messages } = await pages.open('three', 'page-webgpu.js'))
})
after(() => pages.close())

/** Shapes of scenes.js that WebGPURenderer itself draws differently, or not at all. */
const unsupported = new Set([
  'a shader that onBeforeCompile changes',
  "a ShaderMaterial with three's chunks",
  'clipping',
  'environment map',
  'MeshDepthMaterial',
  'wireframe',
])

for (const backend of ['webgl', 'webgpu'])
  describe(`the backend ${backend}`, () => {
    async function assertSame(name, settings) {
      messages.length = 0
      const { differing, moved, afterwards } = await page.evaluate(
        ([name, settings]) => three.compare(name, settings),
        [name, { backend, ...settings }],
      )
      assert.deepEqual(messages, [], name)
      // Rounding can move pixels of a thin line.
      const tolerance = name.endsWith('line') ? 2 : 0
      assert.ok(
        differing <= tolerance,
        `${name}: ${differing} pixels differ from the motion by three.js`,
      )
      assert.ok(moved > minMoved, `${name}: ${moved} pixels differ from no motion`)
      assert.equal(afterwards, 0, `${name}: ${afterwards} pixels differ after dispose()`)
    }

    test('shapes and materials look the same in local space', async () => {
      const all = await page.evaluate(() => three.names)
      const names = isRun('every material of three')
        ? all.filter((name) => !unsupported.has(name))
        : ['vertex tangents', 'skin', 'instances', 'batch']
      const lights = ['directional', 'spot', 'point']
      for (const [i, name] of names.entries()) await assertSame(name, { light: lights[i % 3] })
    })

    test('a warp in world space looks the same', async () => {
      for (const name of ['vertex tangents', 'instances', 'skin'])
        await assertSame(name, { space: 'world' })
    })

    test('a motion that mirrors looks the same on both sides', async () => {
      for (const name of ['plain', 'normal map', 'bump map', 'skin', 'instances'])
        for (const isKnown of [true, false]) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, settings]) => three.mirror(name, settings),
            [name, { backend, isKnown }],
          )
          assert.deepEqual([messages, differing], [[], 0], name)
          assert.ok(moved > minMoved, `${name}: ${moved}`)
        }
    })

    test('a normal in world space has length 1, whatever the scale of the object', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate((settings) => three.alongNormal(settings), {
        backend,
      })
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > minMoved)
    })

    test('MeshNormalMaterial and MeshNormalNodeMaterial show the exact normals of a wave, also after a week', async () => {
      for (const asNode of [false, true]) {
        const { worst, unwarped } = await page.evaluate((settings) => three.normals(settings), {
          backend,
          asNode,
        })
        assert.ok(
          Math.max(...worst) <= 3 && unwarped > 30,
          `errors of ${worst} of 255, ${unwarped} without the warp`,
        )
      }
    })

    test('a uniform can be an image', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate((settings) => three.image(settings), {
        backend,
      })
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > minMoved)
    })

    test('warps with the same code have separate uniforms', async () => {
      const [small, large, again] = await page.evaluate(
        ([factors, settings]) => three.amounts(factors, settings),
        [[0, 0.3, 0], { backend }],
      )
      // The radius grows by 1.3, and so the covered area by about 1.3² = 1.69.
      assert.ok(
        large > 1.5 * small,
        `${large} pixels are covered with the amount 0.3, ${small} with 0`,
      )
      assert.equal(again, small)
    })

    test("glsl.texture and texture() in GLSL use the texture's own settings", async () => {
      for (const name of await page.evaluate(() => three.samplings))
        for (const kind of ['builder', 'glsl']) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, kind, settings]) => three.sampling(name, kind, settings),
            [name, kind, { backend }],
          )
          assert.deepEqual(messages, [])
          // The reference is computed in double precision, so an edge may be in an adjacent pixel.
          assert.ok(differing <= 4, `${name}, ${kind}: ${differing} pixels differ`)
          assert.ok(moved > minMoved, `${name}, ${kind}: only ${moved} pixels are moved`)
        }
    })

    test('soft, hard and variance shadows look the same', async () => {
      for (const map of ['Basic', 'PCF', 'VSM'])
        for (const light of map === 'VSM'
          ? ['directional', 'spot']
          : ['directional', 'spot', 'point'])
          await assertSame('plain', { light, map })
    })

    test('WebGLRenderer and WebGPURenderer can draw the same warp', async () => {
      messages.length = 0
      const found = await page.evaluate((settings) => three.both(settings), { backend })
      for (const [name, { differing, moved }] of Object.entries(found)) {
        assert.equal(differing, 0, name)
        assert.ok(moved > minMoved, name)
      }
      assert.deepEqual(messages, [])
    })

    // A manual run of a thousand cycles, which takes six minutes, gave the same result.
    test('warping and disposing of a mesh many times leaks nothing', async () => {
      const { before, after } = await page.evaluate((settings) => three.churn(settings), {
        backend,
        times: 30,
      })
      const { heap: heapBefore, ...countsBefore } = before
      const { heap, ...counts } = after
      assert.deepEqual(counts, countsBefore)
      assert.ok(heap < heapBefore + 9e5, `the heap grew from ${heapBefore} to ${heap}`)
    })

    test('these tests would detect missing normals', async () => {
      const { differing } = await page.evaluate((settings) => three.compare('plain', settings), {
        backend,
        sabotage: 'normals',
      })
      assert.ok(differing > 100, `${differing} pixels differ`)
    })
  })
