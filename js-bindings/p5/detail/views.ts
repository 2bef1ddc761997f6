/** Reads the view of a shape: the matrices, and the size of the canvas or framebuffer that p5 draws on. */
import type { DetailViews, ToSpace } from '../../detail/detailed-mesh.js'
import { transformSamples } from '../../detail/transform.js'
import type { Canvas, Renderer } from '../host.js'
import type { WarpSpace } from '../settings.js'

/** A matrix by columns. */
type Matrix = ArrayLike<number>

interface Matrices {
  readonly uModelMatrix: { readonly mat4: Matrix }
  readonly uViewMatrix: { readonly mat4: Matrix }
  readonly uPMatrix: { readonly mat4: Matrix }
}

interface Drawing {
  readonly width: number
  readonly height: number
  readonly density?: number
}

const sizeOf = (canvas: Canvas, renderer: Renderer): [number, number] => {
  const { activeFramebuffer } = renderer as { activeFramebuffer?: () => Drawing | undefined }
  const framebuffer = activeFramebuffer?.call(renderer)
  const density = framebuffer ? (framebuffer.density ?? 1) : canvas.pixelDensity()
  const { width, height } = framebuffer ?? canvas
  return [width * density, height * density]
}

/** Returns the view for `DetailedMesh`, and the transform of a shape into the space of the offset. */
export function viewOf(canvas: Canvas, renderer: Renderer, space: WarpSpace) {
  const { uModelMatrix, uViewMatrix, uPMatrix } = (renderer.states ??
    renderer) as unknown as Matrices
  const [model, view, projection] = [uModelMatrix.mat4, uViewMatrix.mat4, uPMatrix.mat4]
  // `before` transforms from the space of the shape to that of the offset, `after` from there to clip space.
  const before = space === 'local' ? [] : space === 'world' ? [model] : [view, model]
  const after = [
    projection,
    ...(space === 'camera' ? [] : [view]),
    ...(space === 'local' ? [model] : []),
  ]
  const [width, height] = sizeOf(canvas, renderer)
  // p5 also draws triangles that face away.
  const views: DetailViews = [...product(after), width / 2, height / 2, 0]
  const toSpace = before.length ? product(before) : undefined
  return { views, place: toSpace ?? [], toSpace: toSpace && transform(toSpace) }
}

/** Returns the product of one or more matrices. */
function product([first, ...others]: readonly Matrix[]): number[] {
  return others.reduce(multiply, Array.from(first!))
}

function multiply(a: readonly number[], b: Matrix): number[] {
  const result: number[] = []
  for (let i = 0; i < 16; i++) {
    const row = i % 4
    let sum = 0
    for (let k = 0; k < 4; k++) sum += a[4 * k + row]! * b[i - row + k]!
    result.push(sum)
  }
  return result
}

/** Returns the inverse of a matrix' transpose, by columns, without its last row and column. */
export function normalMatrixOf(m: readonly number[]): number[] {
  const cofactors = [
    [5, 10, 6, 9],
    [6, 8, 4, 10],
    [4, 9, 5, 8],
    [2, 9, 1, 10],
    [0, 10, 2, 8],
    [1, 8, 0, 9],
    [1, 6, 2, 5],
    [2, 4, 0, 6],
    [0, 5, 1, 4],
  ].map(([a, b, c, d]) => m[a!]! * m[b!]! - m[c!]! * m[d!]!)
  const determinant = m[0]! * cofactors[0]! + m[1]! * cofactors[1]! + m[2]! * cofactors[2]!
  return cofactors.map((x) => x / determinant)
}

/** Moves positions by the matrix, and normals by the inverse of its transpose. */
function transform(matrix: readonly number[]): ToSpace {
  const normalMatrix = normalMatrixOf(matrix)
  return (samples, to) =>
    transformSamples(samples, to, { matrix, normalMatrix, hasUnitNormals: false })
}
