// Invalid model files, each with the reason that loadMesh must report.
import { readGlb, writeGlb } from '../glb.js'
import { extensionVariants } from './extension-variants.js'
import { plain, plainVariants } from './gltf-variants.js'
import { packedVariants } from './packed-variants.js'
import { shapes } from './shapes.js'
import { textVariants } from './text-variants.js'

const { cube } = shapes
const encode = (text) => new TextEncoder().encode(text)

/** Changes the document, and possibly the binary data, of a GLB. */
function modifyGlb(file, change) {
  const { json, chunks } = readGlb(file)
  const binary = chunks[1]?.bytes
  change(json, binary)
  return writeGlb(json, binary)
}

const cubeFile = (change) => modifyGlb(plain(cube).glb().file, change)
const variant = (variants, name, change) => modifyGlb(variants[name](cube).file, change)
const firstPrimitive = (json) => json.meshes[0].primitives[0]
const packedView = (json) =>
  json.bufferViews.find(({ extensions }) => extensions).extensions.EXT_meshopt_compression
const instances = (json) => json.nodes[0].extensions.EXT_mesh_gpu_instancing.attributes
/** Adds an accessor whose elements are zeros, since it has no view. Returns its index. */
const addZeros = (json, count) =>
  json.accessors.push({ componentType: 5126, count, type: 'VEC3' }) - 1

const binaryStl = textVariants['a binary STL'](cube).file
const textStl = textVariants['a text STL'](cube).file
const decode = (bytes) => new TextDecoder().decode(bytes)

