// Tests exportGLB: reads its output back according to the specification, and validates it with Khronos' validator.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import validator from 'gltf-validator'
import { version } from 'warpjet'
import { exportGLB } from 'warpjet/mesh'
import { readGlb, writeGlb } from '../support/glb.js'
import { grid, sphere, triangle } from '../support/meshes.js'
import { png } from '../support/png.js'

const checker = png(4, 4, (x, y) => ((x + y) % 2 ? [255, 128, 0] : [0, 0, 255]))

/** The smallest grey JPEG of 8 by 8 pixels, in the order of its segments. */
const jpeg = Uint8Array.from(
  Buffer.from(
    'ffd8ffe000104a46494600010100000100010000ffdb004300' +
      '01'.repeat(64) +
      'ffc0000b080008000801011100ffc40014000100000000000000000000000000000000ffc40014100100000000000000000000000000000000ffda0008010100003f003fffd9',
    'hex',
  ),
)

/** Exports a mesh, and throws on any error or warning of the validator. */
async function exportValidGlb(mesh) {
  const bytes = exportGLB(mesh)
  const { issues } = await validator.validateBytes(bytes)
  const errorsAndWarnings = issues.messages.filter(({ severity }) => severity < 2)
  assert.deepEqual(errorsAndWarnings, [])
  return { ...readGlb(bytes), bytes, codes: issues.messages.map(({ code }) => code) }
}

const primitiveOf = ({ json }) => json.meshes[0].primitives[0]
const attribute = (glb, name) => glb.accessor(primitiveOf(glb).attributes[name])

test('the validator of this test finds errors', async () => {
  const bytes = exportGLB(triangle())
  const { json, chunks } = readGlb(bytes)
  json.accessors[0].max[0] = 7
  const { issues } = await validator.validateBytes(writeGlb(json, chunks[1].bytes))
  assert.equal(issues.numErrors, 1)
})

test('every array is identical after export', async () => {
  const mesh = { ...sphere(), material: { baseColor: [1, 0.5, 0.25, 1] } }
  const glb = await exportValidGlb(mesh)
  const names = {
    POSITION: 'positions',
    NORMAL: 'normals',
    TEXCOORD_0: 'uvs',
    COLOR_0: 'colors',
    TANGENT: 'tangents',
  }
  for (const [name, array] of Object.entries(names))
    assert.deepEqual(attribute(glb, name), mesh[array], name)
  assert.deepEqual([...glb.accessor(primitiveOf(glb).indices)], [...mesh.indices])
  assert.deepEqual(Object.keys(primitiveOf(glb).attributes).sort(), Object.keys(names).sort())
})

test('accessors have the min and max of their numbers, and views have a target', async () => {
  const mesh = sphere()
  const glb = await exportValidGlb(mesh)
  const { POSITION } = primitiveOf(glb).attributes
  for (let i = 0; i < 3; i++) {
    const coordinates = mesh.positions.filter((_, k) => k % 3 === i)
    assert.equal(glb.json.accessors[POSITION].min[i], Math.min(...coordinates))
    assert.equal(glb.json.accessors[POSITION].max[i], Math.max(...coordinates))
  }
  assert.ok(glb.json.accessors.every(({ min, max }) => min && max))
  const { indices, attributes } = primitiveOf(glb)
  const targetOf = (accessor) =>
    glb.json.bufferViews[glb.json.accessors[accessor].bufferView].target
  assert.equal(targetOf(indices), 34963)
  for (const accessor of Object.values(attributes)) assert.equal(targetOf(accessor), 34962)
})

test('the file names its generator', async () => {
  const { json } = await exportValidGlb(triangle())
  assert.deepEqual(json.asset, { version: '2.0', generator: `warpjet ${version}` })
})

test('indices have 16 bits unless one is 65535, which restarts primitives', async () => {
  const largestNarrow = grid(65535 / 5, 5)
  const narrow = await exportValidGlb(largestNarrow)
  assert.equal(narrow.json.accessors[primitiveOf(narrow).indices].componentType, 5123)
  assert.equal(Math.max(...narrow.json.accessors[primitiveOf(narrow).indices].max), 65534)
  assert.deepEqual([...narrow.accessor(primitiveOf(narrow).indices)], [...largestNarrow.indices])

  const wide = await exportValidGlb(grid(256, 256))
  assert.equal(wide.json.accessors[primitiveOf(wide).indices].componentType, 5125)
  assert.equal(wide.json.accessors[primitiveOf(wide).indices].max[0], 65535)
})

test('a mesh without indices is exported without indices', async () => {
  const glb = await exportValidGlb(triangle())
  assert.equal(primitiveOf(glb).indices, undefined)
  assert.deepEqual(attribute(glb, 'POSITION'), triangle().positions)
})

