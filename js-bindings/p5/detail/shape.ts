/** The arrays of a p5.Geometry that a shader reads, as the base of a `DetailedMesh`. */
import type { DetailAttribute, DetailBase } from '../../detail/detailed-mesh.js'
import type { Renderer, Shader, Vector } from '../host.js'

/** A p5.Geometry, by the names of its arrays. */
export interface DrawnShape {
  gid?: string
  readonly vertices: readonly Vector[]
  readonly faces: readonly (readonly number[])[]
  readonly dirtyFlags: Record<string, boolean | undefined>
  [array: string]: unknown
}

/** p5's RenderBuffer. */
export interface FillBuffer {
  readonly attr: string
  /** The name of the array of shapes. */
  readonly src: string
  /** The name of the buffer of the GPU. */
  readonly dst: string
  readonly size: number
  readonly map?: ((values: unknown) => ArrayLike<number>) | undefined
  /** On WEBGPU, what a shape without this array has. */
  readonly default?: (shape: DrawnShape) => ArrayLike<number>
}

/** The arrays that all shapes have, as inputs of the warp. */
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

/** Returns the buffers that the renderer fills for the shader. */
function buffersFor(renderer: Renderer, shader: Shader): FillBuffer[] {
  const { fill = [], user = [] } = (renderer.buffers ?? renderer.retainedMode!.buffers) as {
    fill?: readonly unknown[]
    user?: readonly unknown[]
  }
  const attributes = (shader as { attributes?: object }).attributes ?? {}
  return ([...fill, ...user] as FillBuffer[]).filter(({ attr }) => attr in attributes)
}

/** Reads the arrays of a shape. */
export function baseOf(renderer: Renderer, shader: Shader, shape: DrawnShape): ShapeBase {
  const buffers: FillBuffer[] = []
  const attributes: DetailAttribute[] = []
  let positions: ArrayLike<number> = []
  let positionBuffer = ''
  for (const buffer of buffersFor(renderer, shader)) {
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
  return { positions, positionBuffer, attributes, indices: shape.faces.flat(), buffers }
}

function valuesOf(buffer: FillBuffer, shape: DrawnShape): ArrayLike<number> {
  const given = shape[buffer.src] as ArrayLike<number> | undefined
  if (given?.length) return buffer.map ? buffer.map(given) : given
  return Object.hasOwn(buffer, 'default') ? buffer.default!(shape) : []
}
