// The option `detail` of `warp`: coarse meshes against fine ones, on both renderers.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage, webgpuFlags } from '../support/browser/browser.js'
import { threePages, versions } from '../support/browser/three/open.js'
import { checkPictures, placesAround } from '../support/places-around.js'

const allHosts = [
  ...versions.map((version) => ({
    name: `WebGLRenderer, ${version}`,
    version,
    script: 'detail/page-webgl.js',
    settings: {},
  })),
  ...[
    { backend: 'webgl', hasPasses: false },
    { backend: 'webgpu', hasPasses: false },
    { backend: 'webgpu', hasPasses: true },
  ].map((settings) => ({
    name: `WebGPURenderer, ${settings.backend}${settings.hasPasses ? ', compute passes' : ''}`,
    version: 'three',
    script: 'detail/page-webgpu.js',
    settings,
  })),
]
const hosts = isRun('three 0.159 and WebGPURenderer') ? allHosts : allHosts.slice(0, 1)

/** Fewer pictures suffice on three 0.159 and the WebGL backend, where the same code divides and warps as on the other hosts. */
const hasManyPictures = ({ version, settings }) =>
  version === 'three' && settings.backend !== 'webgl'

let pages
before(async () => {
  pages = await threePages(webgpuFlags)
})
after(() => pages.close())

