// glTF files in many forms, each with the triangles that its shape must have: { file, files?, triangles, tolerance? }.
import { reverseTriangles, trianglesOf } from './shapes.js'
import { GltfWriter, extent } from './writer.js'

/** Makes the accessors of a shape's attributes; `own` replaces some of them. */
const attributesOf = (writer, shape, own = {}) => ({
  POSITION: own.POSITION ?? writer.accessor(shape.positions, 'VEC3'),
  NORMAL: own.NORMAL ?? writer.accessor(shape.normals, 'VEC3'),
  TEXCOORD_0: own.TEXCOORD_0 ?? writer.accessor(shape.uvs, 'VEC2'),
})

/** Makes a file of one node with one mesh; `change` modifies it before it is written. */
function plain(shape, { indices = Uint16Array, node, mesh, more, own } = {}, change = () => {}) {
  const writer = new GltfWriter()
  const corners = indices && { indices: writer.accessor(indices.from(shape.indices), 'SCALAR') }
  const attributes = attributesOf(writer, shape, own?.(writer))
  writer.mesh(attributes, { ...corners, ...more?.(writer) }, mesh)
  writer.node({ mesh: 0, ...node?.(writer) })
  change(writer)
  return writer
}

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

/** Makes one strip, whose pieces are joined by degenerate triangles; each piece starts at an even index. */
function stripOf(indices) {
  const strip = []
  for (let i = 0; i < indices.length; i += 3) {
    if (i) strip.push(strip.at(-1), indices[i])
    if (strip.length % 2) strip.push(indices[i])
    strip.push(...indices.slice(i, i + 3))
  }
  return Uint16Array.from(strip)
}

function fans(shape) {
  const writer = new GltfWriter()
  const attributes = attributesOf(writer, shape)
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
  const bytes = new Float32Array((count * byteStride) / 4)
  for (let i = 0; i < count; i++) {
    const at = (i * byteStride) / 4
    bytes.set(shape.positions.slice(3 * i, 3 * i + 3), at)
    bytes.set(shape.normals.slice(3 * i, 3 * i + 3), at + 3)
    bytes.set(shape.uvs.slice(2 * i, 2 * i + 2), at + 6)
  }
  const own = (writer) => {
    const bufferView = writer.view(bytes, { byteStride, target: 34962 })
    const part = (byteOffset, type, more) =>
      writer.add('accessors', { bufferView, byteOffset, componentType: 5126, count, type, ...more })
    return {
      POSITION: part(0, 'VEC3', extent(shape.positions)),
      NORMAL: part(12, 'VEC3'),
      TEXCOORD_0: part(24, 'VEC2'),
    }
  }
  return plain(shape, { own })
}

/** Makes an accessor whose elements from index 1 on are sparse; with `base`, the others have a view. */
export function sparse(writer, numbers, type, width, base, more) {
  const count = numbers.length / width
  const places = Uint16Array.from({ length: count - 1 }, (_, i) => i + 1)
  const componentType = type === 'SCALAR' ? 5123 : 5126
  const first = numbers.slice()
  if (base) first.fill(7, width)
  return writer.add('accessors', {
    ...(base && { bufferView: writer.view(first) }),
    componentType,
    count,
    type,
    sparse: {
      count: count - 1,
      indices: { bufferView: writer.view(places), componentType: 5123 },
      values: { bufferView: writer.view(numbers.slice(width)) },
    },
    ...more,
  })
}

/** Moves the shape so that the first element is zero. */
const fromOrigin = (shape) => {
  const [x, y, z] = shape.positions
  return { ...shape, positions: shape.positions.map((n, i) => n - [x, y, z][i % 3]) }
}

const sparsePositions = (isZero) => (given) => {
  const shape = isZero ? fromOrigin(given) : given
  const own = (writer) => ({
    POSITION: sparse(writer, shape.positions, 'VEC3', 3, !isZero, extent(shape.positions)),
  })
  return { ...plain(shape, { own }).glb(), triangles: trianglesOf(shape) }
}

/** Reorders the triangles to begin with vertex 0. */
function fromVertex0(indices) {
  const at = indices.indexOf(0)
  const start = at - (at % 3)
  const first = [0, 1, 2].map((k) => indices[start + ((at + k) % 3)])
  return Uint16Array.from([...first, ...indices.slice(0, start), ...indices.slice(start + 3)])
}

const sparseIndices = as((shape) =>
  plain(shape, {
    indices: null,
    more: (writer) => ({
      indices: sparse(writer, fromVertex0(shape.indices), 'SCALAR', 1, false),
    }),
  }),
)

const matrix = [0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1.5, 0, 3, 4, 5, 1]
const byMatrix = ([x, y, z]) => [-y + 3, 2 * x + 4, 1.5 * z + 5]

/** Weights each vertex by two bones, 1/4 and 3/4. */
function skin(shape) {
  const count = shape.positions.length / 3
  const each = (Type, four) => Type.from({ length: 4 * count }, (_, i) => four[i % 4])
  return plain(shape, {}, (writer) => {
    Object.assign(writer.json.meshes[0].primitives[0].attributes, {
      JOINTS_0: writer.accessor(each(Uint8Array, [0, 1, 0, 0]), 'VEC4'),
      WEIGHTS_0: writer.accessor(each(Float32Array, [0.25, 0.75, 0, 0]), 'VEC4'),
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
    plain({ ...shape, indices: stripOf(shape.indices) }, { more: () => ({ mode: 5 }) }),
  ),
  fans: as(fans),
  'interleaved attributes': as((shape) => interleave(shape, 32)),
  'a stride with gaps': as((shape) => interleave(shape, 44)),
  'sparse positions': sparsePositions(false),
  'sparse positions without a view': sparsePositions(true),
  'sparse indices without a view': sparseIndices,
  'a negative scale': (shape) => ({
    ...plain(shape, { node: () => ({ scale: [-2, 1, 1] }) }).glb(),
    triangles: reverseTriangles(trianglesOf(shape, ([x, y, z]) => [-2 * x, y, z])),
  }),
  'a matrix': as((shape) => plain(shape, { node: () => ({ matrix }) }), 'glb', byMatrix),
  'nested nodes': as(
    (shape) =>
      plain(shape, {}, (writer) => {
        writer.add('nodes', { translation: [0, 0, 1], children: [0] })
        writer.json.scenes[0].nodes = [writer.add('nodes', { scale: [1, 3, 1], children: [1] })]
      }),
    'glb',
    ([x, y, z]) => [x, 3 * y, z + 1],
  ),
  'two bones': as(skin, 'glb', ([x, y, z]) => [x + 1, y + 6, z]),
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
