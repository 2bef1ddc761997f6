// 'warpjet/three/webgpu': what three.test.js shows for WebGLRenderer, for WebGPURenderer on both its backends.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

const seen = 200

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

/** Those that WebGPURenderer draws otherwise, or not at all. */
const others = new Set([
  'a shader that is changed already',
  "a ShaderMaterial of three's chunks",
  'clipping',
  'environment map',
  'MeshDepthMaterial',
  'wireframe',
])

for (const backend of ['webgl', 'webgpu'])
  describe(`the backend ${backend}`, () => {
    async function isSame(name, settings) {
      messages.length = 0
      const { differing, moved, afterwards } = await page.evaluate(
        ([name, settings]) => three.compare(name, settings),
        [name, { backend, ...settings }],
      )
      assert.deepEqual(messages, [], name)
      // A line is as thin as what rounding decides.
      const most = name.endsWith('line') ? 2 : 0
      assert.ok(
        differing <= most,
        `${name}: ${differing} pixels differ from the motion by three.js`,
      )
      assert.ok(moved > seen, `${name}: ${moved} pixels differ from no motion`)
      assert.equal(afterwards, 0, `${name}: pixels that dispose() leaves otherwise than they were`)
    }

    test('shapes and materials, in the space of the object', async () => {
      const all = await page.evaluate(() => three.names)
      const names = isRun('every material of three')
        ? all.filter((name) => !others.has(name))
        : ['vertex tangents', 'skin', 'instances', 'batch']
      const lights = ['directional', 'spot', 'point']
      for (const [i, name] of names.entries()) await isSame(name, { light: lights[i % 3] })
    })

    test('in the world', async () => {
      for (const name of ['vertex tangents', 'instances', 'skin'])
        await isSame(name, { space: 'world' })
    })

    test('a motion that mirrors, of both sides', async () => {
      for (const name of ['plain', 'normal map', 'bump map', 'skin', 'instances'])
        for (const isKnown of [true, false]) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, settings]) => three.mirror(name, settings),
            [name, { backend, isKnown }],
          )
          assert.deepEqual([messages, differing], [[], 0], name)
          assert.ok(moved > seen, `${name}: ${moved}`)
        }
    })

    test('a normal in the world has length 1, however large the object', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate((given) => three.alongNormal(given), {
        backend,
      })
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > seen)
    })

    test('MeshNormalMaterial shows the normals of a wave, also after a week, and so does a node', async () => {
      for (const asNode of [false, true]) {
        const { worst, unwarped } = await page.evaluate((settings) => three.normals(settings), {
          backend,
          asNode,
        })
        assert.ok(
          Math.max(...worst) <= 3 && unwarped > 30,
          `${worst} of 255, ${unwarped} without the warp`,
        )
      }
    })

    test('an image among the uniforms', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate((settings) => three.image(settings), {
        backend,
      })
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > seen)
    })

    test('each of several warps with one code has its own uniforms', async () => {
      const [small, large, again] = await page.evaluate(
        ([all, settings]) => three.amounts(all, settings),
        [[0, 0.3, 0], { backend }],
      )
      // A sphere's outline is a circle, in perspective nearly as much larger as its radius.
      assert.ok(large > 1.5 * small, `${large} pixels beside ${small}`)
      assert.equal(again, small)
    })

    test('a texture is sampled as it is set, by glsl.texture and by texture() in GLSL', async () => {
      for (const name of await page.evaluate(() => three.samplings))
        for (const kind of ['builder', 'glsl']) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, kind, settings]) => three.sampling(name, kind, settings),
            [name, kind, { backend }],
          )
          assert.deepEqual(messages, [])
          // Vertices are moved in float32 and in double: an edge may fall into the next pixel.
          assert.ok(differing <= 4, `${name}, ${kind}: ${differing} pixels differ`)
          assert.ok(moved > seen, `${name}, ${kind}: only ${moved} pixels are moved`)
        }
    })

    test('soft, hard and variance shadows', async () => {
      for (const map of ['Basic', 'PCF', 'VSM'])
        for (const light of map === 'VSM'
          ? ['directional', 'spot']
          : ['directional', 'spot', 'point'])
          await isSame('plain', { light, map })
    })

    test('one warp is drawn by WebGLRenderer too, whichever comes', async () => {
      messages.length = 0
      const found = await page.evaluate((given) => three.both(given), { backend })
      for (const [name, { differing, moved }] of Object.entries(found)) {
        assert.equal(differing, 0, name)
        assert.ok(moved > seen, name)
      }
      assert.deepEqual(messages, [])
    })

    // A thousand times it is the same, by hand: six minutes.
    test('warped and disposed many times, nothing is left', async () => {
      const { before, after } = await page.evaluate((given) => three.churn(given), {
        backend,
        times: 30,
      })
      const { heap: heapBefore, ...countsBefore } = before
      const { heap, ...counts } = after
      assert.deepEqual(counts, countsBefore)
      assert.ok(heap < heapBefore + 9e5, `the heap grew from ${heapBefore} to ${heap}`)
    })

    test('without normals hundreds of pixels would differ', async () => {
      const { differing } = await page.evaluate((settings) => three.compare('plain', settings), {
        backend,
        sabotage: 'normals',
      })
      assert.ok(differing > 100, `${differing} pixels differ`)
    })
  })
