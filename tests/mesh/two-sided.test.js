// Tests surfaces that exist twice, facing both ways, in files without normals, where the two sides share vertices. The expected result of a
// side is that of a file with only this side.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from 'warpjet'
import { bakeWarp, loadMesh, subdivide } from 'warpjet/mesh'
import { edgesNotUsed } from '../support/deviation.js'
import { writeGlb } from '../support/glb.js'
import { grid } from '../support/meshes.js'

/** Makes a saddle over a grid, with an asymmetric bend. */
function saddle() {
  const { positions, indices } = grid(6, 5)
  for (let i = 0; i < positions.length; i += 3)
    positions[i + 2] = 0.2 * positions[i] * positions[i + 1] + 0.3 * Math.sin(positions[i])
  return { positions, indices: Array.from(indices) }
}

const backwards = (indices) => indices.map((_, i) => indices[i - (i % 3) + 2 - (i % 3)])

const files = {
  obj({ positions, indices }) {
    const lines = []
    for (let i = 0; i < positions.length; i += 3)
      lines.push(`v ${positions.subarray(i, i + 3).join(' ')}`)
    for (let i = 0; i < indices.length; i += 3)
      lines.push(
        `f ${indices
          .slice(i, i + 3)
          .map((index) => index + 1)
          .join(' ')}`,
      )
    return new TextEncoder().encode(lines.join('\n'))
  },
  glb({ positions, indices }) {
    const bytes = Buffer.concat([
      Buffer.from(positions.buffer),
      Buffer.from(Uint32Array.from(indices).buffer),
    ])
    const { byteLength } = positions
    const json = {
      asset: { version: '2.0' },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      buffers: [{ byteLength: bytes.length }],
      bufferViews: [
        { buffer: 0, byteLength },
        { buffer: 0, byteOffset: byteLength, byteLength: bytes.length - byteLength },
      ],
      accessors: [
        { bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3' },
        { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
      ],
    }
    return writeGlb(json, bytes)
  },
}

/** Returns three numbers of an array for each corner of each triangle. */
const cornersOf = (array, indices) =>
  Array.from(indices, (vertex) => Array.from(array.subarray(3 * vertex, 3 * vertex + 3)))

function assertNear(actual, expected) {
  assert.equal(actual.length, expected.length)
  actual.forEach((numbers, corner) =>
    numbers.forEach((number, k) =>
      assert.ok(Math.abs(number - expected[corner][k]) < 1e-6, `${corner}: ${numbers}`),
    ),
  )
}

const wave = compileWarp(({ glsl, position }) =>
  glsl.vec3(0, 0, position.x().mult(2).sin().mult(0.2)),
)

for (const [name, fileOf] of Object.entries(files))
  describe(name, () => {
    test('each side has its own normals, of length 1 and opposite', async () => {
      const { positions, indices } = saddle()
      const oneSided = await loadMesh(fileOf({ positions, indices }))
      const twoSided = await loadMesh(
        fileOf({ positions, indices: [...indices, ...backwards(indices)] }),
      )
      assert.equal(twoSided.positions.length, 2 * oneSided.positions.length)
      assert.deepEqual(cornersOf(twoSided.positions, twoSided.indices), [
        ...cornersOf(positions, indices),
        ...cornersOf(positions, backwards(indices)),
      ])
      const front = cornersOf(oneSided.normals, oneSided.indices)
      for (const normal of front) assert.ok(Math.abs(Math.hypot(...normal) - 1) < 1e-6, `${normal}`)
      const back = backwards(front).map((normal) => normal.map((number) => -number))
      const computed = cornersOf(twoSided.normals, twoSided.indices)
      assertNear(computed, [...front, ...back])

      // By Lambert's law, a light from above lights the front, and the back is dark.
      const lit = computed.map((normal) => Math.max(0, normal[2]))
      assert.ok(lit.slice(0, indices.length).every((light) => light > 0.3))
      assert.ok(lit.slice(indices.length).every((light) => light === 0))
    })

    test('an adjacent one-sided part continues the side that faces the same way', async () => {
      const { positions, indices } = saddle()
      const half = indices.slice(0, indices.length / 2)
      const oneSided = await loadMesh(fileOf({ positions, indices }))
      const mixed = await loadMesh(fileOf({ positions, indices: [...backwards(half), ...indices] }))
      const front = cornersOf(oneSided.normals, oneSided.indices)
      assertNear(cornersOf(mixed.normals, mixed.indices).slice(half.length), front)
    })

    test('warping and subdividing treat the sides as two surfaces', async () => {
      const { positions, indices } = saddle()
      const oneSided = await loadMesh(fileOf({ positions, indices }))
      const twoSided = await loadMesh(
        fileOf({ positions, indices: [...indices, ...backwards(indices)] }),
      )
      const front = bakeWarp(oneSided, wave)
      const bakedTwoSided = bakeWarp(twoSided, wave)
      assertNear(
        cornersOf(bakedTwoSided.normals, bakedTwoSided.indices).slice(0, indices.length),
        cornersOf(front.normals, front.indices),
      )
      for (const options of [{ levels: 2 }, { warp: wave, tolerance: 0.001, angle: Infinity }]) {
        const [fine, fineOfOne] = [twoSided, oneSided].map((mesh) => subdivide(mesh, options))
        assert.equal(fine.indices.length, 2 * fineOfOne.indices.length)
        const notUsedTwice = new Set(edgesNotUsed(2, fine))
        const cracks = edgesNotUsed(4, fine).filter((edge) => notUsedTwice.has(edge))
        assert.deepEqual(cracks, [], 'an edge belongs to neither two nor four triangles')
        for (let i = 0; i < fine.normals.length; i += 3)
          assert.ok(Math.abs(Math.hypot(...fine.normals.subarray(i, i + 3)) - 1) < 1e-6)
      }
    })
  })
