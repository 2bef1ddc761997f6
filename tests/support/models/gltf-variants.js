// glTF files in many forms. Each is a function that maps a shape to { file, files?, triangles, tolerance? }, with the triangles that the
// file must have.
import { reverseTriangles, trianglesOf } from './shapes.js'
import { GltfWriter, extent } from './writer.js'

/** Adds the accessors of a shape's attributes; `own` contains accessors that replace some of them. */
const addAttributes = (writer, shape, own = {}) => ({
  POSITION: own.POSITION ?? writer.accessor(shape.positions, 'VEC3'),
  NORMAL: own.NORMAL ?? writer.accessor(shape.normals, 'VEC3'),
  TEXCOORD_0: own.TEXCOORD_0 ?? writer.accessor(shape.uvs, 'VEC2'),
})

/**
 * Makes a file of one node with one mesh. `node`, `mesh` and `more` have further properties of the node, the mesh and the primitive; `own`
 * is a function that adds other accessors for some attributes; `change` modifies the document before it is written.
 */
function plain(shape, { indices = Uint16Array, node, mesh, more, own } = {}, change = () => {}) {
  const writer = new GltfWriter()
  const corners = indices && { indices: writer.accessor(indices.from(shape.indices), 'SCALAR') }
  const attributes = addAttributes(writer, shape, own?.(writer))
  writer.mesh(attributes, { ...corners, ...more?.(writer) }, mesh)
  writer.node({ mesh: 0, ...node?.(writer) })
  change(writer)
  return writer
}

/**
 * Returns a function that maps a shape to the file that `make` makes. `form` is the method of the writer that writes it; `move` moves the
 * expected corners.
 */
const as =
  (make, form = 'glb', move) =>
  (shape) => ({ ...make(shape)[form](), triangles: trianglesOf(shape, move) })

const removeIndices = (shape) => {
  const gather = (numbers, width) =>
    Float32Array.from(
      [...shape.indices].flatMap((i) => [...numbers.slice(width * i, width * (i + 1))]),
    )
  return {
    positions: gather(shape.positions, 3),
    normals: gather(shape.normals, 3),
    uvs: gather(shape.uvs, 2),
    indices: Uint32Array.from(shape.indices, (_, i) => i),
  }
}

/**
 * Makes a triangle strip in which degenerate triangles separate the given ones. Each given triangle starts at an even index, since odd ones
 * would reverse it.
 */
function makeStrip(indices) {
  const strip = []
  for (let i = 0; i < indices.length; i += 3) {
    if (i) strip.push(strip.at(-1), indices[i])
    if (strip.length % 2) strip.push(indices[i])
    strip.push(...indices.slice(i, i + 3))
  }
  return Uint16Array.from(strip)
}

/** Makes one primitive per triangle: a fan that consists of this triangle. */
function makeFans(shape) {
  const writer = new GltfWriter()
  const attributes = addAttributes(writer, shape)
  const primitives = []
  for (let i = 0; i < shape.indices.length; i += 3) {
    const corners = Uint16Array.from(shape.indices.slice(i, i + 3))
    primitives.push({ attributes, mode: 6, indices: writer.accessor(corners, 'SCALAR') })
  }
  writer.add('meshes', { primitives })
  writer.node({ mesh: 0 })
  return writer
}

function interleave(shape, byteStride) {
  const count = shape.positions.length / 3
  const floats = new Float32Array((count * byteStride) / 4)
  for (let i = 0; i < count; i++) {
    const start = (i * byteStride) / 4
    floats.set(shape.positions.slice(3 * i, 3 * i + 3), start)
    floats.set(shape.normals.slice(3 * i, 3 * i + 3), start + 3)
    floats.set(shape.uvs.slice(2 * i, 2 * i + 2), start + 6)
  }
  const own = (writer) => {
    const bufferView = writer.view(floats, { byteStride, target: 34962 })
    const addAccessor = (byteOffset, type, more) =>
      writer.add('accessors', { bufferView, byteOffset, componentType: 5126, count, type, ...more })
    return {
      POSITION: addAccessor(0, 'VEC3', extent(shape.positions)),
      NORMAL: addAccessor(12, 'VEC3'),
      TEXCOORD_0: addAccessor(24, 'VEC2'),
    }
  }
  return plain(shape, { own })
}

/** Adds an accessor whose elements from index 1 on are sparse. Without `hasBase`, it has no view, so that the first element is zero. */
export function sparse(writer, numbers, type, width, hasBase, more) {
  const count = numbers.length / width
  const indices = Uint16Array.from({ length: count - 1 }, (_, i) => i + 1)
  const componentType = type === 'SCALAR' ? 5123 : 5126
  const base = numbers.slice()
  base.fill(7, width)
  return writer.add('accessors', {
    ...(hasBase && { bufferView: writer.view(base) }),
    componentType,
    count,
    type,
    sparse: {
      count: count - 1,
      indices: { bufferView: writer.view(indices), componentType: 5123 },
      values: { bufferView: writer.view(numbers.slice(width)) },
    },
    ...more,
  })
}

