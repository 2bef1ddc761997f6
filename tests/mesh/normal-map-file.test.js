// Tests bakeNormalMap: the mesh and the image that it returns, as a glTF file, and messages about mistakes.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { BoxGeometry } from 'three'
import { compileWarp } from 'warpjet'
import { bakeNormalMap, bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import { readGlb } from '../support/glb.js'
import { checkMemoryAfterEach, material, rise } from '../support/mesh-tests.js'
import { grid, sphere } from '../support/meshes.js'
import { readNormalMap, readPng } from '../support/normal-map.js'
import { throwsWarpError } from '../support/warp-errors.js'
import { square, waves } from '../support/waved-normals.js'

checkMemoryAfterEach()

describe('the file', () => {
  const bakeToGlb = (mesh, options = { size: 16 }) => exportGLB(bakeNormalMap(mesh, waves, options))

  test('is valid, and keeps the arrays and the material', async () => {
    const mesh = { ...sphere(), material }
    const glb = bakeToGlb(mesh)
    const { issues } = await validator.validateBytes(glb)
    assert.deepEqual(issues.messages, [])
    const { json, viewBytes } = readGlb(glb)
    const [writtenMaterial] = json.materials
    const { baseColorTexture, baseColorFactor } = writtenMaterial.pbrMetallicRoughness
    assert.deepEqual(baseColorFactor, material.baseColor)
    const bytesOf = ({ index }) => viewBytes(json.images[json.textures[index].source].bufferView)
    assert.deepEqual(bytesOf(baseColorTexture), material.baseColorTexture.bytes)
    assert.deepEqual(readPng(bytesOf(writtenMaterial.normalTexture)).width, 16)
    const expected = bakeWarp(mesh, waves)
    const loaded = await loadMesh(glb)
    const corners = ({ indices, ...mesh }, name, size) =>
      [...indices].flatMap((i) => [...mesh[name].slice(size * i, size * i + size)])
    for (const [name, size] of Object.entries({ positions: 3, uvs: 2, colors: 4 }))
      assert.deepEqual(corners(loaded, name, size), corners(expected, name, size), name)
  })

  test('repeats the image only where uvs are outside of 0 to 1', () => {
    const wraps = (uvAt) => {
      const { json } = readGlb(bakeToGlb(square(uvAt)))
      return json.samplers?.[json.textures[0].sampler]
    }
    assert.deepEqual(
      wraps((x, y) => [x, y]),
      { wrapS: 33071, wrapT: 33071 },
    )
    assert.equal(
      wraps((x, y) => [x - 1, y]),
      undefined,
    )
  })

  test('has tangents along u, and bitangents against v, which increases downwards', () => {
    const zeroWarp = compileWarp(({ glsl }) => glsl.vec3(0))
    for (const mirror of [1, -1]) {
      const { tangents } = bakeNormalMap(
        square((x, y) => [mirror > 0 ? x : 1 - x, y]),
        zeroWarp,
      )
      for (let i = 0; i < tangents.length; i += 4) {
        const [x, y, z, side] = tangents.slice(i, i + 4)
        assert.ok(Math.abs(x - mirror) + Math.abs(y) + Math.abs(z) < 1e-6)
        // The cross product of normal and tangent is (0, mirror, 0), and v increases with y.
        assert.equal(side * mirror, -1)
      }
    }
  })

  test('has two vertices where uvs are mirrored', () => {
    // Two triangles that share a vertex.
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0]
    const uvs = [0.5, 0.5, 1, 0.5, 0.5, 1, 0.5, 0, 0, 0.5]
    const { tangents, indices, ...baked } = bakeNormalMap(
      { positions, uvs, indices: [0, 1, 2, 0, 3, 4] },
      waves,
      { size: 16 },
    )
    assert.equal(baked.positions.length, 3 * 6)
    assert.equal(baked.uvs.length, 2 * 6)
    assert.deepEqual(
      [...indices].map((i) => tangents[4 * i + 3]),
      [-1, -1, -1, 1, 1, 1],
    )
  })

  test('has no vertices without a triangle', () => {
    const { positions, indices } = bakeNormalMap({ ...square(), indices: [6, 7, 11] }, waves)
    assert.equal(positions.length, 3 * 3)
    assert.deepEqual([...indices], [0, 1, 2])
  })

  test('has a flat map if the warp only tilts the surface, also beside the triangles', () => {
    const tilt = compileWarp(({ glsl, position: p }) => glsl.vec3(0, 0, p.x().mult(3)))
    const { image } = readNormalMap(
      exportGLB(
        bakeNormalMap(
          square((x, y) => [0.4 + x / 5, 0.4 + y / 5]),
          tilt,
          { size: 32 },
        ),
      ),
    )
    for (let y = 0; y < 32; y++)
      for (let x = 0; x < 32; x++) assert.deepEqual(image.pixel(x, y), [128, 128, 255])
  })

  test('continues the normals beside the triangles, for bilinear filtering', () => {
    // The square covers half of the image; its border is in the middle between two texels.
    const uvAt = (x, y) => [x / 2, y]
    const map = readNormalMap(exportGLB(bakeNormalMap(square(uvAt), waves, { size: 64 })))
    const inside = map.image.pixel(31, 20)
    const beside = map.image.pixel(32, 20)
    const inner = map.image.pixel(30, 20)
    const expected = inside.map((byte, k) => 2 * byte - inner[k])
    assert.notDeepEqual(inside, beside)
    beside.forEach((byte, k) =>
      assert.ok(Math.abs(byte - expected[k]) <= 3, `${beside} ${expected}`),
    )
    // Further away, the colours of the border are repeated.
    map.image.pixel(60, 20).forEach((byte, k) => assert.ok(Math.abs(byte - beside[k]) <= 6))
  })
})

