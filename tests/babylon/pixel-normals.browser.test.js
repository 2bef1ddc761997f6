// Normals at pixels in Babylon.js: compares the normal that a material uses for light, drawn in floats, with the exact one, which is
// computed from the unwarped position of each pixel.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { bundledPage } from '../support/browser/bundled-page.js'
import * as m from '../support/browser/matrix.js'
import { jacobian } from '../support/browser/oracle.js'
import { anglesOf, exactNormals, pixelWarps } from '../support/browser/pixel-normals.js'

const size = 160
/** The max error of a normal, in degrees. */
const bound = 0.1

let opened
before(async () => {
  opened = await bundledPage('babylon/page-pixel-normals.js', { hasWebGPU: true })
  const sources = Object.entries(pixelWarps).map(([name, { offset }]) => [name, offset])
  await opened.page.evaluate((all) => addOffsets(all), Object.fromEntries(sources))
})
after(() => opened.close())

/** Returns the new console messages, without Babylon.js's greeting. */
const takeMessages = () => opened.messages.splice(0).filter((text) => !text.startsWith('BJS - '))

/** Maps a shape → the warps that it is drawn with. */
const shapes = {
  sphere: ['fbm', 'simplex', 'worley', 'waves', 'twist', 'blob'],
  box: ['fbm', 'waves', 'blob'],
  plane: ['waves', 'flag'],
  torus: ['simplex', 'twist'],
}

/** Interpolated values of the unwarped mesh, which are drawn to find the exact normal at each pixel. */
const restValues = ['restPosition', 'restNormal', 'restUv']

async function draw(backend, what) {
  const result = await opened.page.evaluate(
    ([b, w]) => window.draw(b, w),
    [backend, { size, ...what }],
  )
  const pictures = Object.fromEntries(
    Object.entries(result.pictures).map(([name, base64]) => [
      name,
      new Float32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer),
    ]),
  )
  return { ...result, pictures }
}

/** Converts a matrix of Babylon.js, which multiplies row vectors, to one that multiplies column vectors. */
const fromBabylon = (numbers) =>
  [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => numbers[4 * column + row]))

const transformDirection = (matrix, d) => matrix.slice(0, 3).map((row) => m.dot(row, d))

const groupByThree = (list) =>
  Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3))

/**
 * Compares drawn and exact normals in world space. Returns the angles between them in degrees, { median, max }, where 99.9% of the pixels
 * are within `max`; the `count` of pixels that were compared; the `share` of sampled pixels that could be compared; and `normals`, the
 * stage that computed the drawn normals.
 */
async function compare(backend, what) {
  const { pictures, world, toClip, mesh, normals } = await draw(backend, {
    shows: ['normal', ...restValues],
    withMesh: true,
    ...what,
  })
  const toWorld = fromBabylon(world)
  const clip = m.product(fromBabylon(toClip), toWorld)
  const toScreen = (p) => {
    const [x, y, z] = m.transformPoint(clip, p)
    return [(size * (x + 1)) / 2, (size * (1 - y)) / 2, z]
  }
  const described = {
    vertices: groupByThree(mesh.positions),
    normals: groupByThree(mesh.normals),
    uvs: mesh.uvs,
    faces: groupByThree(mesh.indices),
    gradients: mesh.gradients,
  }
  const { exact, share } = exactNormals(what.warp, described, {
    toScreen,
    restAt: (pixel) => restValues.flatMap((name) => at(pictures[name], pixel)),
    width: size,
    height: size,
  })
  const inWorld = exact.map(({ pixel, normal }) => ({
    pixel,
    normal: m.transformNormal(toWorld, normal),
  }))
  return { ...anglesOf(inWorld, (pixel) => at(pictures.normal, pixel)), share, normals }
}

function assertExact(name, { max, count, share }) {
  assert.ok(
    count > 500 && share > 0.97,
    `${name}: ${count} pixels compared, ${share} of the sample`,
  )
  assert.ok(max < bound, `${name}: ${max} degrees off`)
}

/** Returns the numbers of a pixel. */
const at = (picture, pixel, count = 3) => [...picture.subarray(4 * pixel, 4 * pixel + count)]

/** Returns the indices of the pixels that a mesh covers. */
const coveredIn = (picture) => [...picture.keys()].filter((i) => picture[4 * i + 3] > 0)

/** Counts pixels whose colours or normals differ. */
const countDiffering = (a, b) =>
  [...Array(size * size).keys()].filter(
    (i) => !at(a, i, 4).every((x, k) => Math.abs(x - at(b, i, 4)[k]) < 0.02),
  ).length

