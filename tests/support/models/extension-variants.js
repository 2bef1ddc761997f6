// glTF files that use extensions or morph targets, each with the triangles that it must have.
import { makePlain, sparse, writeAs } from './gltf-variants.js'
import { reverseTriangles, trianglesOf } from './shapes.js'

const morphOffsets = (shape) => shape.positions.map((_, i) => (i % 3 === 1 ? (i % 2) + 0.5 : 0))

/**
 * Makes a file with a morph target, which `addTarget` adds. `weights.mesh` are the weights of the mesh, and `weights.node` those of the
 * node.
 */
const makeMorphed = (weights, addTarget) => (shape) => {
  const offsets = morphOffsets(shape)
  const writer = makePlain(shape, {
    mesh: { weights: weights.mesh },
    node: () => (weights.node ? { weights: weights.node } : {}),
    more: (writer) => ({ targets: [{ POSITION: addTarget(writer, offsets) }] }),
  })
  const [weight] = weights.node ?? weights.mesh
  const triangles = trianglesOf(shape, (corner, i) =>
    corner.map((x, k) => x + weight * offsets[3 * i + k]),
  )
  return { ...writer.glb(), triangles }
}

const addDense = (writer, offsets) => writer.accessor(offsets, 'VEC3')
const addSparse = (writer, offsets) => {
  const index = sparse(writer, offsets, 'VEC3', 3, true)
  const { bufferView: _, ...accessor } = writer.json.accessors[index]
  // Without a view, the first element is zero.
  offsets.fill(0, 0, 3)
  return writer.json.accessors.push({ ...accessor, min: [0, 0, 0], max: [0, 1.5, 0] }) - 1
}

const translations = [
  [3, 0, 0],
  [0, 5, 0],
  [0, 0, 7],
]
const scales = [
  [1, 1, 1],
  [2, 1, 0.5],
  [-1, 1, 1],
]
/** Quaternions: no rotation, a quarter turn around z, and a half turn around x. */
const quaternions = [
  [0, 0, 0, 1],
  [0, 0, Math.SQRT1_2, Math.SQRT1_2],
  [1, 0, 0, 0],
]
/** Functions that compute the same rotations. */
const rotations = [([x, y, z]) => [x, y, z], ([x, y, z]) => [-y, x, z], ([x, y, z]) => [x, -y, -z]]

/**
 * Makes a file with instances that have these attributes. `toArray` makes the typed array of the quaternions, and `more` are further
 * members of their accessor.
 */
const makeInstances =
  (names, toArray = (numbers) => Float32Array.from(numbers), more) =>
  (shape) => {
    const writer = makePlain(shape, {
      node: (writer) => {
        writer.extension('EXT_mesh_gpu_instancing')
        const attributes = {
          TRANSLATION: () => writer.accessor(Float32Array.from(translations.flat()), 'VEC3'),
          ROTATION: () => writer.accessor(toArray(quaternions.flat()), 'VEC4', more),
          SCALE: () => writer.accessor(Float32Array.from(scales.flat()), 'VEC3'),
        }
        const used = Object.fromEntries(names.map((name) => [name, attributes[name]()]))
        return {
          translation: [0, 0, 100],
          extensions: { EXT_mesh_gpu_instancing: { attributes: used } },
        }
      },
    })
    const triangles = translations.flatMap((translation, i) => {
      const [isScaled, isRotated] = ['SCALE', 'ROTATION'].map((name) => names.includes(name))
      const moved = trianglesOf(shape, (corner) => {
        const scaled = isScaled ? corner.map((x, k) => x * scales[i][k]) : corner
        const rotated = isRotated ? rotations[i](scaled) : scaled
        return rotated.map((x, k) => x + translation[k] + (k === 2 ? 100 : 0))
      })
      return isScaled && scales[i][0] < 0 ? reverseTriangles(moved) : moved
    })
    return { ...writer.glb(), triangles, tolerance: more ? 0.02 : 1e-5 }
  }

const hidden = { extensions: { KHR_node_visibility: { visible: false } } }

const addTexture = (extension, texture) => (writer) => {
  writer.extension(extension)
  writer.add('images', { bufferView: writer.view(new Uint8Array(8)), mimeType: 'image/webp' })
  writer.add('textures', texture)
  writer.add('materials', { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } })
  writer.json.meshes[0].primitives[0].material = 0
}

const requireExtension = (extension) =>
  writeAs((shape) =>
    makePlain(shape, {}, addTexture(extension, { extensions: { [extension]: { source: 0 } } })),
  )

const withGlossiness = writeAs((shape) =>
  makePlain(shape, {}, (writer) => {
    const name = 'KHR_materials_pbrSpecularGlossiness'
    writer.extension(name)
    writer.add('materials', { extensions: { [name]: { diffuseFactor: [1, 0.5, 0.25, 1] } } })
    writer.json.meshes[0].primitives[0].material = 0
  }),
)

