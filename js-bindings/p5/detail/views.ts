/** Reads the view of a shape: the matrices, and the size of the canvas or framebuffer that p5 draws on. */
import type { Vertices } from '../../compile/hosts.js'
import type { DetailViews, ToSpace } from '../../detail/detailed-mesh.js'
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

function product(matrices: readonly Matrix[]): number[] {
  return matrices.reduce<number[]>(
    (a, b) =>
      Array.from({ length: 16 }, (_, i) => {
        const [row, column] = [i % 4, i - (i % 4)]
        return [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row]! * b[column + k]!, 0)
      }),
    [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  )
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
function transform(m: readonly number[]): ToSpace {
  const normalMatrix = normalMatrixOf(m)
  return (samples, positions) => {
    const { positions: given, normals, ...others } = samples
    for (let i = 0; i < positions.length; i += 3)
      for (let row = 0; row < 3; row++)
        positions[i + row] =
          m[row]! * given[i]! +
          m[4 + row]! * given[i + 1]! +
          m[8 + row]! * given[i + 2]! +
          m[12 + row]!
    const moved: Vertices = { ...others, positions }
    if (normals) moved.normals = multiplyAll(normals, normalMatrix)
    return moved
  }
}

/** Multiplies vectors by a matrix of 3 by 3, by columns. */
function multiplyAll(vectors: ArrayLike<number>, m: readonly number[]): Float32Array {
  const all = new Float32Array(vectors.length)
  for (let i = 0; i < all.length; i += 3) {
    const n = [0, 1, 2].map(
      (row) =>
        m[row]! * vectors[i]! + m[3 + row]! * vectors[i + 1]! + m[6 + row]! * vectors[i + 2]!,
    )
    all.set(n, i)
  }
  return all
}
