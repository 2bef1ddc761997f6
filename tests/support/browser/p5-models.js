// The models that tests of loadWarpModel load.
import { mkdirSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { exportGLB } from '../../../dist/mesh.js'
import { bunny } from '../../../web/models/bunny.js'
import { packedVariants } from '../models/packed-variants.js'
import { shapes } from '../models/shapes.js'
import { png } from '../png.js'

/** A triangle in glTF's conventions, with y upwards, counterclockwise front faces and linear colours. It is 2 wide and 1 high. */
export const triangle = {
  positions: [4, 0, 0, 6, 0, 0, 5, 1, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1],
  indices: [0, 1, 2],
}
export const white = [255, 255, 255]
export const red = [255, 0, 0]
/** Maps the name of a file → its content. */
const files = {
  'plain.glb': exportGLB(triangle),
  'colors.glb': exportGLB({
    ...triangle,
    colors: [0, 1, 2].flatMap(() => [0.5, 0.001, 1, 1]),
    material: { baseColor: [0.5, 1, 0, 1] },
  }),
  'material.glb': exportGLB({ ...triangle, material: { baseColor: [0, 0.2140411, 0, 1] } }),
  'picture.glb': exportGLB({
    positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
    normals: Array.from({ length: 12 }, (_, i) => (i % 3 === 2 ? 1 : 0)),
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
    material: {
      baseColor: [1, 1, 1, 1],
      baseColorTexture: {
        bytes: png(2, 2, (x, y) => (x === y ? [red, [0, 0, 255]][x] : white)),
        mimeType: 'image/png',
      },
    },
  }),
  'tip.obj': 'v 4 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\n',
  'words.glb': 'no model at all',
  'packed.glb': packedVariants['meshopt, vertices and triangles'](shapes.cube).file,
  // One face in the fill colour, one red, one white, one with a material that does not exist.
  'parts.obj': `mtllib parts.mtl
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0
f 1 2 3\nusemtl red\nf 1 3 4\nusemtl white\nf 1 2 4\nusemtl nowhere\nf 2 3 4\n`,
  'parts.mtl': 'newmtl red\nKd 0.8 0.1 0\n\nnewmtl white\nKa 0 0 0\nKd 1 1 1\nmap_Kd a.png\n',
  'painted.obj': `mtllib parts.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3
usemtl white\nv 0 0 1\nv 1 0 1\nv 1 1 1\nf 4 5 6\n`,
  'white.obj': 'mtllib parts.mtl\nusemtl white\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n',
  'text.stl': `solid a
facet normal 0.6 0 0.8\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet
facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 2\nendloop\nendfacet
endsolid a\n`,
  'binary.stl': encodeBinaryStl([
    [0.6, 0, 0.8, 0, 0, 0, 1, 0, 0, 1, 1, 0],
    [0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 2],
  ]),
}

/** Encodes a binary STL. Each facet is 12 numbers: its normal and its three corners. */
function encodeBinaryStl(facets) {
  const view = new DataView(new ArrayBuffer(84 + 50 * facets.length))
  view.setUint32(80, facets.length, true)
  facets.forEach((numbers, i) =>
    numbers.forEach((x, k) => view.setFloat32(84 + 50 * i + 4 * k, x, true)),
  )
  return new Uint8Array(view.buffer)
}

/** Encodes the bunny with the y axis pointing downwards, as in p5. */
function encodeP5Bunny() {
  const { positions, normals, uvs, indices } = bunny()
  for (const numbers of [positions, normals])
    for (let i = 1; i < numbers.length; i += 3) numbers[i] *= -1
  for (let i = 0; i < indices.length; i += 3)
    [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]]
  const material = { baseColor: [0.9, 0.3, 0.15, 1] }
  return exportGLB({ positions, normals, uvs, indices, material })
}

export const path = (name) => fileURLToPath(new URL(`../../..${name}`, import.meta.url))

/** Writes the models into `.build/<name>` → the URL path of this folder on pages of `servePages`. */
export function writeModels(name) {
  const folder = `/.build/${name}`
  mkdirSync(path(folder), { recursive: true })
  for (const [file, bytes] of Object.entries({ ...files, 'bunny.glb': encodeP5Bunny() }))
    writeFileSync(path(`${folder}/${file}`), bytes)
  return folder
}