/** Maps a description of the mistake → the file, and a pattern of the reason. */
export const broken = {
  'an unknown required extension': {
    file: cubeFile((json) => (json.extensionsRequired = ['ACME_teapots'])),
    reason: /requires the extension "ACME_teapots"/,
  },
  'indices out of range': {
    file: cubeFile((json) => {
      json.accessors[0].componentType = 5121
      json.accessors[0].count = 3
      json.bufferViews[0].byteOffset = 4 * 72
    }),
    reason: /uses vertex/,
  },
  'a truncated buffer': {
    file: cubeFile((json) => (json.buffers[0].byteLength += 100)),
    reason: /ends in the middle of its data/,
  },
  'a view that exceeds its buffer': {
    file: cubeFile((json) => (json.bufferViews[1].byteLength = 1e6)),
    reason: /bufferView 1 reads up to byte/,
  },
  'an accessor that exceeds its view': {
    file: cubeFile((json) => (json.accessors[1].count = 1000)),
    reason: /accessor 1 reads up to byte/,
  },
  'a million instances of a cube': {
    file: variant(extensionVariants, 'instances with translations', (json) => {
      instances(json).TRANSLATION = addZeros(json, 4_000_000)
    }),
    reason: /more than 1,048,576 parts/,
  },
  'instances that take too much memory': {
    file: modifyGlb(
      extensionVariants['instances with translations'](shapes.sphere).file,
      (json) => {
        instances(json).TRANSLATION = addZeros(json, 1_048_000)
      },
    ),
    reason: /at most 1,073,741,824 are read/,
  },
  'instance attributes of different lengths': {
    file: variant(
      extensionVariants,
      'instances with translations, rotations and scales',
      (json) => {
        instances(json).SCALE = addZeros(json, 2)
      },
    ),
    reason: /the instances of a node have 3 elements of one attribute and 2 of another/,
  },
  'instance rotations with three numbers': {
    file: variant(
      extensionVariants,
      'instances with translations, rotations and scales',
      (json) => {
        instances(json).ROTATION = instances(json).SCALE
      },
    ),
    reason: /must hold vectors of 4 numbers/,
  },
  'a morph target of another length': {
    file: variant(extensionVariants, 'morph weights of the mesh', (json) => {
      firstPrimitive(json).targets[0].POSITION = addZeros(json, 7)
    }),
    reason: /24 positions, but 7 of its morph target's POSITION/,
  },
  'weights that are not numbers': {
    file: variant(extensionVariants, 'morph weights of the mesh', (json) => {
      json.meshes[0].weights = ['heavy']
    }),
    reason: /meshes\[0\].weights must be a list of numbers/,
  },
  'a scene in which everything is hidden': {
    file: variant(extensionVariants, 'a hidden node', (json) => {
      for (const node of json.nodes) node.extensions = { KHR_node_visibility: { visible: false } }
    }),
    reason: /there is nothing to draw/,
  },
  'sparse indices beyond the end': {
    file: variant(plainVariants, 'sparse positions', (json, binary) => {
      const { bufferView } = json.accessors.find(({ sparse }) => sparse).sparse.indices
      binary[json.bufferViews[bufferView].byteOffset + 1] = 255
    }),
    reason: /replaces its element/,
  },
  'millions of implicit zeros': {
    file: cubeFile((json) => (firstPrimitive(json).attributes.POSITION = addZeros(json, 5e6))),
    reason: /5,000,000 elements without any bytes/,
  },
  'broken meshopt data': {
    file: variant(packedVariants, 'meshopt, vertices and triangles', (json, binary) => {
      binary.fill(0xff, packedView(json).byteOffset, packedView(json).byteOffset + 8)
    }),
    reason: /the data of EXT_meshopt_compression cannot be decoded \(Malformed buffer data/,
  },
  'truncated meshopt data': {
    file: variant(packedVariants, 'meshopt, vertices and triangles', (json) => {
      packedView(json).byteLength = 9
    }),
    reason: /the data of EXT_meshopt_compression cannot be decoded/,
  },
  'an unknown meshopt mode': {
    file: variant(packedVariants, 'meshopt, vertices and triangles', (json) => {
      packedView(json).mode = 'POINTS'
    }),
    reason: /unknown mode "POINTS"/,
  },
  'an unknown meshopt filter': {
    file: variant(packedVariants, 'meshopt, vertices and triangles', (json) => {
      packedView(json).filter = 'BLUR'
    }),
    reason: /unknown filter "BLUR"/,
  },
  'a meshopt bomb': {
    file: variant(packedVariants, 'meshopt, vertices and triangles', (json) => {
      packedView(json).count = 4e9
    }),
    reason: /would take 48,000,\d{3},\d{3} bytes/,
  },
  'broken Draco data': {
    file: variant(packedVariants, 'Draco, edgebreaker encoding', (json, binary) => {
      const { bufferView } = firstPrimitive(json).extensions.KHR_draco_mesh_compression
      const { byteOffset, byteLength } = json.bufferViews[bufferView]
      binary.fill(0, byteOffset + 20, byteOffset + byteLength)
    }),
    reason: /the data of KHR_draco_mesh_compression cannot be decoded/,
  },
  'bytes that are not Draco data': {
    file: variant(packedVariants, 'Draco, edgebreaker encoding', (json, binary) => {
      const { bufferView } = firstPrimitive(json).extensions.KHR_draco_mesh_compression
      binary.fill(7, json.bufferViews[bufferView].byteOffset)
    }),
    reason: /the data of KHR_draco_mesh_compression cannot be decoded/,
  },
  'a missing Draco attribute': {
    file: variant(packedVariants, 'Draco, sequential encoding', (json) => {
      firstPrimitive(json).extensions.KHR_draco_mesh_compression.attributes.POSITION = 9
    }),
    reason: /it has no attribute 9/,
  },
  'a Draco attribute of another width': {
    file: variant(packedVariants, 'Draco, sequential encoding', (json) => {
      const { attributes } = firstPrimitive(json).extensions.KHR_draco_mesh_compression
      attributes.TEXCOORD_0 = attributes.POSITION
    }),
    reason: /expected 2 numbers per vertex, got 3/,
  },
  'a truncated binary STL': {
    file: binaryStl.slice(0, -10),
    reason: /ends in the middle of its data \(expected 684 bytes, got 674\)/,
  },
  'a binary STL without triangles': {
    file: new Uint8Array(84),
    reason: /the .stl has no triangles/,
  },
  'a truncated text STL': {
    file: textStl.slice(0, 500),
    reason: /line \d+ of the .stl|ends in the middle of a facet/,
  },
  'a text STL with an unknown keyword': {
    file: encode(decode(textStl).replace('outer loop', 'outer hoop')),
    reason: /line 3 of the .stl has "hoop" where "loop" belongs/,
  },
  'a text STL with an invalid number': {
    file: encode(decode(textStl).replace('vertex -1', 'vertex -1,5')),
    reason: /line \d+ of the .stl has ".*" where a number belongs/,
  },
  'an OBJ whose only face has an invalid position': {
    file: encode('v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n'),
    reason: /line 3 of the .obj has "nan" where a number belongs/,
  },
  'an OBJ with too many vertices': {
    file: encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n'),
    reason: /line 4 of the .obj refers to position 4, but there are only 3 before it/,
  },
  'an OBJ without faces': {
    file: encode('v 0 0 0\nv 1 0 0\nv 0 1 0\n'),
    reason: /the .obj has no faces/,
  },
  'a PLY file': {
    file: encode('ply\nformat ascii 1.0\n'),
    reason: /not a .glb, .gltf, .obj or .stl file/,
  },
}
