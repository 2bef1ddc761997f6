// Tests 'warpjet/babylon' in a page: a warp with a linear offset draws the same picture as Babylon.js with the matrix of the same motion.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { bundledPage } from '../support/browser/bundled-page.js'
import { countDiffering } from '../support/browser/three/pixels.js'

let opened
before(async () => (opened = await bundledPage('babylon/page-motion.js', { hasWebGPU: true })))
after(() => opened.close())

const draw = async (...args) =>
  Buffer.from(await opened.page.evaluate((args) => draw(...args), args), 'base64')
/** Returns the new console messages, without Babylon.js's greeting. */
const takeMessages = () => opened.messages.splice(0).filter((text) => !text.startsWith('BJS - '))

for (const backend of isRun('Babylon.js on WebGPU') ? ['webgl', 'webgpu'] : ['webgl'])
  describe(backend, () => {
    for (const kind of ['Standard', 'PBR'])
      test(`${kind}Material and its shadow look like the mesh moved by a matrix`, async () => {
        const still = await draw(backend, kind, 'still')
        const moved = await draw(backend, kind, 'moved')
        const warpedPicture = await draw(backend, kind, 'warped')
        assert.ok(
          countDiffering(still, moved) > 300,
          `${countDiffering(still, moved)} pixels are moved`,
        )
        assert.equal(countDiffering(warpedPicture, moved), 0)
        assert.equal(countDiffering(await draw(backend, kind, 'warped at pixel'), moved), 0)
        for (const without of ['without its normals', 'without its shadow']) {
          const count = countDiffering(await draw(backend, kind, without), moved)
          assert.ok(count > 100, `${count} pixels differ ${without}`)
        }
        if (kind === 'Standard') {
          const off = await draw(backend, kind, 'switched off')
          assert.equal(countDiffering(off, still), 0)
        }
        assert.deepEqual(takeMessages(), [])
      })

    for (const kind of ['Standard', 'PBR'])
      test(`${kind}Material under a motion that mirrors looks like the mesh moved by a matrix, on both sides`, async () => {
        const still = await draw(backend, kind, 'mirror nothing')
        const expected = await draw(backend, kind, 'mirrored')
        assert.ok(countDiffering(still, expected) > 300)
        for (const variant of ['constant', 'uniform', 'constant, at pixel', 'uniform, at pixel'])
          assert.equal(
            countDiffering(await draw(backend, kind, `mirroring, ${variant}`), expected),
            0,
            variant,
          )
        assert.equal(countDiffering(await draw(backend, kind, 'mirroring, switched off'), still), 0)
        assert.deepEqual(takeMessages(), [])
      })

    test('a wave is exact at 98,765,432 milliseconds', async () => {
      const expected = await draw(backend, 'Standard', 'wave by exact phase')
      const shown = await draw(backend, 'Standard', 'wave by millis')
      assert.equal(countDiffering(shown, expected), 0)
      const rounded = countDiffering(
        await draw(backend, 'Standard', 'wave by rounded phase'),
        expected,
      )
      assert.ok(rounded > 30, `${rounded} pixels differ if the phase is rounded to float32`)
      assert.deepEqual(takeMessages(), [])
    })

    test('a uniform can be an image', async () => {
      const [shown, expected] = [
        await draw(backend, 'Standard', 'by an image'),
        await draw(backend, 'Standard', 'shifted'),
      ]
      assert.equal(countDiffering(shown, expected), 0)
      assert.ok(countDiffering(expected, await draw(backend, 'Standard', 'still')) > 300)
      assert.deepEqual(takeMessages(), [])
    })

    test('a texture is sampled with its own wrap modes, scale and offset', async () => {
      const [shown, expected] = [
        await draw(backend, 'Standard', 'sampled by settings'),
        await draw(backend, 'Standard', 'sampled by options'),
      ]
      assert.ok(countDiffering(shown, expected) <= 4)
      assert.ok(countDiffering(expected, await draw(backend, 'Standard', 'still')) > 300)
      assert.deepEqual(takeMessages(), [])
    })
  })

test('picking and culling use the warped mesh after refresh()', async () => {
  const { hits, misses, maxDistance, differingBefore, outside } = await opened.page.evaluate(() =>
    pick(),
  )
  assert.ok(
    hits > 60 && differingBefore > 60,
    `${hits} hits, ${differingBefore} differed before refresh`,
  )
  assert.equal(misses, 0)
  assert.ok(maxDistance < 1e-4, `hits are up to ${maxDistance} apart`)
  assert.equal(outside, false)
})

test('mistakes throw a message and leave earlier values unchanged', async () => {
  const { errors, isUnchanged } = await opened.page.evaluate(() => mistakes())
  const expected = [
    /^WarpError: BabylonWarp: the warp has no uniform "linaer"; it has linear, shift\.$/,
    /^WarpError: BabylonWarp: expected an array of 3 finite numbers for the uniform "shift", got the text "x"/,
    /^WarpError: BabylonWarp: expected .* for the uniform "shift", /,
    /^WarpError: BabylonWarp: expected a number of milliseconds for millis, got the text "x"; performance\.now\(\) gives one\.$/,
    /^WarpError: BabylonWarp: the material "standard" is warped already/,
    /^WarpError: BabylonWarp: the offset reads mouse, which Babylon\.js does not have; declare it, as in \{ uniforms: \{ myMouse: \[0, 0\] \} \}\.$/,
    /^WarpError: BabylonWarp: the offset reads "wind" by glsl\.param, which no shader of Babylon\.js declares; /,
    /^WarpError: BabylonWarp: expected a texture of Babylon\.js for the uniform "map", got /,
    /^WarpError: BabylonWarp: the MultiMaterial "parts" takes no plugins; warp its subMaterials\.$/,
    /^WarpError: BabylonWarp: there is no option "unifroms"; did you mean uniforms\?/,
    /^WarpError: BabylonWarp: expected only false for the option "surfaceVariation", got the boolean true; addSurfaceVariation\(mesh\) /,
    /^WarpError: BabylonWarp: expected a material of Babylon\.js, got /,
  ]
  assert.equal(errors.length, expected.length)
  errors.forEach((text, i) => assert.match(text, expected[i]))
  assert.equal(isUnchanged, true)
})