describe('mistakes', () => {
  const rejects = (mesh, pattern, { warp = waves, ...options } = {}) =>
    throwsWarpError(
      () => bakeNormalMap(mesh, warp, options),
      new RegExp(`^bakeNormalMap: ${pattern.source}`),
    )

  test('in the mesh', () => {
    rejects(undefined, /expected a mesh such as/)
    rejects(grid(3, 3), /the mesh has no uvs, .*; unwrap the model so that .* Blender\.$/)
    rejects({ positions: [], uvs: [] }, /the mesh has no triangles, but a normal map needs/)
    rejects(
      square(() => [0.5, 0.5]),
      /the uvs cover no texel of 1024 × 1024; unwrap/,
    )
    rejects(
      square((x, y) => [2 * x, y]),
      /expected uvs that do not overlap, .* got \d+% of the texels with several triangles; unwrap/,
    )
    rejects(new BoxGeometry(), /expected uvs that do not overlap, .* got 100% of/)
  })

  test('in the warp and the options', () => {
    rejects(square(), /expected a result of compileWarp for the warp, got /, { warp: 7 })
    rejects(square(), /the warp was compiled with "normals: false"/, {
      warp: compileWarp(({ position }) => position, { normals: false }),
    })
    const pole = compileWarp(({ glsl, position: p }) => glsl.vec3(0, 0, p.x().sub(0.6).log()))
    rejects(square(), /expected a finite position of vertex/, { warp: pole })
    // The square root is real at the vertices, at multiples of 1/4, but not everywhere between them.
    const gap = compileWarp(({ glsl, position: p }) =>
      glsl.vec3(
        0,
        0,
        p
          .x()
          .mult(8 * Math.PI)
          .cos()
          .sub(0.5)
          .sqrt(),
      ),
    )
    rejects(
      square(),
      /the warp has no finite position and normal between vertices, at \(.*\); check whether it divides/,
      {
        warp: gap,
        size: 64,
      },
    )
    for (const size of [0, 8193, 1.5, '16'])
      rejects(square(), /expected a whole number from 1 to 8192 for the option "size", got/, {
        size,
      })
    rejects(square(), /there is no option "sise"; did you mean size\?/, { sise: 16 })
    rejects(square(), /.*millis/, { warp: rise })
  })
})
