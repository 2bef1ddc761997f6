// What the generated methods and functions are typed with. `types.ts` names the expressions.
import type {
  AnyMatrix,
  Expression,
  Mat2,
  Mat3,
  Mat4,
  Matrix,
  Operand,
  Scalar,
  Vec2,
  Vec3,
  Vec4,
  Vector,
} from './types.js'

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

type ColumnsOf<Self extends Shape<Size, Size>> = Self[typeof shape][0]
type RowsOf<Self extends Shape<number, Size>> = Self[typeof shape][1]

/** The matrices by which a vector, as a row or as a column, keeps its size. */
export type SquareBeside<Self extends Shape<1, Size>> = SquareOf<RowsOf<Self>>
export type Transposed<Self extends Shape<Size, Size>> = MatrixOf<RowsOf<Self>, ColumnsOf<Self>>
/** A column for each component of the inputs, as GLSL's matCxR. */
export type Jacobian<Value extends Shape<1, Size>, Inputs extends Shape<1, Size>> = MatrixOf<
  RowsOf<Inputs>,
  RowsOf<Value>
>

/**
 * A function by component, or such a method of a scalar: a scalar of numbers, otherwise a vector
 * (or a matrix, if `Wide` allows it); those among the operands all have its size.
 */
export interface ByComponent<Numbers extends unknown[], Wide extends Expression = Scalar | Vector> {
  (...numbers: Numbers): Scalar
  <Value extends Wide>(...operands: { [I in keyof Numbers]: Value | Numbers[I] }): Value
}

/** `glsl.div`: a matrix divides nothing. */
export interface Quotient extends ByComponent<Operand[]> {
  <Value extends AnyMatrix>(matrix: Value, ...divisors: Operand[]): Value
}

/** `glsl.mult`, and `mult` of a scalar. From left to right a vector among square matrices stays one. */
export interface Product {
  (...numbers: Operand[]): Scalar
  <Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value
  (...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  (...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  (...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  <Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  <Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  <Left extends AnyMatrix>(matrix: Left, vector: VectorOf<ColumnsOf<Left>>): VectorOf<RowsOf<Left>>
  <Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  <Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
}

/** `mult` of a matrix. */
export interface MatrixProduct<Self extends Shape<Size, Size>> {
  (...factors: (IfSquare<Self> | Operand)[]): Self
  (...factors: (IfSquare<Self> | VectorOf<ColumnsOf<Self>> | Operand)[]): VectorOf<RowsOf<Self>>
  <Columns extends Size>(matrix: Shape<Columns, ColumnsOf<Self>>): MatrixOf<Columns, RowsOf<Self>>
}

type IfSquare<Self extends Shape<Size, Size>> = ColumnsOf<Self> extends RowsOf<Self> ? Self : never
