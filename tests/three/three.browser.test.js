// Tests 'warpjet/three' with WebGLRenderer: a warp with a linear offset draws the same picture as the same motion through three's matrices,
// including shadows, on the current three.js and on the oldest supported one.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage } from '../support/browser/browser.js'
import { threePages, versions } from '../support/browser/three/open.js'

/** A fifth of the pixels that the smallest shape covers. */
const minMoved = 300

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

    async function assertSame(name, settings) {
      messages.length = 0
      const { differing, moved, afterwards } = await compare(name, settings)
      assert.deepEqual(messages, [])
      // Rounding can move pixels of a thin line.
      const tolerance = name.endsWith('line') ? 2 : 0
      assert.ok(differing <= tolerance, `${differing} pixels differ from the motion by three.js`)
      assert.ok(moved > minMoved, `${moved} pixels differ from no motion`)
      assert.equal(afterwards, 0, `${afterwards} pixels differ after dispose()`)
    }

    test('shapes and materials look the same in local space', async () => {
      const all = await page.evaluate(() => three.names)
      assert.ok(all.length > 25)
      const names = isRun('every material of three')
        ? all
        : ['vertex tangents', 'skin', 'morphs', 'instances', 'batch', 'line', 'MeshNormalMaterial']
      const lights = ['directional', 'spot', 'point']
      for (const [i, name] of names.entries())
        await assertSame(name, { light: lights[i % 3] }).catch((error) => {
          error.message = `${name}: ${error.message}`
          throw error
        })
    })

    test('shapes and materials look the same with normals at pixels', async () => {
      const names = await page.evaluate(() => three.names)
      // Three.js interpolates normals after the motion, and the warp interpolates them before. Both are wrong between the vertices of a
      // coarse mesh, and the colours of the matcap change within a few degrees.
      const maxDiffering = (name) => (name === 'MeshMatcapMaterial' ? 130 : 12)
      for (const name of names)
        for (const space of ['local', 'world']) {
          messages.length = 0
          const { differing, moved } = await compare(name, { space, normals: 'pixel' })
          const warnings = name === 'environment map' ? 1 : 0
          assert.equal(messages.length, warnings, `${name}: ${messages}`)
          assert.ok(
            differing <= maxDiffering(name),
            `${name}, ${space}: ${differing} pixels differ`,
          )
          assert.ok(moved > minMoved)
        }
    })

    test('an object with custom shadow materials looks the same', async () => {
      for (const light of ['directional', 'point'])
        await assertSame('custom shadow materials', { light })
    })

    test('a warp in world space looks the same', async () => {
      for (const name of [
        'plain',
        'vertex tangents',
        'skin',
        'instances',
        'batch',
        'group',
        'points',
      ])
        await assertSame(name, { space: 'world', light: name === 'skin' ? 'point' : 'spot' })
    })

    test("a warp in the space 'rest', before morph targets and bones, looks the same", async () => {
      for (const name of ['plain', 'vertex tangents', 'morphs', 'skin'])
        await assertSame(name, { space: 'rest', light: 'spot' })
    })

    test('a motion that mirrors looks the same on both sides', async () => {
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
          assert.ok(moved > minMoved, `${what}: ${moved}`)
        }
    })

    test('soft, hard and variance shadows look the same', async () => {
      for (const map of ['Basic', 'PCF', 'VSM'])
        for (const light of map === 'VSM'
          ? ['directional', 'spot']
          : ['directional', 'spot', 'point'])
          await assertSame('plain', { light, map })
    })

    test('logarithmic and reversed depth buffers work', async () => {
      await assertSame('plain', { options: { logarithmicDepthBuffer: true } })
      if (version === 'three') await assertSame('plain', { options: { reversedDepthBuffer: true } })
    })

    test('MeshNormalMaterial shows the exact normals of a wave, also after a week', async () => {
      const { worst, unwarped } = await page.evaluate(() => three.normals())
      assert.ok(
        Math.max(...worst) <= 3 && unwarped > 30,
        `errors of ${worst} of 255, ${unwarped} without the warp`,
      )
    })

    test('a uniform can be an image', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => three.image())
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > minMoved)
    })

    test("glsl.texture and texture() in GLSL use the texture's own settings", async () => {
      for (const name of await page.evaluate(() => three.samplings))
        for (const kind of ['builder', 'glsl']) {
          messages.length = 0
          const { differing, moved } = await page.evaluate(
            ([name, kind, settings]) => three.sampling(name, kind, settings),
            [name, kind, {}],
          )
          assert.deepEqual(messages, [])
          // The reference is computed in double precision, so an edge may be in an adjacent pixel.
          assert.ok(differing <= 4, `${name}, ${kind}: ${differing} pixels differ`)
          assert.ok(moved > minMoved, `${name}, ${kind}: only ${moved} pixels are moved`)
        }
    })

    test('three-custom-shader-material accepts the code of compileWarp unchanged', async () => {
      messages.length = 0
      const { differing, moved } = await page.evaluate(() => three.custom())
      assert.deepEqual([messages, differing], [[], 0])
      assert.ok(moved > minMoved)
    })

    const manyTimes = isRun('every material of three') && version === versions[0] ? 1000 : 100
    for (const [title, times, settings] of [
      ['30 times', 30, {}],
      [`${manyTimes} times beside another warped mesh`, manyTimes, { hasTwin: true }],
    ])
      test(`warping and disposing of a mesh ${title} leaks nothing`, async () => {
        const { before, after } = await page.evaluate(
          ([times, settings]) => three.churn(times, settings),
          [times, settings],
        )
        const { heap: heapBefore, ...countsBefore } = before
        const { heap, ...counts } = after
        assert.deepEqual(counts, countsBefore)
        const maxGrowth = Math.min(2e6, 20_000 * times)
        assert.ok(heap < heapBefore + maxGrowth, `the heap grew from ${heapBefore} to ${heap}`)
      })

    test('these tests would detect missing normals or shadow materials', async () => {
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
  test(`the first listing of ${file} runs unchanged`, async () => {
    const text = readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8')
    const [, code] = /^# ?.*three\.js\n[^]*?```js\n([^]*?)```/m.exec(
      text.replaceAll('\n## ', '\n# '),
    )
    const { page, messages } = await pages.listing(code)
    const countBrightPixels = () =>
      page.evaluate(async () => {
        const canvas = await new Promise(function look(resolve) {
          const canvas = document.querySelector('canvas')
          if (canvas) resolve(canvas)
          else requestAnimationFrame(() => look(resolve))
        })
        await new Promise(requestAnimationFrame)
        await new Promise(requestAnimationFrame)
        const gl = canvas.getContext('webgl2')
        const pixels = new Uint8Array(4 * canvas.width * canvas.height)
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
        return pixels.filter((byte, i) => i % 4 === 2 && byte > 64).length
      })
    const first = await countBrightPixels()
    await page.waitForTimeout(300)
    const second = await countBrightPixels()
    assert.deepEqual(messages, [])
    assert.ok(first > 5000 && second !== first, `${first} pixels, then ${second}`)
    await leavePage(page)
  })
