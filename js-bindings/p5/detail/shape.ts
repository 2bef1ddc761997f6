/** Reads the arrays of a p5.Geometry that a shader uses, as the base of a `DetailedMesh`. */
import type { DetailAttribute, DetailBase, DetailedMesh } from '../../detail/detailed-mesh.js'
import type { Renderer, Shader, Vector } from '../host.js'

/** A p5.Geometry, by the names of its arrays. */
export interface DrawnShape {
  gid?: string
  readonly vertices: readonly Vector[]
  readonly faces: readonly (readonly number[])[]
  readonly edges?: readonly (readonly number[])[]
  readonly dirtyFlags: Record<string, boolean | undefined>
  [array: string]: unknown
}

/** p5's RenderBuffer. */
export interface FillBuffer {
  readonly attr: string
  /** The name of the array in a shape. */
  readonly src: string
  /** The name of the buffer on the GPU. */
  readonly dst: string
  readonly size: number
  readonly map?: ((values: unknown) => ArrayLike<number>) | undefined
  /** Returns the values for a shape that lacks this array, on p5 2.x. */
  readonly default?: (shape: DrawnShape) => ArrayLike<number>
}

/** Maps attributes of shaders → the input arrays of the warp. */
const inputs: Record<string, DetailAttribute['input']> = {
  aNormal: 'normals',
  aTexCoord: 'uvs',
  aVertexColor: 'colors',
}

export interface ShapeBase extends DetailBase {
  /** The name of the buffer of positions. */
  readonly positionBuffer: string
  /** The buffers of `attributes`, in the same order. */
  readonly buffers: readonly FillBuffer[]
}

/** Returns all buffers of a kind that the renderer can fill. */
export const buffersOf = (renderer: Renderer, kind: 'fill' | 'user' | 'stroke'): FillBuffer[] =>
  (((renderer.buffers ?? renderer.retainedMode!.buffers) as Partial<Record<string, unknown>>)[
    kind
  ] as FillBuffer[] | undefined) ?? []

/** Returns the buffers that the renderer fills for the shader, and that of normals if the surface is curved. */
function buffersFor(renderer: Renderer, shader: Shader, isCurved: boolean): FillBuffer[] {
  const attributes = (shader as { attributes?: object }).attributes ?? {}
  return [...buffersOf(renderer, 'fill'), ...buffersOf(renderer, 'user')].filter(
    ({ attr }) => attr in attributes || (isCurved && attr === 'aNormal'),
  )
}

/** Reads the arrays of a shape. */
export function baseOf(
  renderer: Renderer,
  shader: Shader,
  shape: DrawnShape,
  isCurved: boolean,
): ShapeBase {
  const buffers: FillBuffer[] = []
  const attributes: DetailAttribute[] = []
  let positions: ArrayLike<number> = []
  let positionBuffer = ''
  for (const buffer of buffersFor(renderer, shader, isCurved)) {
    const values = valuesOf(buffer, shape)
    if (values.length !== buffer.size * shape.vertices.length) continue
    if (buffer.src === 'vertices') {
      positions = values
      positionBuffer = buffer.dst
      continue
    }
    const input = inputs[buffer.attr]
    buffers.push(buffer)
    attributes.push({ input, size: buffer.size, values, isUnit: input === 'normals' })
  }
  return { positions, positionBuffer, attributes, ...trianglesOf(shape), buffers, isCurved }
}

/**
 * Returns the faces, followed by a triangle with two equal corners for each edge that is no side of a face. Such a triangle is divided
 * as a line, and not drawn. A group begins with the first of them.
 */
function trianglesOf({ faces, edges = [] }: DrawnShape) {
  const name = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`
  const sides = new Set(
    edges.length
      ? faces.flatMap((face) => face.map((corner, i) => name(corner, face[(i + 1) % 3]!)))
      : [],
  )
  const lines = edges.filter(([a, b]) => a !== b && !sides.has(name(a!, b!)))
  const indices = [...faces.flat(), ...lines.flatMap(([a, b]) => [a!, b!, b!])]
  return lines.length ? { indices, groups: [faces.length] } : { indices }
}

/** Returns the indices of the triangles that are drawn. */
export function drawnIndices({ groups }: ShapeBase, mesh: DetailedMesh): Uint32Array {
  return groups ? mesh.indices().subarray(0, 3 * mesh.groups()[0]!) : mesh.indices()
}

/** Returns the values of a buffer. `counted` is the shape from which p5 computes values that are missing. */
export function valuesOf(
  buffer: FillBuffer,
  shape: DrawnShape,
  counted: Partial<DrawnShape> = shape,
): ArrayLike<number> {
  const given = shape[buffer.src] as ArrayLike<number> | undefined
  if (given?.length) return buffer.map ? buffer.map(given) : given
  return Object.hasOwn(buffer, 'default') ? buffer.default!(counted as DrawnShape) : []
}
