// Tests that three.js draws a GLB file with a normal map like the same triangles with the exact normal of the warp at each pixel, which the
// GPU computes by the code of compileWarp at the interpolated original position.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { compileWarp } from 'warpjet'
import { bakeNormalMap, bakeWarp, exportGLB } from 'warpjet/mesh'
import { leavePage } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'
import { sphere } from '../support/meshes.js'

const offsets = {
  waves: ({ glsl, position: p }) =>
    glsl.vec3(p.y().mult(7).sin(), p.z().mult(7).sin(), p.x().mult(7).sin()).mult(0.1),
  simplex: ({ glsl, position: p }) => p.mult(glsl.simplex(p.mult(2)).mult(0.2)),
  fbm: ({ glsl, position: p }) => p.mult(glsl.fbm(p.mult(2)).mult(0.3)),
}

const base64 = ({ buffer, byteOffset, byteLength }) =>
  Buffer.from(buffer, byteOffset, byteLength).toString('base64')

let pages, page, messages
before(async () => {
  pages = await threePages()
  ;({ page, messages } = await pages.open('three', 'page-normal-map.js'))
})
after(async () => {
  await leavePage(page)
  await pages.close()
})

/**
 * Returns functions that compare a picture with the exact one. They return the mean and max difference, of 255, and the share of pixels
 * whose difference is at most 3.
 */
function comparisonsOf(offset, columns, rows, size = 1024) {
  const warp = compileWarp(offset)
  const { positions, normals, uvs, indices } = sphere(columns, rows)
  const mesh = { positions, normals, uvs, indices, material: { baseColor: [1, 1, 1, 1] } }
  const vertices = bakeWarp(mesh, warp)
  const { declarations, code } = warp
  const exact = {
    glb: base64(exportGLB(vertices)),
    declarations,
    code,
    positions: base64(positions),
    normals: base64(normals),
  }
  const compare = async (baked, change) => {
    const glb = base64(exportGLB(baked))
    const { covered, counts } = await page.evaluate(
      ([glb, exact, change]) => three.compare(glb, exact, change),
      [glb, exact, change],
    )
    assert.deepEqual(messages, [])
    assert.ok(covered > 25000)
    return {
      mean: counts.reduce((sum, count, i) => sum + count * i, 0) / covered,
      max: counts.findLastIndex((count) => count > 0),
      within3: counts.slice(0, 4).reduce((sum, count) => sum + count, 0) / covered,
    }
  }
  const baked = bakeNormalMap(mesh, warp, { size })
  return {
    compareVertices: () => compare(vertices),
    compareMap: (change) => compare(baked, change),
  }
}

describe('the map of a sphere', () => {
  for (const [name, columns, rows] of [
    ['waves', 24, 16],
    ['simplex', 60, 40],
  ])
    test(`${name}: every pixel is within 3 of 255`, async () => {
      const { compareVertices, compareMap } = comparisonsOf(offsets[name], columns, rows)
      const [vertices, map] = [await compareVertices(), await compareMap()]
      assert.ok(vertices.max > 40 && vertices.within3 < 0.6, JSON.stringify(vertices))
      assert.ok(map.max <= 3, JSON.stringify(map))
    })

  test('fbm: on average within 1.5, and nearly everywhere within 3 if texture filtering is anisotropic', async (t) => {
    const { compareVertices, compareMap } = comparisonsOf(offsets.fbm, 60, 40, 2048)
    const [vertices, map] = [await compareVertices(), await compareMap()]
    const anisotropic = await compareMap('anisotropic')
    t.diagnostic(JSON.stringify({ vertices, map, anisotropic }))
    assert.ok(vertices.mean > 15, JSON.stringify(vertices))
    assert.ok(map.mean < 1.5 && map.within3 > 0.96, JSON.stringify(map))
    assert.ok(anisotropic.within3 > 0.998, JSON.stringify(anisotropic))
  })
})

test('green is up, so that a program that computes tangents itself draws about the same', async () => {
  const { compareVertices, compareMap } = comparisonsOf(offsets.waves, 24, 16)
  const [vertices, up, down] = [
    await compareVertices(),
    await compareMap('no tangents'),
    await compareMap('green down'),
  ]
  assert.ok(up.mean < vertices.mean / 2, JSON.stringify({ up, vertices }))
  assert.ok(down.mean > vertices.mean, JSON.stringify({ down, vertices }))
})