for (const backend of ['webgl', 'webgpu'])
  describe(backend, () => {
    for (const warp of Object.keys(pixelWarps))
      test(`${warp}: within ${bound} degrees at 99.9% of pixels, on each shape`, async () => {
        for (const shape of Object.keys(shapes).filter((each) => shapes[each].includes(warp))) {
          const what = { kind: 'Standard', shape, warp, normals: 'pixel' }
          const found = await compare(backend, what)
          assertExact(shape, found)
          assert.equal(found.normals, 'pixel')
        }
        assert.deepEqual(takeMessages(), [])
      })

    test('PBRMaterial', async () => {
      for (const [shape, warp] of [
        ['sphere', 'simplex'],
        ['plane', 'flag'],
      ]) {
        const found = await compare(backend, { kind: 'PBR', shape, warp, normals: 'pixel' })
        assertExact(shape, found)
      }
      assert.deepEqual(takeMessages(), [])
    })

    test('thin instances, bones and mirrored meshes, with uneven scales', async () => {
      for (const how of ['thin instance', 'bone', 'mirrored']) {
        const shape = how === 'bone' ? 'sphere with a bone' : 'sphere'
        const what = { kind: 'Standard', shape, warp: 'simplex', normals: 'pixel', how }
        const found = await compare(backend, what)
        assertExact(how, found)
      }
      assert.deepEqual(takeMessages(), [])
    })

    test('facets stay facets', async () => {
      const what = { kind: 'Standard', shape: 'facets', warp: 'waves', normals: 'pixel' }
      assertExact('facets', await compare(backend, what))
    })

    test('interpolated normals of vertices are off by degrees', async () => {
      const what = { kind: 'Standard', shape: 'sphere', warp: 'simplex', normals: 'vertex' }
      const { median, normals } = await compare(backend, what)
      assert.equal(normals, 'vertex')
      assert.ok(median > 2, `${median} degrees off`)
    })

    test('by default, the warp selects the stage', async () => {
      for (const [warp, stage] of [
        ['simplex', 'pixel'],
        ['still', 'vertex'],
      ]) {
        const what = { kind: 'Standard', shape: 'sphere', warp, shows: ['normal'] }
        assert.equal((await draw(backend, what)).normals, stage)
      }
    })

    for (const kind of ['Standard', 'PBR'])
      test(`${kind}Material: a normal map uses the exact tangent`, async () => {
        const what = { kind, shape: 'plane with tangents', warp: 'waves', bump: true }
        const shows = ['normal', 'color', ...restValues]
        const { pictures, world } = await draw(backend, { ...what, normals: 'pixel', shows })
        const toWorld = fromBabylon(world)
        const [x, y, z] = await opened.page.evaluate(() => leaning.map((byte) => byte / 127.5 - 1))
        const covered = coveredIn(pictures.color).filter((_, i) => i % 23 === 0)
        assert.ok(covered.length > 200)
        const exact = covered.map((pixel) => {
          const restPosition = at(pictures.restPosition, pixel)
          const { waves } = pixelWarps
          const columns = jacobian((p) => m.add(p, waves.at(p)), restPosition, 1e-4)
          const tangent = m.normalize(transformDirection(toWorld, columns[0]))
          // Babylon.js's plane looks along -z, and v grows along y.
          const n = m.cross(columns[0], columns[1]).map((each) => -each)
          const normal = m.transformNormal(toWorld, n)
          const bitangent = m.cross(normal, tangent)
          return {
            pixel,
            normal: m.normalize(
              [0, 1, 2].map((i) => x * tangent[i] + y * bitangent[i] + z * normal[i]),
            ),
          }
        })
        const { max } = anglesOf(exact, (pixel) => at(pictures.normal, pixel))
        assert.ok(max < bound, `${max} degrees off`)
        const off = await draw(backend, { ...what, normals: 'pixel', shows, isOff: true })
        const still = await draw(backend, { ...what, warp: 'still', normals: 'vertex', shows })
        assert.equal(countDiffering(off.pictures.normal, still.pictures.normal), 0)
        assert.deepEqual(takeMessages(), [])
      })

    test('a surface that collapses is lit, and nothing is NaN', async () => {
      for (const normals of ['pixel', 'vertex'])
        for (const kind of ['Standard', 'PBR'])
          for (const shape of ['sphere', 'sphere with tangents'])
            for (const twoSided of [false, true]) {
              const what = {
                kind,
                shape,
                warp: 'floor',
                normals,
                twoSided,
                bump: shape !== 'sphere' && (kind === 'PBR' ? 'all' : true),
              }
              const shows = ['color', 'normal']
              const { pictures } = await draw(backend, { ...what, shows })
              const covered = coveredIn(pictures.color)
              const name = JSON.stringify(what)
              assert.ok(covered.length > 500, `${name}: ${covered.length} pixels`)
              assert.ok([...pictures.color, ...pictures.normal].every(Number.isFinite), name)
              const lit = covered.filter((i) => Math.max(...at(pictures.color, i)) > 0.05)
              assert.ok(lit.length > covered.length / 3, `${name}: ${lit.length} lit`)
              if (what.bump) continue
              // The eye looks along z.
              const facing = covered.filter((i) => pictures.normal[4 * i + 2] < 1e-3)
              assert.ok(facing.length > 0.99 * covered.length, `${name}: ${facing.length} facing`)
            }
      assert.deepEqual(takeMessages(), [])
    })

    test('a two-sided material under a warp that mirrors looks the same with normals at pixels and at vertices', async () => {
      for (const kind of ['Standard', 'PBR'])
        for (const warp of ['mirror', 'mirror by uniforms', 'still']) {
          const what = { kind, shape: 'plane', warp, twoSided: true, shows: ['color', 'normal'] }
          const [pixel, vertex] = [
            await draw(backend, { ...what, normals: 'pixel' }),
            await draw(backend, { ...what, normals: 'vertex' }),
          ]
          for (const each of what.shows)
            assert.equal(
              countDiffering(pixel.pictures[each], vertex.pictures[each]),
              0,
              `${warp} ${each}`,
            )
        }
      assert.deepEqual(takeMessages(), [])
    })

    test('diffuse light of an environment, which Babylon.js computes at vertices, uses the normals of pixels', async () => {
      const what = { kind: 'PBR', shape: 'sphere', warp: 'simplex', normals: 'pixel' }
      const shows = ['color']
      const [shown, expected] = [
        await draw(backend, { ...what, shows, irradiance: 'by default' }),
        await draw(backend, { ...what, shows, irradiance: 'fragment' }),
      ]
      assert.equal(countDiffering(shown.pictures.color, expected.pictures.color), 0)
      const { pictures } = await draw(backend, {
        ...what,
        shows,
        normals: 'vertex',
        irradiance: 'by default',
      })
      assert.ok(countDiffering(pictures.color, expected.pictures.color) > 500)
    })

    test("a material that cannot have normals at pixels has them at vertices, with a message if the option is 'pixel'", async () => {
      const stagesOf = (normals, why) =>
        opened.page.evaluate((given) => fallBack(...given), [backend, normals, why])
      for (const [why, message] of [
        ['varyings', /'pixel': it passes 5 vectors to pixels, of which this engine has \d left\.$/],
        [
          'shader',
          /'pixel': its fragment shader does not compute the normal as Babylon.js does\.$/,
        ],
      ]) {
        assert.deepEqual(await stagesOf('auto', why), ['pixel', 'vertex'])
        assert.deepEqual(takeMessages(), [])
        assert.deepEqual(await stagesOf('pixel', why), ['pixel', 'vertex'])
        const [warning, ...others] = takeMessages()
        assert.match(warning, message)
        assert.deepEqual(others, [])
      }
      assert.deepEqual(await stagesOf('pixel'), ['pixel', 'pixel'])
      assert.deepEqual(takeMessages(), [])
    })

    test('the varying of vertex colors counts toward the maximum number of varyings', async () => {
      const stagesOf = (why) =>
        opened.page.evaluate((given) => fallBack(...given), [backend, 'auto', why])
      assert.deepEqual(await stagesOf('7 varyings'), ['pixel', 'pixel'])
      assert.deepEqual(await stagesOf('colors and 7 varyings'), ['pixel', 'vertex'])
    })
  })

