// bakeNormalMap: what a program reads from the map is the exact normal of the warp between the vertices.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { BoxGeometry, SphereGeometry } from 'three'
import { compileWarp } from 'warpjet'
import { bakeNormalMap, bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { cross, normalize } from '../support/browser/matrix.js'
import { angleBetween } from '../support/browser/oracle.js'
import { readGlb } from '../support/glb.js'
import { checkMemoryAfterEach, material, rise, twist } from '../support/mesh-tests.js'
import { grid, sphere } from '../support/meshes.js'
import {
  blend,
  mikktspaceNormal,
  readNormalMap,
  readPng,
  shownNormal,
  visitTexels,
} from '../support/normal-map.js'
import { throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

const waves = compileWarp(({ glsl, position: p }) =>
  glsl.vec3(p.y().mult(7).sin(), p.z().mult(7).sin(), p.x().mult(7).sin()).mult(0.1),
)

/** Returns the normal of `waves` by the cofactors of its Jacobian, in double precision. */
function wavedNormal([x, y, z], normal) {
  const slope = (number) => 0.7 * Math.cos(7 * number)
  const columns = [
    [1, 0, slope(x)],
    [slope(y), 1, 0],
    [0, slope(z), 1],
  ]
  const cofactors = [0, 1, 2].map((i) => cross(columns[(i + 1) % 3], columns[(i + 2) % 3]))
  return normalize([0, 1, 2].map((c) => cofactors.reduce((sum, k, i) => sum + k[c] * normal[i], 0)))
}

/** The rounding to 8 bits: half a step for each channel, sqrt(3) / 255, in degrees, and 2% for float32 and the scale of the colour. */
const rounding = 1.02 * (Math.sqrt(3) / 255) * (180 / Math.PI)

const plainSphere = (columns = 24, rows = 16) => {
  const { positions, normals, uvs, indices } = sphere(columns, rows)
  return { positions, normals, uvs, indices }
}

/** A square from 0 to 1 with columns of triangles, and its uvs by `uvAt(x, y)`. */
function square(uvAt = (x, y) => [x, y], columns = 5) {
  const { positions, ...mesh } = grid(columns, columns)
  const scaled = positions.map((x) => x / (columns - 1))
  const uvs = []
  for (let i = 0; i < scaled.length; i += 3) uvs.push(...uvAt(scaled[i], scaled[i + 1]))
  return { ...mesh, positions: scaled, uvs: Float32Array.from(uvs) }
}

/** Returns the position on the sphere at a vertex, by its uv. */
const sphereAt = ([u, v]) => {
  const [a, b] = [2 * Math.PI * u, Math.PI * v]
  return [Math.sin(b) * Math.cos(a), Math.cos(b), Math.sin(b) * Math.sin(a)]
}
const squareAt = ([x, y]) => [x, y, 0]

/** Returns the max angles of the map and of interpolated vertex normals from `exact(position, normal)`, in degrees. */
function maxAngles(map, restAt, normalAt, exact, read = shownNormal) {
  const { NORMAL, TEXCOORD_0: uvs } = map
  const vertices = Array.from({ length: uvs.length / 2 }, (_, i) => [
    ...uvs.slice(2 * i, 2 * i + 2),
  ])
  const rest = vertices.flatMap(restAt)
  const normals = vertices.flatMap(normalAt)
  const max = { map: 0, vertices: 0, texels: 0 }
  visitTexels(map, (texel) => {
    const { vertices, weights } = texel
    const expected = exact(
      blend(rest, vertices, weights),
      normalize(blend(normals, vertices, weights)),
    )
    const interpolated = normalize(blend(NORMAL, vertices, weights))
    max.texels++
    max.map = Math.max(max.map, angleBetween(read(map, texel), expected))
    max.vertices = Math.max(max.vertices, angleBetween(interpolated, expected))
  })
  return max
}

function wavedAngles(mesh, restAt, normalAt) {
  const map = readNormalMap(exportGLB(bakeNormalMap(mesh, waves, { size: 128 })))
  return maxAngles(map, restAt, normalAt, wavedNormal)
}

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
    'turned uvs': [(x, y) => [0.2 + y / 2, x / 2], ([u, v]) => [2 * v, 2 * u - 0.4, 0]],
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

describe('the file', () => {
  const baked = (mesh, options = { size: 16 }) => exportGLB(bakeNormalMap(mesh, waves, options))

  test('is valid, and keeps the arrays and the material', async () => {
    const mesh = { ...sphere(), material }
    const glb = baked(mesh)
    const { issues } = await validator.validateBytes(glb)
    assert.deepEqual(issues.messages, [])
    const { json, viewBytes } = readGlb(glb)
    const [written] = json.materials
    const { baseColorTexture, baseColorFactor } = written.pbrMetallicRoughness
    assert.deepEqual(baseColorFactor, material.baseColor)
    const bytesOf = ({ index }) => viewBytes(json.images[json.textures[index].source].bufferView)
    assert.deepEqual(bytesOf(baseColorTexture), material.baseColorTexture.bytes)
    assert.deepEqual(readPng(bytesOf(written.normalTexture)).width, 16)
    const expected = bakeWarp(mesh, waves)
    const loaded = await loadMesh(glb)
    const corners = ({ indices, ...mesh }, name, size) =>
      [...indices].flatMap((i) => [...mesh[name].slice(size * i, size * i + size)])
    for (const [name, size] of Object.entries({ positions: 3, uvs: 2, colors: 4 }))
      assert.deepEqual(corners(loaded, name, size), corners(expected, name, size), name)
  })

  test('repeats the image only where uvs are outside of 0 to 1', () => {
    const wraps = (uvAt) => {
      const { json } = readGlb(baked(square(uvAt)))
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
    const still = compileWarp(({ glsl }) => glsl.vec3(0))
    for (const mirror of [1, -1]) {
      const { tangents } = bakeNormalMap(
        square((x, y) => [mirror > 0 ? x : 1 - x, y]),
        still,
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

  test('has the normals of a neighbour between the parts, and a flat map where nothing is bent', () => {
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
    // Half of the image, whose border is in the middle between two texels.
    const uvAt = (x, y) => [x / 2, y]
    const map = readNormalMap(exportGLB(bakeNormalMap(square(uvAt), waves, { size: 64 })))
    const inside = map.image.pixel(31, 20)
    const beside = map.image.pixel(32, 20)
    const further = map.image.pixel(30, 20)
    const expected = inside.map((byte, k) => 2 * byte - further[k])
    assert.notDeepEqual(inside, beside)
    beside.forEach((byte, k) =>
      assert.ok(Math.abs(byte - expected[k]) <= 3, `${beside} ${expected}`),
    )
    // Beyond, the colours of the border are repeated.
    map.image.pixel(60, 20).forEach((byte, k) => assert.ok(Math.abs(byte - beside[k]) <= 6))
  })
})

test('a geometry of three.js, and the default size', () => {
  const { image } = readNormalMap(exportGLB(bakeNormalMap(new SphereGeometry(1, 8, 4), waves)))
  assert.deepEqual([image.width, image.height], [1024, 1024])
})

test('the values of uniforms are those of one moment, which the options override', () => {
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

test('a warp that depends on uv, colour and normal, each interpolated', () => {
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

test('a normal that points to the other side is stored as the nearest that can be', () => {
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

test('where the warp collapses the surface, the map is flat', () => {
  const collapse = compileWarp(({ position }) => position.mult(-1))
  const { image } = readNormalMap(exportGLB(bakeNormalMap(plainSphere(), collapse, { size: 8 })))
  assert.deepEqual(image.pixel(4, 4), [128, 128, 255])
})

test('triangles without area get any tangents, and the file stays valid', async () => {
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
  const still = compileWarp(({ glsl }) => glsl.vec3(0))
  for (const [name, mesh] of Object.entries(meshes)) {
    const glb = exportGLB(bakeNormalMap(mesh, still, { size: 32 }))
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
    // The root is real at the vertices, at multiples of 1/4, and not between them.
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
      /the warp has no finite position and normal between vertices, at \(.*\); check it/,
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
