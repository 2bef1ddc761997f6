/** Loads models from the visitor's files or from the gallery. */
import dracoWasm from 'draco3dgltf/draco_decoder_gltf.wasm?url'
import { MeshoptDecoder } from 'meshoptimizer'
import { loadMesh } from '../../dist/mesh.js'
import { airplane } from '../models/airplane.js'
import { bunny } from '../models/bunny.js'
import { toScreen } from '../models/mesh.js'

const modelName = /\.(glb|gltf|obj|stl)$/i

const advice = 'drop a .glb, a .gltf or .obj with its files, or an .stl'

const decoders = {
  meshopt: MeshoptDecoder,
  // Fetched only when a model needs it.
  draco: async () => {
    const { default: draco } = await import('draco3dgltf')
    return draco.createDecoderModule({ locateFile: () => dracoWasm })
  },
}

/** Flips a model of the gallery, made for p5's downward y axis, to glTF's upward y. */
function flipUpright(mesh, baseColor) {
  return { ...toScreen(mesh), uvs: undefined, material: { baseColor } }
}

/** A box of twelve triangles, too coarse for any warp without subdivision. */
function makeBox() {
  const positions = []
  const normals = []
  const indices = []
  for (let side = 0; side < 6; side++) {
    const axis = side >> 1
    const sign = side & 1 ? -1 : 1
    for (const [a, b] of [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ]) {
      const [point, normal] = [
        [0, 0, 0],
        [0, 0, 0],
      ]
      point[axis] = normal[axis] = sign
      point[(axis + 1) % 3] = a * sign
      point[(axis + 2) % 3] = b
      for (const [i, stretch] of [0.5, 1.2, 0.5].entries()) positions.push(point[i] * stretch)
      normals.push(...normal)
    }
    indices.push(...[0, 1, 2, 0, 2, 3].map((corner) => 4 * side + corner))
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices: new Uint32Array(indices),
    material: { baseColor: [0.9, 0.55, 0.15, 1] },
  }
}

/** Maps a sample's name to a function that makes its mesh. */
export const samples = {
  bunny: () => flipUpright(bunny(), [0.85, 0.23, 0.1, 1]),
  airplane: () => flipUpright(airplane(), [0.09, 0.55, 0.44, 1]),
  box: makeBox,
}

/** Decodes a URI; returns it unchanged if it is a plain file name such as `100%.png`. */
function decodeName(uri) {
  try {
    return decodeURIComponent(uri)
  } catch {
    return uri
  }
}

/** Loads the model among the files, which may refer to the other files. Returns { name, mesh, picture }. */
export async function loadFiles(files) {
  const model = files.find(({ name }) => modelName.test(name))
  if (!model) {
    const names = files.map(({ name }) => `“${name}”`).join(', ')
    throw new Error(
      files.length === 1
        ? `Expected a model, got ${names}: ${advice}.`
        : `Expected a model, got only other files: ${advice}.`,
    )
  }
  const byName = new Map(files.map((file) => [file.name, file]))
  const nameOf = (uri) => uri.split('/').at(-1)
  const resolve = (uri) => byName.get(nameOf(uri)) ?? byName.get(nameOf(decodeName(uri)))
  const mesh = await loadMesh(model, { resolve, decoders })
  return { name: model.name.replace(modelName, ''), mesh, picture: await decodePicture(mesh) }
}

/** Decodes the material's texture for the GPU. A broken image becomes a warning; the mesh is still shown. */
async function decodePicture(mesh) {
  const texture = mesh.material?.baseColorTexture
  if (!texture) return
  try {
    const blob = new Blob([texture.bytes], { type: texture.mimeType })
    return await createImageBitmap(blob, { colorSpaceConversion: 'none' })
  } catch {
    const warning = 'The image of the material cannot be decoded and is left out.'
    mesh.warnings = [...(mesh.warnings ?? []), warning]
  }
}