for (const backend of ['webgl', 'webgl without uniform buffers', 'webgpu'])
  test(`uniforms, millis, colours and an image, ${backend}`, async () => {
    const what = {
      kind: 'Standard',
      shape: 'plane with colors',
      warp: 'wave by uniforms',
      normals: 'pixel',
    }
    const { pictures, world } = await draw(backend, { ...what, shows: ['normal', ...restValues] })
    // The page sets a height of 0.2, a red of 0.5, 100 milliseconds, and an image whose red is 1.
    const offset = ([x, y]) => [0.1 * Math.sin(7 * y + 0.2), 0.1 * Math.sin(6 * x), 0]
    const exact = coveredIn(pictures.normal)
      .filter((_, i) => i % 23 === 0)
      .map((pixel) => {
        const restPosition = at(pictures.restPosition, pixel)
        const columns = jacobian((p) => m.add(p, offset(p)), restPosition, 1e-4)
        const n = m.cross(columns[0], columns[1]).map((each) => -each)
        return { pixel, normal: m.transformNormal(fromBabylon(world), n) }
      })
    const { max, count } = anglesOf(exact, (pixel) => at(pictures.normal, pixel))
    assert.ok(count > 200 && max < bound, `${max} degrees off at ${count} pixels`)
    assert.deepEqual(takeMessages(), [])
  })