for (const host of hosts)
  describe(host.name, () => {
    const { version, script, settings } = host
    let page, messages
    before(async () => {
      ;({ page, messages } = await pages.open(version, script))
    })
    after(() => leavePage(page))

    async function measure(check, more = {}) {
      messages.length = 0
      return page.evaluate(
        ([check, settings]) => detail[check](settings),
        [check, { ...settings, ...more }],
      )
    }

    for (const [warp, minWithout] of [
      ['twist', 1000],
      ['bend', 300],
    ])
      test(`a box of 12 triangles under a ${warp} looks like a fine one`, async (t) => {
        for (const more of [{}, { space: 'world' }]) {
          const found = await measure('compare', { name: warp, ...more })
          t.diagnostic(JSON.stringify(found))
          assert.deepEqual(messages, [])
          assert.ok(found.beyond <= 3, `${found.beyond} pixels`)
          assert.ok(found.without > minWithout, `${found.without} pixels without detail`)
          assert.ok(found.triangles > 100 && found.triangles < found.fine / 10)
        }
      })

    if (hasManyPictures(host))
      test('a divided box is within a pixel of a dense one from 20 places', async (t) => {
        const found = await measure('around', { places: placesAround(1) })
        t.diagnostic(JSON.stringify(found))
        assert.deepEqual(messages, [])
        checkPictures(found)
      })

    // Compute passes do not divide curved triangles.
    if (!settings.hasPasses)
      test('curved triangles round a coarse sphere', async (t) => {
        const detail = { tolerance: 0.5, curved: true }
        const shapes = { coarse: 'ball', fine: 'fineBall' }
        const found = await measure('compare', { name: 'twist', ...shapes, detail })
        const flat = await measure('compare', { name: 'twist', ...shapes })
        t.diagnostic(JSON.stringify({ found, flat }))
        assert.deepEqual(messages, [])
        assert.ok(found.beyond <= 3, `${found.beyond} pixels`)
        assert.ok(flat.beyond > 30, `${flat.beyond} pixels with flat triangles`)
      })

    test('the shadow of a divided mesh looks like that of a fine one', async (t) => {
      const found = await measure('compare', { name: 'twist', hasShadow: true })
      t.diagnostic(JSON.stringify(found))
      assert.deepEqual(messages, [])
      // The tolerance holds for the camera; the light sees the surface from the side.
      assert.ok(found.beyond < 60, `${found.beyond} pixels`)
      assert.ok(found.without > 1000, `${found.without} pixels without detail`)
    })

    test('the shadow of a mesh outside of the picture looks like that of a fine one', async (t) => {
      for (const [light, maxBeyond, minWithout] of [
        ['sun', 150, 5000],
        ['bulb', 20, 100],
      ]) {
        const more = { name: 'twist', hasShadow: true, isOutside: true, light }
        const found = await measure('compare', more)
        t.diagnostic(`${light}: ${JSON.stringify(found)}`)
        assert.deepEqual(messages, [])
        assert.ok(found.beyond < maxBeyond, `${found.beyond} pixels`)
        assert.ok(found.without > minWithout, `${found.without} pixels without detail`)
      }
    })

    for (const kinds of [
      { hasBones: true, hasMorphs: false },
      { hasBones: false, hasMorphs: true },
      { hasBones: true, hasMorphs: true },
    ])
      test(`poses look like fine ones: ${JSON.stringify(kinds)}`, async (t) => {
        for (const more of [{ look: 'normals' }, { look: 'colors', space: 'world' }]) {
          const found = await measure('comparePoses', { kinds, ...more })
          t.diagnostic(JSON.stringify(found))
          assert.deepEqual(messages, [])
          assert.ok(Math.max(...found.beyond) <= 10, `${found.beyond} pixels`)
          assert.ok(Math.min(...found.without) > 500, `${found.without} pixels without detail`)
          assert.ok(found.triangles > 100 && found.triangles < found.fine / 4)
          assert.ok(found.isRestored)
        }
      })

    test('rays meet what is drawn, and name the triangles of the user', async (t) => {
      for (const more of [{}, { space: 'world' }, { isMoved: true }]) {
        const found = await measure('rays', more)
        t.diagnostic(JSON.stringify(found))
        assert.deepEqual(messages, [])
        assert.ok(found.hits > 100 && found.areOnMesh)
        assert.ok(found.beyond <= 2, `${found.beyond} rays`)
        assert.ok(found.without > 30, `${found.without} rays without detail`)
        assert.ok(found.errorOfUv < 1e-3, `${found.errorOfUv}`)
      }
    })

    test('only the side that is seen is divided', async (t) => {
      for (const side of ['FrontSide', 'BackSide'])
        for (const scale of [1, -1]) {
          const found = await measure('side', { side, scale })
          t.diagnostic(`${side}, ${scale}: ${JSON.stringify(found)}`)
          assert.deepEqual(messages, [])
          // A thousandth of the picture: the corners of the squares are details, too.
          assert.ok(found.beyond < 65, `${found.beyond} pixels`)
          assert.ok(found.triangles < 0.8 * found.both, `${found.triangles} of ${found.both}`)
        }
    })

    const frames = isRun('300 moving frames') && hasManyPictures(host) ? 300 : 60
    test(`closed shapes have no holes in ${frames} moving frames`, async (t) => {
      const found = await measure('holes', { frames })
      t.diagnostic(JSON.stringify(found))
      assert.deepEqual([messages, found.holes], [[], 0])
      assert.ok(found.least > 2000, `${found.least} pixels are covered`)
      assert.ok(found.divisions > frames / 6, `${found.divisions} divisions`)
      // With a tolerance of one pixel, most gaps of a broken edge would be narrower than a pixel. We cannot change indices that compute passes write.
      const broken = settings.hasPasses ? 'mesh' : 'division'
      const holes = await measure('holes', { frames: 40, broken, tolerance: 3 })
      t.diagnostic(`broken: ${JSON.stringify(holes)}`)
      assert.ok(holes.framesWithHoles > 0, 'a broken edge is not noticed')
    })

    test('instances and groups look like fine ones', async (t) => {
      for (const check of ['instances', 'groups']) {
        const found = await measure(check)
        t.diagnostic(`${check}: ${JSON.stringify(found)}`)
        assert.deepEqual(messages, [], check)
        assert.ok(found.beyond <= 3, `${check}: ${found.beyond} pixels`)
        assert.ok(found.without > 300, `${found.without} pixels without detail`)
      }
    })

    test('hooks, cameras, geometries and clones may change, and dispose() frees everything', async (t) => {
      const found = await measure('countOverTime')
      t.diagnostic(JSON.stringify(found))
      assert.deepEqual(messages, [])
      const { counts, before, after } = found
      assert.equal(before.triangles, 12)
      assert.ok(counts.near > 100)
      assert.ok(counts.far < counts.near, `${counts.far} far away`)
      assert.equal(counts.again, counts.near)
      assert.notEqual(counts.changed, counts.near)
      assert.ok(counts.sphere > 48)
      assert.equal(counts.disposed, counts.sphere)
      assert.equal(counts.clone, 2 * counts.removed)
      assert.equal(counts.outside, 12)
      assert.equal(counts.back, counts.removed)
      assert.deepEqual(found.calls, ['before', true, 'after', true, 'before', true])
      assert.deepEqual(after, before)
      assert.ok(found.isSame && found.isRestored)
      assert.deepEqual(found.hooks, ['function', 'function'])
    })

    test('a frame that throws leaves the geometry as it was', async () => {
      assert.deepEqual(await measure('throwing'), {
        error: 'on purpose',
        isRestored: true,
        isSame: true,
      })
    })

    for (const [kind, message, space] of [
      ['points', /points and lines are not divided/],
      ['lines', /points and lines are not divided/],
      ['batch', /the geometries of a batch are not divided/],
      ['instances', /an InstancedBufferGeometry is not divided/],
      ['morphs', /bones or morph targets move the warped surface in the space 'rest'/, 'rest'],
    ])
      test(`${kind} are not divided, with one warning`, async () => {
        const { own, found } = await measure('countUndivided', { kind, space })
        assert.equal(found, own)
        assert.equal(messages.length, 1, messages.join('\n'))
        assert.match(messages[0], /although the option detail asks for more: /)
        assert.match(messages[0], message)
      })

    test('a group gets one warning per reason', async () => {
      await measure('warnOfGroup', { kinds: ['points', 'lines', 'batch'] })
      assert.equal(messages.length, 2, messages.join('\n'))
      assert.match(messages[0], /points and lines are not divided/)
      assert.match(messages[1], /the geometries of a batch are not divided/)
    })

    if (!settings.backend)
      test('a mesh has more triangles on a larger canvas, while a second renderer draws, too', async (t) => {
        const counts = await page.evaluate(() => detail.countOnCanvases([128, 512, 128]))
        t.diagnostic(JSON.stringify(counts))
        const [[small, onSecond], [large]] = counts
        assert.ok(large > 1.5 * small, `${large} and ${small}`)
        assert.ok(onSecond > 12)
      })
  })
