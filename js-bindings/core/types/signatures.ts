// What the generated methods and functions are typed with. `types.ts` names the expressions.
import type { Mat2, Mat3, Mat4, Matrix, Scalar, Vec2, Vec3, Vec4, Vector } from './types.js'

declare const shape: unique symbol

/** Keeps sizes apart, in types only: no expression has such a property when a sketch runs. */
export interface Shape<Columns extends number, Rows extends number> {
  readonly [shape]: readonly [columns: Columns, rows: Rows]
}

export type Size = 2 | 3 | 4
export type VectorOf<Rows extends Size> = { 2: Vec2; 3: Vec3; 4: Vec4 }[Rows]
export type SquareOf<Rows extends Size> = { 2: Mat2; 3: Mat3; 4: Mat4 }[Rows]
/** Takes unions apart, so that `MatrixOf<Size, Size>` is any of the nine. */
export type MatrixOf<Columns extends Size, Rows extends Size> = Rows extends Size
  ? Columns extends Rows
    ? SquareOf<Rows>
    : Columns extends Size
      ? Matrix<Columns, Rows>
      : never
  : never

export type ColumnsOf<Self extends Shape<Size, Size>> = Self[typeof shape][0]
export type RowsOf<Self extends Shape<number, Size>> = Self[typeof shape][1]

/** The matrices by which a vector, as a row or as a column, keeps its size. */
export type SquareBeside<Self extends Shape<1, Size>> = SquareOf<RowsOf<Self>>
export type Transposed<Self extends Shape<Size, Size>> = MatrixOf<RowsOf<Self>, ColumnsOf<Self>>
/** A column for each component of the inputs, as GLSL's matCxR. */
export type Jacobian<Value extends Shape<1, Size>, Inputs extends Shape<1, Size>> = MatrixOf<
  RowsOf<Inputs>,
  RowsOf<Value>
>

/** A function by component: a scalar of numbers, otherwise a vector; those among the operands all have its size. */
export interface ByComponent<Numbers extends unknown[]> {
  (...numbers: Numbers): Scalar
  <Value extends Scalar | Vector>(...operands: { [I in keyof Numbers]: Value | Numbers[I] }): Value
}

export type IfSquare<Self extends Shape<Size, Size>> =
  ColumnsOf<Self> extends RowsOf<Self> ? Self : never
