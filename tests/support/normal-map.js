// Computes normals at the centres of texels from the normal map of a GLB file, like a program that draws it. Does not use the library.
import { inflateSync } from 'node:zlib'
import { cross, normalize } from './browser/matrix.js'
import { readGlb } from './glb.js'

/**
 * Decodes a PNG with red, green and blue of 8 bits each, whose rows have no filter. `pixel(x, y)` repeats the image beyond its borders.
 */
export function readPng(png) {
  const bytes = Buffer.from(png)
  const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)]
  if (bytes[24] !== 8 || bytes[25] !== 2)
    throw new Error('expected 8 bits each of red, green and blue')
  const compressed = []
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT')
      compressed.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)))
  const rows = inflateSync(Buffer.concat(compressed))
  const modulo = (x, size) => ((x % size) + size) % size
  const pixel = (x, y) => {
    const row = modulo(y, height) * (1 + 3 * width)
    if (rows[row] !== 0) throw new Error('expected rows without a filter')
    const first = row + 1 + 3 * modulo(x, width)
    return [...rows.subarray(first, first + 3)]
  }
  return { width, height, pixel }
}

/** Reads a GLB file with a normal map → the arrays of its attributes, its indices, and the image of the map. */
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

/** Calls `visit` for each texel whose centre is in a triangle, with the indices of the three vertices and the barycentric coordinates. */
export function visitTexels({ TEXCOORD_0: uvs, indices, image: { width, height } }, visit) {
  for (let i = 0; i < indices.length; i += 3) {
    const vertices = [...indices.slice(i, i + 3)]
    const [a, b, c] = vertices.map((k) => [uvs[2 * k] * width - 0.5, uvs[2 * k + 1] * height - 0.5])
    const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    const doubleArea = area(a, b, c)
    if (doubleArea === 0) continue
    const range = (axis) => [
      Math.ceil(Math.min(a[axis], b[axis], c[axis])),
      Math.floor(Math.max(a[axis], b[axis], c[axis])),
    ]
    const [left, right] = range(0)
    const [top, bottom] = range(1)
    for (let y = top; y <= bottom; y++)
      for (let x = left; x <= right; x++) {
        const weights = [area(b, c, [x, y]), area(c, a, [x, y]), area(a, b, [x, y])].map(
          (x) => x / doubleArea,
        )
        if (Math.min(...weights) >= 0) visit({ x, y, vertices, weights })
      }
  }
}

/** Interpolates vectors of three numbers between vertices; `stride` is the number of floats from one vector to the next. */
export const blend = (vectors, vertices, weights, stride = 3) =>
  [0, 1, 2].map((c) =>
    vertices.reduce((sum, vertex, k) => sum + weights[k] * vectors[stride * vertex + c], 0),
  )

/** Returns the normal at a texel as three.js computes it: interpolates tangent, bitangent and normal, then normalizes them. */
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
  return decodeNormal(axes.map(normalize), map.image.pixel(x, y))
}

/** Returns the normal at a texel as MikkTSpace defines it: normalizes nothing but the result. */
export function mikktspaceNormal(map, { x, y, vertices, weights }) {
  const normal = blend(map.NORMAL, vertices, weights)
  const tangent = blend(map.TANGENT, vertices, weights, 4)
  const side = map.TANGENT[4 * vertices[0] + 3]
  const bitangent = cross(normal, tangent).map((c) => side * c)
  return decodeNormal([tangent, bitangent, normal], map.image.pixel(x, y))
}

/** Returns the normal whose components along three axes a color encodes. */
function decodeNormal(axes, color) {
  const components = color.map((byte) => byte / 127.5 - 1)
  return normalize(
    [0, 1, 2].map((c) => axes.reduce((sum, axis, k) => sum + components[k] * axis[c], 0)),
  )
}
