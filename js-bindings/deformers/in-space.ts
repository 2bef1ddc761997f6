import type { Expression } from '../core/expression/expression.js'
import type {
  Glsl,
  Mat3,
  Mat4,
  OffsetFunction,
  UniformValues,
  Vec3,
  WarpInputs,
} from '../core/types/types.js'
import { describe, describeShape } from '../errors/describe.js'
import { markLibraryFunction, translateOperators } from '../errors/operators.js'
import { isCallable, isFiniteFloat, isList } from '../options/guards.js'
import { Place } from '../options/place.js'
import { isExpression, type OptionInputs, type OrFunction } from './kinds.js'
import { inputsAt, surfaceOf } from './places.js'
import { warp as warpKind } from './warps.js'

/** 16 numbers in column-major order with the last row 0, 0, 0, 1, as in WebGL; or a mat4, or a mat3 without translation; or
 * a function that returns one of these. */
export type MatrixOption = OrFunction<ArrayLike<number> | Mat3 | Mat4>

/** The affine transform p' = linear · p + shift. */
interface Space {
  linear: Mat3
  shift: Vec3
}

/**
 * Applies a warp in another space. The warp's `position` is p' = M p, its `normal` the unit normal there, which points outwards
 * even if M mirrors, and the offset is transformed back by the inverse of the linear part of M. So the units, axes and
 * origin of the warp are those of the space that M maps to. As for `chain`, you cannot differentiate with respect to that position.
 *
 * Throws a `WarpError` if an argument is not a matrix or a function, if the linear part of a constant matrix has determinant 0 and,
 * when the warp is made, if `warp` does not return a vec3. If a computed matrix has determinant 0, points do not move.
 */
export function inSpace<Uniforms extends UniformValues = {}>(
  matrix: MatrixOption,
  warp: OffsetFunction<Uniforms>,
): OffsetFunction<Uniforms> {
  if (!isCallable(matrix) && !isExpression(matrix)) rejectNonMatrix(matrix)
  const offsetAt = warpKind.read(warp, place.argument(2))
  return markLibraryFunction((inputs) => {
    const { glsl } = inputs
    const value: unknown = isCallable(matrix)
      ? translateOperators(matrix, { method: 'inSpace' })(inputs as OptionInputs)
      : matrix
    const { linear, shift } = spaceOf(inputs, value)
    const determinant = linear.determinant()
    const surface = surfaceOf(inputs)
    const isMirroring = isList(value) ? isLeftHanded(value) : undefined
    const side = isMirroring === false ? surface.side : determinant.sign().mult(surface.side ?? 1)
    const inside = inputsAt(inputs, linear.mult(inputs.position).add(shift), {
      ...surface,
      ...(side !== undefined && { side }),
    })
    const offset = linear.inverse().mult(offsetAt(inside))
    return determinant.eq(0).ifElse(glsl.vec3(0), offset)
  })
}

function spaceOf({ glsl, position }: WarpInputs, matrix: unknown): Space {
  if (!isExpression(matrix)) {
    rejectNonMatrix(matrix)
    const columns = [0, 4, 8, 12].map((i) => glsl.vec3(matrix[i]!, matrix[i + 1]!, matrix[i + 2]!))
    return { linear: glsl.mat3(...columns.slice(0, 3)), shift: columns[3]! }
  }
  const { session } = position as unknown as Expression
  const [columns, rows] = session.shapeOf(matrix as unknown as Expression)
  if (columns !== rows || columns < 3)
    throw matrixError(columns > 1 ? 'a matrix of another size' : describeShape([columns, rows]))
  return columns === 3
    ? { linear: matrix as unknown as Mat3, shift: glsl.vec3(0) }
    : spaceOfMat4(glsl, matrix as unknown as Mat4)
}

const spaceOfMat4 = (glsl: Glsl, matrix: Mat4): Space => ({
  linear: glsl.mat3(matrix),
  shift: matrix.column(3).xyz(),
})

function rejectNonMatrix(matrix: unknown): asserts matrix is ArrayLike<number> {
  if (!isList(matrix)) throw matrixError(describe(matrix))
  const numbers = Array.from(matrix)
  if (numbers.length !== 16) throw matrixError(`an array of ${numbers.length}`)
  const other = numbers.findIndex((x) => !isFiniteFloat(x))
  if (other >= 0) throw matrixError(`an array with ${describe(numbers[other])}`)
  const lastRow = [3, 7, 11, 15].map((i) => numbers[i])
  if (lastRow.some((x, i) => x !== (i === 3 ? 1 : 0)))
    throw matrixError(
      `one with the last row ${lastRow.join(', ')}`,
      ', with the last row 0, 0, 0, 1',
    )
  if (isFlat([0, 4, 8].map((i) => numbers.slice(i, i + 3))))
    throw place.error(
      'the matrix has the determinant 0, so it has no inverse; no axis may be scaled by 0.',
    )
}

/** Returns whether three columns are in a plane, within the precision of float32. */
const isFlat = (columns: number[][]) => Math.abs(volumeOf(columns)) < 1e-7

const isLeftHanded = (matrix: ArrayLike<unknown>) =>
  volumeOf([0, 4, 8].map((i) => [0, 1, 2].map((k) => matrix[i + k] as number))) < 0

/** Returns the volume spanned by three columns, each scaled to length 1. */
function volumeOf(columns: number[][]): number {
  const [a, b, c] = columns.map((column) => {
    const length = Math.hypot(...column) || 1
    return column.map((x) => x / length)
  }) as [number[], number[], number[]]
  const cross = [0, 1, 2].map((i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3]
    return a[j]! * b[k]! - a[k]! * b[j]!
  })
  return cross.reduce((sum, x, i) => sum + x * c[i]!, 0)
}

const place = new Place('inSpace')

const matrixError = (got: string, more = '') =>
  place
    .part('the matrix')
    .expected(
      `16 numbers column by column${more}, a mat4 or mat3, or a function that returns one`,
      got,
    )
