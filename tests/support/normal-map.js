// Reads the normal map of a GLB file like a program that draws it, at the centres of its texels. Without any of the library.
import { inflateSync } from 'node:zlib'
import { cross, normalize } from './browser/matrix.js'
import { readGlb } from './glb.js'

/** Decodes a PNG of 8 bits per channel, red, green and blue, whose rows have no filter. Beyond its borders the image is repeated. */
export function readPng(png) {
  const bytes = Buffer.from(png)
  const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)]
  if (bytes[24] !== 8 || bytes[25] !== 2) throw new Error('not 8 bits of red, green and blue')
  const data = []
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT')
      data.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)))
  const rows = inflateSync(Buffer.concat(data))
  const modulo = (x, size) => ((x % size) + size) % size
  const pixel = (x, y) => {
    const row = modulo(y, height) * (1 + 3 * width)
    if (rows[row] !== 0) throw new Error('a row with a filter')
    const first = row + 1 + 3 * modulo(x, width)
    return [...rows.subarray(first, first + 3)]
  }
  return { width, height, pixel }
}

/** Opens a GLB file with a normal map: its arrays, and the pixels of the map. */
export function readNormalMap(glb) {
  const { json, accessor, viewBytes } = readGlb(glb)
  const [{ attributes, indices }] = json.meshes[0].primitives
  const [material] = json.materials
  const image = json.images[json.textures[material.normalTexture.index].source]
  return {
    ...Object.fromEntries(Object.entries(attributes).map(([name, i]) => [name, accessor(i)])),
    indices: accessor(indices),
    image: readPng(viewBytes(image.bufferView)),
  }
}

/** Calls `visit` for each texel whose centre is in a triangle, with its three vertices and barycentric coordinates. */
export function visitTexels({ TEXCOORD_0: uvs, indices, image: { width, height } }, visit) {
  for (let i = 0; i < indices.length; i += 3) {
    const vertices = [...indices.slice(i, i + 3)]
    const [a, b, c] = vertices.map((k) => [uvs[2 * k] * width - 0.5, uvs[2 * k + 1] * height - 0.5])
    const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    const whole = area(a, b, c)
    if (whole === 0) continue
    const range = (axis) => [
      Math.ceil(Math.min(a[axis], b[axis], c[axis])),
      Math.floor(Math.max(a[axis], b[axis], c[axis])),
    ]
    const [left, right] = range(0)
    const [top, bottom] = range(1)
    for (let y = top; y <= bottom; y++)
      for (let x = left; x <= right; x++) {
        const weights = [area(b, c, [x, y]), area(c, a, [x, y]), area(a, b, [x, y])].map(
          (part) => part / whole,
        )
        if (Math.min(...weights) >= 0) visit({ x, y, vertices, weights })
      }
  }
}

/** Interpolates an array of vectors. */
export const blend = (vectors, vertices, weights, stride = 3) =>
  [0, 1, 2].map((c) =>
    vertices.reduce((sum, vertex, k) => sum + weights[k] * vectors[stride * vertex + c], 0),
  )

/** Returns the normal at a texel as three.js computes it: tangent, bitangent and normal are interpolated, then normalized. */
export function shownNormal(map, { x, y, vertices, weights }) {
  const { NORMAL, TANGENT } = map
  const bitangents = vertices.flatMap((i) => {
    const [normal, tangent] = [NORMAL.slice(3 * i, 3 * i + 3), TANGENT.slice(4 * i, 4 * i + 3)]
    return normalize(cross(normal, tangent).map((c) => c * TANGENT[4 * i + 3]))
  })
  const axes = [
    blend(TANGENT, vertices, weights, 4),
    blend(bitangents, [0, 1, 2], weights),
    blend(NORMAL, vertices, weights),
  ]
  return normalIn(axes.map(normalize), map.image.pixel(x, y))
}

/** Returns the normal at a texel by the definition of MikkTSpace: nothing is normalized but the result. */
export function mikktspaceNormal(map, { x, y, vertices, weights }) {
  const normal = blend(map.NORMAL, vertices, weights)
  const tangent = blend(map.TANGENT, vertices, weights, 4)
  const side = map.TANGENT[4 * vertices[0] + 3]
  const bitangent = cross(normal, tangent).map((c) => side * c)
  return normalIn([tangent, bitangent, normal], map.image.pixel(x, y))
}

function normalIn(axes, color) {
  const parts = color.map((byte) => byte / 127.5 - 1)
  return normalize([0, 1, 2].map((c) => axes.reduce((sum, axis, k) => sum + parts[k] * axis[c], 0)))
}
