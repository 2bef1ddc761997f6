// Helper types of the generated methods and functions.
import type { Mat2, Mat3, Mat4, Matrix, Scalar, Vec2, Vec3, Vec4, Vector } from './types.js'

declare const shape: unique symbol

/** Distinguishes sizes in types only: expressions have no such property at run time. */
export interface Shape<Columns extends number, Rows extends number> {
  readonly [shape]: readonly [columns: Columns, rows: Rows]
}

export type Size = 2 | 3 | 4
export type VectorOf<Rows extends Size> = { 2: Vec2; 3: Vec3; 4: Vec4 }[Rows]
export type SquareOf<Rows extends Size> = { 2: Mat2; 3: Mat3; 4: Mat4 }[Rows]
/** Distributes over unions, so that `MatrixOf<Size, Size>` is the union of all nine types. */
export type MatrixOf<Columns extends Size, Rows extends Size> = Rows extends Size
  ? Columns extends Rows
    ? SquareOf<Rows>
    : Columns extends Size
      ? Matrix<Columns, Rows>
      : never
  : never

export type ColumnsOf<Self extends Shape<Size, Size>> = Self[typeof shape][0]
export type RowsOf<Self extends Shape<number, Size>> = Self[typeof shape][1]

/** The matrices whose product with a vector, as a row or as a column, has the vector's size. */
export type SquareBeside<Self extends Shape<1, Size>> = SquareOf<RowsOf<Self>>
export type Transposed<Self extends Shape<Size, Size>> = MatrixOf<RowsOf<Self>, ColumnsOf<Self>>
/** A Jacobian, with one column for each component of the inputs. */
export type Jacobian<Value extends Shape<1, Size>, Inputs extends Shape<1, Size>> = MatrixOf<
  RowsOf<Inputs>,
  RowsOf<Value>
>

/** A function by component: returns a scalar for numbers, otherwise a vector. All vectors among the operands have its size. */
export interface ByComponent<Numbers extends unknown[]> {
  (...numbers: Numbers): Scalar
  <Value extends Scalar | Vector>(...operands: { [I in keyof Numbers]: Value | Numbers[I] }): Value
}

export type IfSquare<Self extends Shape<Size, Size>> =
  ColumnsOf<Self> extends RowsOf<Self> ? Self : never
