// Tests bakeNormalMap: the normals that a program reads from the map equal the exact normals of the warp, also between vertices.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { SphereGeometry } from 'three'
import { compileWarp } from 'warpjet'
import { bakeNormalMap, bakeWarp, exportGLB, subdivide } from 'warpjet/mesh'
import { normalize } from '../support/browser/matrix.js'
import { checkMemoryAfterEach, twist } from '../support/mesh-tests.js'
import { mikktspaceNormal, readNormalMap } from '../support/normal-map.js'
import { throwsWarpError } from '../support/warp-errors.js'
import {
  maxAngles,
  plainSphere,
  rounding,
  sphereAt,
  square,
  squareAt,
  wavedAngles,
  wavedNormal,
  waves,
} from '../support/waved-normals.js'

checkMemoryAfterEach()

describe('the map holds exact normals', () => {
  test('of a sphere', () => {
    const max = wavedAngles(plainSphere(), sphereAt, sphereAt)
    assert.ok(max.texels > 120 * 120)
    assert.ok(max.vertices > 15, `${max.vertices}`)
    assert.ok(max.map < rounding, `${max.map}`)
  })

  test('for programs that follow the definition of MikkTSpace', () => {
    const bake = (frames) =>
      readNormalMap(exportGLB(bakeNormalMap(plainSphere(), waves, { size: 128, frames })))
    const angle = (map) => maxAngles(map, sphereAt, sphereAt, wavedNormal, mikktspaceNormal).map
    assert.ok(angle(bake('mikktspace')) < rounding)
    assert.ok(angle(bake('normalized')) > 3)
  })

  const up = () => [0, 0, 1]
  const uvMaps = {
    'mirrored uvs': [(x, y) => [1 - x, y], ([u, v]) => [1 - u, v, 0]],
    'swapped uvs': [(x, y) => [0.2 + y / 2, x / 2], ([u, v]) => [2 * v, 2 * u - 0.4, 0]],
    'uvs beyond 1, which repeat the image': [
      (x, y) => [x + 2.25, y - 0.5],
      ([u, v]) => [u - 2.25, v + 0.5, 0],
    ],
  }
  for (const [name, [uvAt, restAt]] of Object.entries(uvMaps))
    test(`of a square with ${name}`, () => {
      const max = wavedAngles(square(uvAt), restAt, up)
      assert.ok(max.texels > 4000)
      assert.ok(max.vertices > 8, `${max.vertices}`)
      assert.ok(max.map < rounding, `${max.map}`)
    })

  test('of a square that the warp mirrors, with the triangles reversed', () => {
    const mirror = compileWarp(({ glsl, position: p }) =>
      glsl.vec3(p.x().mult(-2), 0, p.x().mult(7).sin().mult(0.1)),
    )
    const baked = bakeNormalMap(square(), mirror, { size: 64 })
    assert.deepEqual(
      [...baked.indices.slice(0, 3)].map((i) => [...baked.uvs.slice(2 * i, 2 * i + 2)]),
      [...bakeWarp(square(), mirror).indices.slice(0, 3)].map((i) => [
        ...square().uvs.slice(2 * i, 2 * i + 2),
      ]),
    )
    const max = maxAngles(readNormalMap(exportGLB(baked)), squareAt, up, ([x]) =>
      // The surface (-x, y, sin(7 x) / 10), whose outer side is up.
      normalize([0.7 * Math.cos(7 * x), 0, 1]),
    )
    assert.ok(max.vertices > 5, `${max.vertices}`)
    assert.ok(max.map < rounding, `${max.map}`)
  })
})

test('a geometry of three.js gets a map, of 1024 by 1024 texels by default', () => {
  const { image } = readNormalMap(exportGLB(bakeNormalMap(new SphereGeometry(1, 8, 4), waves)))
  assert.deepEqual([image.width, image.height], [1024, 1024])
})

test('the function of a uniform is called once per bake, unless the options override its value', () => {
  let calls = 0
  const warp = compileWarp(
    ({ glsl, position: p, uniforms: { slope } }) => glsl.vec3(0, 0, p.x().mult(slope)),
    { uniforms: { slope: () => ++calls } },
  )
  const slopeOf = (options) => {
    const { normals } = bakeNormalMap(square(), warp, { size: 512, ...options })
    return Math.round(-normals[0] / normals[2])
  }
  const before = calls
  assert.equal(slopeOf({}), before + 1)
  assert.equal(calls, before + 1)
  assert.equal(slopeOf({ uniforms: { slope: 3 } }), 3)
  assert.equal(calls, before + 1)
})

