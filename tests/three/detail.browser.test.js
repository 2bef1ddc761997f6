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

/** Names the kinds of motion of a pose, for a title. */
const nameOf = ({ hasBones, hasMorphs }) =>
  [hasBones && 'bones', hasMorphs && 'morph targets'].filter(Boolean).join(' and ')

/**
 * Checks how many pixels or rays differ from those of the fine mesh: few with detail (`beyond`), many without. For a list of pictures, the
 * caller passes the max and the min.
 */
function checkDiffering(
  { beyond: differing, without: differingWithoutDetail },
  maxDiffering,
  minWithout,
  what = 'pixels',
) {
  assert.ok(
    differing <= maxDiffering,
    `expected at most ${maxDiffering} differing ${what} with detail, got ${differing}`,
  )
  assert.ok(
    differingWithoutDetail > minWithout,
    `expected more than ${minWithout} differing ${what} without detail, got ${differingWithoutDetail}`,
  )
}

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
          checkDiffering(found, 3, minWithout)
          const { triangles, fine: fineTriangles } = found
          assert.ok(triangles > 100 && triangles < fineTriangles / 10)
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
        assert.ok(found.beyond <= 3, `${found.beyond} pixels differ`)
        assert.ok(flat.beyond > 30, `${flat.beyond} pixels differ with flat triangles`)
      })

    test('the shadow of a divided mesh looks like that of a fine one', async (t) => {
      const found = await measure('compare', { name: 'twist', hasShadow: true })
      t.diagnostic(JSON.stringify(found))
      assert.deepEqual(messages, [])
      // Detail meets its tolerance as seen from the camera. The light sees the same triangles from the side, so more pixels of the shadow may
      // differ.
      checkDiffering(found, 59, 1000)
    })

    test('the shadow of a mesh outside of the picture looks like that of a fine one', async (t) => {
      for (const [light, maxDiffering, minWithout] of [
        ['sun', 149, 5000],
        ['bulb', 19, 100],
      ]) {
        const more = { name: 'twist', hasShadow: true, isOutside: true, light }
        const found = await measure('compare', more)
        t.diagnostic(`${light}: ${JSON.stringify(found)}`)
        assert.deepEqual(messages, [])
        checkDiffering(found, maxDiffering, minWithout)
      }
    })

    for (const kinds of [
      { hasBones: true, hasMorphs: false },
      { hasBones: false, hasMorphs: true },
      { hasBones: true, hasMorphs: true },
    ])
      test(`a divided mesh in a pose looks like a fine one: ${nameOf(kinds)}`, async (t) => {
        for (const more of [{ look: 'normals' }, { look: 'colors', space: 'world' }]) {
          const found = await measure('comparePoses', { kinds, ...more })
          t.diagnostic(JSON.stringify(found))
          assert.deepEqual(messages, [])
          const { beyond, without, triangles, fine: fineTriangles, isRestored } = found
          checkDiffering({ beyond: Math.max(...beyond), without: Math.min(...without) }, 10, 500)
          assert.ok(triangles > 100 && triangles < fineTriangles / 4)
          assert.ok(isRestored)
        }
      })

    test("rays hit the drawn surface and report triangles of the user's geometry", async (t) => {
      for (const more of [{}, { space: 'world' }, { isMoved: true }]) {
        const found = await measure('rays', more)
        t.diagnostic(JSON.stringify(found))
        assert.deepEqual(messages, [])
        assert.ok(found.hits > 100 && found.areOnMesh)
        checkDiffering(found, 2, 30, 'rays')
        const { errorOfUv: maxUvError } = found
        assert.ok(maxUvError < 1e-3, `${maxUvError}`)
      }
    })

    test('only the side that is seen is divided', async (t) => {
      for (const side of ['FrontSide', 'BackSide'])
        for (const scale of [1, -1]) {
          const found = await measure('side', { side, scale })
          t.diagnostic(`${side}, ${scale}: ${JSON.stringify(found)}`)
          assert.deepEqual(messages, [])
          // A thousandth of the picture: at corners of the texture's squares, one picture may lack a color of the other.
          assert.ok(found.beyond < 65, `${found.beyond} pixels differ`)
          assert.ok(found.triangles < 0.8 * found.both, `${found.triangles} of ${found.both}`)
        }
    })

    const frames = isRun('300 moving frames') && hasManyPictures(host) ? 300 : 60
    test(`closed shapes have no holes in ${frames} moving frames`, async (t) => {
      const found = await measure('holes', { frames })
      t.diagnostic(JSON.stringify(found))
      assert.deepEqual([messages, found.holes], [[], 0])
      const { least: minCovered } = found
      assert.ok(minCovered > 2000, `${minCovered} pixels are covered`)
      assert.ok(found.divisions > frames / 6, `${found.divisions} divisions`)
      // Breaks an edge on purpose, to check that holes are noticed: in each division, or in the mesh itself where compute passes write the
      // indices, which we cannot change. With a tolerance of one pixel, most gaps would be narrower than a pixel.
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
        checkDiffering(found, 3, 300, `pixels of ${check}`)
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
      test(`no detail for ${kind}, with one warning`, async () => {
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
