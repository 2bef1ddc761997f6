import { WarpError, describe, describeShape } from '../errors/errors.js'
import type { Expression } from '../core/expression/expression.js'
import { asOwn, readOperators } from '../errors/operators.js'
import { isCallable, isList } from '../options/options.js'
import type {
  Glsl,
  Mat3,
  Mat4,
  OffsetFunction,
  UniformValues,
  Vec3,
  WarpInputs,
} from '../core/types/types.js'
import { type OptionInputs, type OrFunction, isExpression } from './kinds.js'
import { inputsAt, surfaceOf } from './places.js'
import { checkWarps, offsetOf } from './warps.js'

/** 16 numbers, column by column, the last row 0, 0, 0, 1, as in WebGL; an expression, where a mat3 shifts nothing; or a
 * function that gives one of them. */
export type MatrixOption = OrFunction<ArrayLike<number> | Mat3 | Mat4>

/** p' = linear · p + shift */
interface Space {
  linear: Mat3
  shift: Vec3
}

/**
 * A warp in another space. Its `position` is p' = M p, its `normal` the unit normal there, which looks out of the shape
 * also where M mirrors, and the offset comes back by the inverse of the linear part of M: so the units, the axes and the
 * origin of the warp are those of the space that M leads to. As for `chain`, nothing can be derived by that position.
 *
 * Throws a `WarpError` for what is no matrix or no function, for constants whose linear part has determinant 0, and, when
 * the warp is made, if it returns no vec3. Where a matrix that is computed has determinant 0, points stay.
 */
export function inSpace<Uniforms extends UniformValues = {}>(
  matrix: MatrixOption,
  warp: OffsetFunction<Uniforms>,
): OffsetFunction<Uniforms> {
  if (!isCallable(matrix) && !isExpression(matrix)) checkNumbers(matrix)
  checkWarps('inSpace', [warp], 2)
  return asOwn((inputs) => {
    const { glsl } = inputs
    const given: unknown = isCallable(matrix)
      ? readOperators(matrix, { method: 'inSpace' })(inputs as OptionInputs)
      : matrix
    const { linear, shift } = readSpace(inputs, given)
    const determinant = linear.determinant()
    const surface = surfaceOf(inputs)
    const isMirror = isList(given) ? isLeftHanded(given) : undefined
    const side = isMirror === false ? surface.side : determinant.sign().mult(surface.side ?? 1)
    const inside = inputsAt(inputs, linear.mult(inputs.position).add(shift), {
      ...surface,
      ...(side !== undefined && { side }),
    })
    const offset = linear.inverse().mult(offsetOf('inSpace', 2, warp, inside))
    return determinant.eq(0).ifElse(glsl.vec3(0), offset)
  })
}

function readSpace({ glsl, position }: WarpInputs, matrix: unknown): Space {
  if (!isExpression(matrix)) {
    checkNumbers(matrix)
    const columns = [0, 4, 8, 12].map((i) => glsl.vec3(matrix[i]!, matrix[i + 1]!, matrix[i + 2]!))
    return { linear: glsl.mat3(...columns.slice(0, 3)), shift: columns[3]! }
  }
  const { session } = position as unknown as Expression
  const [columns, rows] = session.shapeOf(matrix as unknown as Expression)
  if (columns !== rows || columns < 3)
    refuse(columns > 1 ? 'a matrix of another size' : describeShape([columns, rows]))
  return columns === 3
    ? { linear: matrix as unknown as Mat3, shift: glsl.vec3(0) }
    : spaceOf(glsl, matrix as unknown as Mat4)
}

const spaceOf = (glsl: Glsl, matrix: Mat4): Space => ({
  linear: glsl.mat3(matrix),
  shift: matrix.column(3).xyz(),
})

function checkNumbers(matrix: unknown): asserts matrix is ArrayLike<number> {
  if (!isList(matrix)) refuse(describe(matrix))
  const numbers = Array.from(matrix)
  if (numbers.length !== 16) refuse(`an array of ${numbers.length}`)
  const wrong = numbers.find((x) => !(typeof x === 'number' && Number.isFinite(Math.fround(x))))
  if (wrong !== undefined) refuse(`an array with ${describe(wrong)}`)
  const lastRow = [3, 7, 11, 15].map((i) => numbers[i])
  if (lastRow.some((x, i) => x !== (i === 3 ? 1 : 0)))
    refuse(`one with the last row ${lastRow.join(', ')}`, ', the last row 0, 0, 0, 1')
  if (isFlat([0, 4, 8].map((i) => numbers.slice(i, i + 3))))
    throw new WarpError(
      'inSpace: the matrix has the determinant 0, so that no way leads back from its space; no axis may be scaled by 0.',
    )
}

/** Whether three columns lie in a plane, as far as float32 can tell. */
const isFlat = (columns: number[][]) => Math.abs(volumeOf(columns)) < 1e-7

const isLeftHanded = (matrix: ArrayLike<unknown>) =>
  volumeOf([0, 4, 8].map((i) => [0, 1, 2].map((k) => matrix[i + k] as number))) < 0

/** What three columns span, each as one of length 1. */
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

function refuse(what: string, more = ''): never {
  throw new WarpError(
    `inSpace: the matrix must be 16 numbers column by column${more}, a mat4 or mat3, or a function that returns one, but is ${what}.`,
  )
}