test('a warp may read uv, colour and normal, which are interpolated', () => {
  const warp = compileWarp(
    ({ glsl, normal, uv, color }) =>
      normal.mult(glsl.sin(uv.x().mult(9)).mult(color.x()).mult(0.1)),
    { surfaceVariation: true },
  )
  const mesh = { ...square(undefined, 9), colors: new Float32Array(4 * 81).fill(0.5) }
  const map = readNormalMap(exportGLB(bakeNormalMap(mesh, warp, { size: 64 })))
  const max = maxAngles(
    map,
    squareAt,
    () => [0, 0, 1],
    // The surface (x, y, sin(9 x) / 20).
    ([x]) => normalize([-0.45 * Math.cos(9 * x), 0, 1]),
  )
  assert.ok(max.vertices > 2, `${max.vertices}`)
  assert.ok(max.map < rounding, `${max.map}`)
})

test('bakeWarp and subdivide keep a normal map', () => {
  const baked = bakeNormalMap(square(), waves, { size: 16 })
  for (const mesh of [bakeWarp(baked, twist), subdivide(baked, { levels: 1 })])
    assert.deepEqual(mesh.material.normalTexture, baked.material.normalTexture)
  throwsWarpError(
    () => exportGLB({ ...square(), material: { normalTexture: { bytes: Uint8Array.of(1) } } }),
    /^exportGLB: material.normalTexture must be the bytes of a PNG or JPEG file/,
  )
  throwsWarpError(
    () => exportGLB({ ...square(), material: { normalTexture: 7 } }),
    /^exportGLB: expected \{ bytes, mimeType \} .* for material.normalTexture, got the number 7/,
  )
})

test('a normal that points to the back of its triangle is stored as the nearest normal that a map can hold', () => {
  // Two triangles that an overhanging wave bends between their vertices.
  const wave = compileWarp(({ glsl, position: p }) =>
    glsl.vec3(
      p
        .x()
        .mult(2 * Math.PI)
        .sin()
        .mult(0.5),
      0,
      p.x().mult(Math.PI).sin(),
    ),
  )
  const map = exportGLB(bakeNormalMap(square(undefined, 2), wave, { size: 32 }))
  const { image } = readNormalMap(map)
  const blues = Array.from({ length: 32 }, (_, x) => image.pixel(x, 16)[2])
  assert.equal(Math.min(...blues), 128)
})

test('the map is flat where the warp collapses the surface', () => {
  const collapse = compileWarp(({ position }) => position.mult(-1))
  const { image } = readNormalMap(exportGLB(bakeNormalMap(plainSphere(), collapse, { size: 8 })))
  assert.deepEqual(image.pixel(4, 4), [128, 128, 255])
})

test('triangles without area get arbitrary tangents, and the file stays valid', async () => {
  const flat = square()
  const meshes = {
    'two equal corners': { ...flat, indices: [...flat.indices, 0, 0, 1, 24, 24, 24] },
    'all in a point': { ...flat, positions: flat.positions.map(() => 2) },
    'all in a line': { ...flat, positions: flat.positions.map((x, i) => (i % 3 === 1 ? 0 : x)) },
    'all in a line, no two in a point': {
      ...flat,
      positions: flat.positions.map((_, i) => (i % 3 ? 0 : i)),
    },
  }
  const zeroWarp = compileWarp(({ glsl }) => glsl.vec3(0))
  for (const [name, mesh] of Object.entries(meshes)) {
    const glb = exportGLB(bakeNormalMap(mesh, zeroWarp, { size: 32 }))
    const { issues } = await validator.validateBytes(glb)
    assert.deepEqual(
      issues.messages.filter(({ severity }) => severity < 2),
      [],
      name,
    )
  }
})

test('a small overlap is a warning', () => {
  const { indices, ...mesh } = plainSphere(40, 30)
  const doubled = { ...mesh, indices: [...indices, ...indices.slice(600, 603)] }
  const { warnings } = bakeNormalMap(doubled, waves, { size: 128 })
  assert.match(warnings[0], /^The uvs overlap at 0\.\d+% of the texels, which have the normal of/)
  assert.equal(bakeNormalMap(plainSphere(), waves, { size: 128 }).warnings, undefined)
})
