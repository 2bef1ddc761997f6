// 'warpjet/three' with WebGLRenderer: a motion that matrices can do, done by a warp and by three.js itself, is the same picture,
// shadows and all, on the three.js of today and on the oldest that is supported.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage } from '../support/browser/browser.js'
import { threePages, versions } from '../support/browser/three/open.js'

/** A fifth of what the smallest of the shapes covers. */
const seen = 300

let pages
before(async () => {
  pages = await threePages(['--js-flags=--expose-gc', '--enable-precise-memory-info'])
})
after(() => pages.close())

for (const version of isRun('three 0.159') ? versions : versions.slice(0, 1))
  describe(version, () => {
    let page, messages
    before(async () => ({ page, messages } = await pages.open(version)))
    after(() => leavePage(page))

    const compare = (name, settings = {}) =>
      page.evaluate(([name, settings]) => three.compare(name, settings), [name, settings])

    async function isSame(name, settings) {
      messages.length = 0
      const { differing, moved, afterwards } = await compare(name, settings)
      assert.deepEqual(messages, [])
      // A line is as thin as what rounding decides.
      const most = name.endsWith('line') ? 2 : 0
      assert.ok(differing <= most, `${differing} pixels differ from the motion by three.js`)
      assert.ok(moved > seen, `${moved} pixels differ from no motion`)
      assert.equal(afterwards, 0, 'pixels that dispose() leaves otherwise than they were')
    }

    test('every shape and every material, in the space of the object', async () => {
      const all = await page.evaluate(() => three.names)
      assert.ok(all.length > 25)
      const names = isRun('every material of three')
        ? all
        : ['vertex tangents', 'skin', 'morphs', 'instances', 'batch', 'line', 'MeshNormalMaterial']
      const lights = ['directional', 'spot', 'point']
      for (const [i, name] of names.entries())
        await isSame(name, { light: lights[i % 3] }).catch((error) => {
          error.message = `${name}: ${error.message}`
          throw error
        })
    })

    test('every shape and every material with normals at pixels', async () => {
      const names = await page.evaluate(() => three.names)
      // Three.js interpolates the normals of the motion in view space, and the warp interpolates those before it. Both are wrong between
      // the vertices of a coarse mesh, and the colours of this matcap change within a few degrees.
      const mostOf = (name) => (name === 'MeshMatcapMaterial' ? 130 : 12)
      for (const name of names)
        for (const space of ['local', 'world']) {
          messages.length = 0
          const { differing, moved } = await compare(name, { space, normals: 'pixel' })
          const warnings = name === 'environment map' ? 1 : 0
          assert.equal(messages.length, warnings, `${name}: ${messages}`)
          assert.ok(differing <= mostOf(name), `${name}, ${space}: ${differing} pixels differ`)
          assert.ok(moved > seen)
        }
    })

    test('materials of shadows that the object has already', async () => {
      for (const light of ['directional', 'point'])
        await isSame('materials of shadows of its own', { light })
    })

    test('in the world', async () => {
      for (const name of [
        'plain',
        'vertex tangents',
        'skin',
        'instances',
        'batch',
        'group',
        'points',
      ])
        await isSame(name, { space: 'world', light: name === 'skin' ? 'point' : 'spot' })
    })

    test('at rest, before morph targets and bones', async () => {
      for (const name of ['plain', 'vertex tangents', 'morphs', 'skin'])
        await isSame(name, { space: 'rest', light: 'spot' })
    })

    test('a motion that mirrors, of both sides', async () => {
      const names = ['plain', 'normal map', 'bump map', 'vertex tangents', 'skin', 'instances']
      const more = ['batch', 'group', 'morphs', 'flat shading', 'MeshPhysicalMaterial', 'clipping']
      for (const name of [...names, ...more, 'MeshNormalMaterial', 'MeshMatcapMaterial'])
        for (const [isKnown, space] of [
          [true, 'local'],
          [false, 'local'],
          [false, 'world'],
        ]) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, settings]) => three.mirror(name, settings),
            [name, { isKnown, space }],
          )
          const what = `${name}, ${space}${isKnown ? '' : ', by uniforms'}`
          assert.deepEqual(messages, [], what)
          assert.equal(differing, 0, what)
          assert.ok(moved > seen, `${what}: ${moved}`)
        }
    })

    test('soft, hard and variance shadows', async () => {
      for (const map of ['Basic', 'PCF', 'VSM'])
        for (const light of map === 'VSM'
          ? ['directional', 'spot']
          : ['directional', 'spot', 'point'])
          await isSame('plain', { light, map })
    })

    test('logarithmic and reversed depth', async () => {
      await isSame('plain', { options: { logarithmicDepthBuffer: true } })
      if (version === 'three') await isSame('plain', { options: { reversedDepthBuffer: true } })
    })

    test('MeshNormalMaterial shows the normals of a wave, also after a week', async () => {
      const { worst, unwarped } = await page.evaluate(() => three.normals())
      assert.ok(
        Math.max(...worst) <= 3 && unwarped > 30,
        `${worst} of 255, ${unwarped} without the warp`,
      )
    })

    test('an image among the uniforms', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => three.image())
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > seen)
    })

    test('a texture is sampled as it is set, by glsl.texture and by texture() in GLSL', async () => {
      for (const name of await page.evaluate(() => three.samplings))
        for (const kind of ['builder', 'glsl']) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, kind, settings]) => three.sampling(name, kind, settings),
            [name, kind, {}],
          )
          assert.deepEqual(messages, [])
          // Vertices are moved in float32 and in double: an edge may fall into the next pixel.
          assert.ok(differing <= 4, `${name}, ${kind}: ${differing} pixels differ`)
          assert.ok(moved > seen, `${name}, ${kind}: only ${moved} pixels are moved`)
        }
    })

    test('three-custom-shader-material takes the text as it is', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => three.custom())
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > seen)
    })

    const manyTimes = isRun('every material of three') && version === versions[0] ? 1000 : 100
    for (const [title, times, settings] of [
      ['thirty times', 30, {}],
      [`${manyTimes} times beside another`, manyTimes, { isBeside: true }],
    ])
      test(`warped and disposed ${title}, nothing is left`, async () => {
        const { before, after } = await page.evaluate(
          ([times, settings]) => three.churn(times, settings),
          [times, settings],
        )
        const { heap: heapBefore, ...countsBefore } = before
        const { heap, ...counts } = after
        assert.deepEqual(counts, countsBefore)
        const most = Math.min(2e6, 20_000 * times)
        assert.ok(heap < heapBefore + most, `the heap grew from ${heapBefore} to ${heap}`)
      })

    test('without normals, or without the materials of shadows, hundreds of pixels would differ', async () => {
      for (const [sabotage, name, light] of [
        ['normals', 'plain', 'directional'],
        ['depth', 'plain', 'directional'],
        ...(isRun('every material of three')
          ? [
              ['normals', 'skin', 'point'],
              ['depth', 'plain', 'point'],
              ['depth', 'instances', 'spot'],
            ]
          : []),
      ]) {
        const { differing } = await compare(name, { light, sabotage })
        assert.ok(differing > 100, `${name} without ${sabotage}: ${differing} pixels differ`)
      }
    })
  })

for (const file of ['web/docs/how-to-three.md', 'web/docs/three.md'])
  test(`the first listing of ${file} runs as it stands`, async () => {
    const text = readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8')
    const [, code] = /^# ?.*three\.js\n[^]*?```js\n([^]*?)```/m.exec(
      text.replaceAll('\n## ', '\n# '),
    )
    const { page, messages } = await pages.listing(code)
    const counted = () =>
      page.evaluate(async () => {
        const canvas = await new Promise(function look(found) {
          const there = document.querySelector('canvas')
          if (there) found(there)
          else requestAnimationFrame(() => look(found))
        })
        await new Promise(requestAnimationFrame)
        await new Promise(requestAnimationFrame)
        const gl = canvas.getContext('webgl2')
        const pixels = new Uint8Array(4 * canvas.width * canvas.height)
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
        return pixels.filter((byte, i) => i % 4 === 2 && byte > 64).length
      })
    const first = await counted()
    await page.waitForTimeout(300)
    const second = await counted()
    assert.deepEqual(messages, [])
    assert.ok(first > 5000 && second !== first, `${first} pixels, then ${second}`)
    await leavePage(page)
  })