/**
 * Stores positions as integers: `unit` represents the largest coordinate. A `shift` of 1 first adds the largest coordinate to all numbers,
 * so that the integers can be unsigned.
 */
function quantize(Type, { unit, normalized = false, shift = 0 }) {
  return (shape) => {
    const range = Math.max(...shape.positions.map(Math.abs))
    const numbers = Type.from(shape.positions, (x) =>
      Math.round(((x / range + shift) / (1 + shift)) * unit),
    )
    const step = (range * (1 + shift)) / (normalized ? 1 : unit)
    const writer = makePlain(shape, {
      own: (writer) => {
        writer.extension('KHR_mesh_quantization')
        const padded = new Type((numbers.length / 3) * 4)
        numbers.forEach((x, i) => (padded[Math.floor(i / 3) * 4 + (i % 3)] = x))
        const byteStride = 4 * Type.BYTES_PER_ELEMENT
        const POSITION = writer.accessor(numbers, 'VEC3', { normalized })
        const alongAxis = (k) => [...numbers].filter((_, i) => i % 3 === k)
        const byAxis = (pick) => [0, 1, 2].map((k) => pick(...alongAxis(k)))
        Object.assign(writer.json.accessors[POSITION], {
          bufferView: writer.view(padded, { byteStride }),
          min: byAxis(Math.min),
          max: byAxis(Math.max),
        })
        const normals = new Int8Array((shape.normals.length / 3) * 4)
        shape.normals.forEach(
          (x, i) => (normals[Math.floor(i / 3) * 4 + (i % 3)] = Math.round(x * 127)),
        )
        const NORMAL = writer.add('accessors', {
          bufferView: writer.view(normals, { byteStride: 4 }),
          componentType: 5120,
          normalized: true,
          count: normals.length / 4,
          type: 'VEC3',
        })
        return { POSITION, NORMAL }
      },
      node: () => ({
        scale: [step, step, step],
        translation: [-shift * range, -shift * range, -shift * range],
      }),
    })
    return { ...writer.glb(), triangles: trianglesOf(shape), tolerance: (2 * range) / unit }
  }
}

export const extensionVariants = {
  'morph weights of the mesh': makeMorphed({ mesh: [0.5] }, addDense),
  'morph weights of the node': makeMorphed({ mesh: [0.5], node: [-2] }, addDense),
  'a morph target of positions that are zeros': makeMorphed({ mesh: [1.25] }, addSparse),
  'morph weights of 0': makeMorphed({ mesh: [0] }, addDense),
  'instances with translations': makeInstances(['TRANSLATION']),
  'instances with translations, rotations and scales': makeInstances([
    'TRANSLATION',
    'ROTATION',
    'SCALE',
  ]),
  'instances with rotations as shorts': makeInstances(
    ['TRANSLATION', 'ROTATION'],
    (numbers) => Int16Array.from(numbers, (x) => Math.round(x * 32767)),
    { normalized: true },
  ),
  'instances with rotations as bytes': makeInstances(
    ['TRANSLATION', 'ROTATION', 'SCALE'],
    (numbers) => Int8Array.from(numbers, (x) => Math.round(x * 127)),
    { normalized: true },
  ),
  'a hidden node': writeAs((shape) =>
    makePlain(shape, {}, (writer) => {
      writer.extension('KHR_node_visibility')
      writer.node({ mesh: 0, translation: [9, 9, 9], ...hidden })
    }),
  ),
  'a node below a hidden one': writeAs((shape) =>
    makePlain(shape, {}, (writer) => {
      writer.extension('KHR_node_visibility')
      const child = writer.add('nodes', { mesh: 0 })
      writer.node({ children: [child], ...hidden })
      writer.json.nodes[0].extensions = { KHR_node_visibility: { visible: true } }
    }),
  ),
  'colours from specular-glossiness': withGlossiness,
  'required WebP textures': requireExtension('EXT_texture_webp'),
  'required Basis textures': requireExtension('KHR_texture_basisu'),
  'required AVIF textures': requireExtension('EXT_texture_avif'),
  'required DDS textures': requireExtension('MSFT_texture_dds'),
  '16-bit positions': quantize(Int16Array, { unit: 32767, normalized: true }),
  '16-bit positions, not normalized': quantize(Int16Array, { unit: 30000 }),
  'unsigned 16-bit positions': quantize(Uint16Array, {
    unit: 65535,
    normalized: true,
    shift: 1,
  }),
  '8-bit positions': quantize(Int8Array, { unit: 127, normalized: true }),
  'unsigned 8-bit positions': quantize(Uint8Array, { unit: 255, shift: 1 }),
}