/** Moves the shape so that its first position is zero. */
const startAtOrigin = (shape) => {
  const [x, y, z] = shape.positions
  return { ...shape, positions: shape.positions.map((n, i) => n - [x, y, z][i % 3]) }
}

const sparsePositions = (startsAtZero) => (original) => {
  const shape = startsAtZero ? startAtOrigin(original) : original
  const own = (writer) => ({
    POSITION: sparse(writer, shape.positions, 'VEC3', 3, !startsAtZero, extent(shape.positions)),
  })
  return { ...plain(shape, { own }).glb(), triangles: trianglesOf(shape) }
}

/** Reorders the triangles and their corners so that vertex 0 is first. */
function startAtVertex0(indices) {
  const place = indices.indexOf(0)
  const start = place - (place % 3)
  const first = [0, 1, 2].map((k) => indices[start + ((place + k) % 3)])
  return Uint16Array.from([...first, ...indices.slice(0, start), ...indices.slice(start + 3)])
}

const sparseIndices = as((shape) =>
  plain(shape, {
    indices: null,
    more: (writer) => ({
      indices: sparse(writer, startAtVertex0(shape.indices), 'SCALAR', 1, false),
    }),
  }),
)

const matrix = [0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1.5, 0, 3, 4, 5, 1]
const applyMatrix = ([x, y, z]) => [-y + 3, 2 * x + 4, 1.5 * z + 5]

/** Weights each vertex by two bones, 1/4 and 3/4. */
function makeSkinned(shape) {
  const count = shape.positions.length / 3
  const repeat = (Type, four) => Type.from({ length: 4 * count }, (_, i) => four[i % 4])
  return plain(shape, {}, (writer) => {
    Object.assign(writer.json.meshes[0].primitives[0].attributes, {
      JOINTS_0: writer.accessor(repeat(Uint8Array, [0, 1, 0, 0]), 'VEC4'),
      WEIGHTS_0: writer.accessor(repeat(Float32Array, [0.25, 0.75, 0, 0]), 'VEC4'),
    })
    const bones = [{ translation: [4, 0, 0] }, { translation: [0, 8, 0] }].map((bone) =>
      writer.add('nodes', bone),
    )
    writer.node({ children: bones })
    writer.json.nodes[0].skin = writer.add('skins', { joints: bones })
  })
}

export const plainVariants = {
  'a GLB': as(plain),
  'a data URI': as(plain, 'embedded'),
  'an external buffer': as(plain, 'external'),
  '8-bit indices': as((shape) => plain(shape, { indices: Uint8Array })),
  '32-bit indices': as((shape) => plain(shape, { indices: Uint32Array })),
  'no indices': as((shape) => plain(removeIndices(shape), { indices: null })),
  'a strip': as((shape) =>
    plain({ ...shape, indices: makeStrip(shape.indices) }, { more: () => ({ mode: 5 }) }),
  ),
  fans: as(makeFans),
  'interleaved attributes': as((shape) => interleave(shape, 32)),
  'a stride with gaps': as((shape) => interleave(shape, 44)),
  'sparse positions': sparsePositions(false),
  'sparse positions without a view': sparsePositions(true),
  'sparse indices without a view': sparseIndices,
  'a negative scale': (shape) => ({
    ...plain(shape, { node: () => ({ scale: [-2, 1, 1] }) }).glb(),
    triangles: reverseTriangles(trianglesOf(shape, ([x, y, z]) => [-2 * x, y, z])),
  }),
  'a matrix': as((shape) => plain(shape, { node: () => ({ matrix }) }), 'glb', applyMatrix),
  'nested nodes': as(
    (shape) =>
      plain(shape, {}, (writer) => {
        writer.add('nodes', { translation: [0, 0, 1], children: [0] })
        writer.json.scenes[0].nodes = [writer.add('nodes', { scale: [1, 3, 1], children: [1] })]
      }),
    'glb',
    ([x, y, z]) => [x, 3 * y, z + 1],
  ),
  'two bones': as(makeSkinned, 'glb', ([x, y, z]) => [x + 1, y + 6, z]),
  '8-bit vertex colours': as((shape) =>
    plain(shape, {}, (writer) => {
      const colors = new Uint8Array((shape.positions.length / 3) * 4).fill(128)
      writer.json.meshes[0].primitives[0].attributes.COLOR_0 = writer.accessor(colors, 'VEC4', {
        normalized: true,
      })
    }),
  ),
}

export { plain, as }