test('a mesh without normals is exported without normals and tangents', async () => {
  const { positions, indices, tangents } = sphere()
  const glb = await exportValidGlb({ positions, indices, tangents })
  assert.deepEqual(Object.keys(primitiveOf(glb).attributes), ['POSITION'])
})

test('a zero normal is replaced by that of the surrounding triangles; other lengths become 1', async () => {
  const mesh = grid(3, 3)
  mesh.normals.set([0, 0, 0], 3 * 4)
  mesh.normals.set([0, 0, 8], 0)
  mesh.normals.set([0, 1e-30, 0], 3)
  mesh.normals.set([3e38, 3e38, 0], 6)
  const normals = attribute(await exportValidGlb(mesh), 'NORMAL')
  const assertNormal = (vertex, expected) =>
    expected.forEach((x, i) => assert.ok(Math.abs(normals[3 * vertex + i] - x) < 1e-6))
  assertNormal(4, [0, 0, 1])
  assertNormal(0, [0, 0, 1])
  assertNormal(1, [0, 1, 0])
  assertNormal(2, [Math.SQRT1_2, Math.SQRT1_2, 0])
  assert.equal(mesh.normals[2], 8, 'the input was changed')
})

test('a surface that is collapsed to a point is exported as a valid file', async () => {
  const mesh = sphere()
  mesh.positions.fill(2)
  mesh.normals.fill(0)
  mesh.tangents.fill(0)
  const glb = await exportValidGlb(mesh)
  assert.deepEqual(new Set(attribute(glb, 'NORMAL')), new Set([0, 1]))
})

test('tangents are normalized, stay perpendicular where they are computed, and have the sign 1 or -1', async () => {
  const mesh = sphere()
  mesh.tangents.set([0, 0, 0, 0.5], 4 * 20)
  mesh.tangents.set([0, 5, 0, -3], 4 * 21)
  const tangents = attribute(await exportValidGlb(mesh), 'TANGENT')
  const computed = tangents.slice(80, 84)
  const normal = mesh.normals.slice(60, 63)
  assert.ok(
    Math.abs(computed[0] * normal[0] + computed[1] * normal[1] + computed[2] * normal[2]) < 1e-6,
  )
  assert.equal(computed[3], 1)
  assert.deepEqual([...tangents.slice(84, 88)], [0, 1, 0, -1])
  assert.deepEqual(tangents.slice(88), mesh.tangents.slice(88))
})

test('colors are clamped to 0 to 1', async () => {
  const mesh = { ...triangle(), colors: [-1, 0.5, 2, 1, 0, 0, 0, 0, 1, 1, 1, 1] }
  mesh.material = { baseColor: [2, -1, 0.5, 0.25] }
  const glb = await exportValidGlb(mesh)
  assert.deepEqual([...attribute(glb, 'COLOR_0')].slice(0, 4), [0, 0.5, 1, 1])
  const [{ pbrMetallicRoughness, alphaMode }] = glb.json.materials
  assert.deepEqual(pbrMetallicRoughness.baseColorFactor, [1, 0, 0.5, 0.25])
  assert.equal(pbrMetallicRoughness.metallicFactor, 0)
  assert.equal(alphaMode, 'BLEND')
})

for (const [mimeType, bytes] of Object.entries({ 'image/png': checker, 'image/jpeg': jpeg }))
  test(`a texture is embedded in the file: ${mimeType}`, async () => {
    // Three 16-bit indices, so that padding precedes the texture.
    const mesh = { ...triangle(), uvs: [0, 0, 1, 0, 0, 1], indices: [0, 1, 2] }
    mesh.material = { baseColor: [1, 1, 1, 1], baseColorTexture: { bytes, mimeType: 'whatever' } }
    const glb = await exportValidGlb(mesh)
    const [image] = glb.json.images
    assert.equal(image.mimeType, mimeType)
    assert.deepEqual(glb.viewBytes(image.bufferView), bytes)
    assert.equal(glb.json.bufferViews[image.bufferView].target, undefined)
    const { index } = glb.json.materials[0].pbrMetallicRoughness.baseColorTexture
    assert.equal(glb.json.textures[index].source, 0)
  })

test('a texture without uvs is omitted', async () => {
  const material = { baseColor: [1, 1, 1, 1], baseColorTexture: { bytes: checker } }
  const { json } = await exportValidGlb({ ...triangle(), material })
  assert.equal(json.images, undefined)
})

test('degenerate triangles and unused vertices are valid', async () => {
  await exportValidGlb({ ...grid(2, 2), indices: [0, 0, 1, 2, 2, 2] })
  await exportValidGlb({ ...grid(3, 3), indices: [0, 1, 2] })
})
