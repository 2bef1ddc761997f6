// The types of expressions. At run time all are one class; see expression.ts. The types of operations are in methods.ts, which is
// generated from the tables of operations; everything else is here.
//
// Every method throws a `WarpError` for an argument that is neither a finite number nor an expression of the same warp, for vectors
// of different sizes, and if the result of constants is not finite.
// The top of src/ops/table.hpp and, for artists, web/docs/operations.md define the derivatives at kinks.
import type { AliasesOf, MadeMethods, MadeVectorMethods, Vec2Methods } from './aliases.js'
import type {
  MatrixMethods,
  ScalarMethods,
  SquareMethods,
  Vec3Methods,
  VectorMethods,
} from './methods.js'
import type { CurlMethod, FieldMethods, NoiseMethods } from './noise.js'
import type { MatrixOf, Shape, Size, VectorOf } from './signatures.js'

/** An expression of one number. A condition is a scalar too: 1 or 0 where it is used as a number. */
export interface Scalar
  extends
    Shape<1, 1>,
    ScalarMethods,
    NoiseMethods,
    AliasesOf<ScalarMethods>,
    MadeMethods<Scalar>,
    Results {}

export interface Vec2
  extends
    Shape<1, 2>,
    VectorMethods<Vec2>,
    NoiseMethods,
    AliasesOf<VectorMethods<Vec2>>,
    Omit<MadeMethods<Vec2>, 'rem'>,
    MadeVectorMethods<Vec2>,
    Vec2Methods,
    Results,
    XY,
    RG,
    ST,
    UV {}

export interface Vec3
  extends
    Shape<1, 3>,
    VectorMethods<Vec3>,
    AliasesOf<VectorMethods<Vec3>>,
    Omit<MadeMethods<Vec3>, 'rem'>,
    MadeVectorMethods<Vec3>,
    Vec3Methods,
    NoiseMethods,
    CurlMethod,
    Results,
    XYZ,
    RGB,
    STP,
    UV {}

export interface Vec4
  extends
    Shape<1, 4>,
    VectorMethods<Vec4>,
    AliasesOf<VectorMethods<Vec4>>,
    Omit<MadeMethods<Vec4>, 'rem'>,
    MadeVectorMethods<Vec4>,
    FieldMethods,
    CurlMethod,
    Results,
    XYZW,
    RGBA,
    STPQ,
    UV {}

/** A matrix, possibly with different numbers of columns and rows, as some Jacobians have: GLSL's matCxR, which WebGL 1 lacks. */
export interface Matrix<Columns extends Size, Rows extends Size>
  extends Shape<Columns, Rows>, MatrixMethods<MatrixOf<Columns, Rows>>, Results {
  /** The column with this index, from 0. */
  column(index: number): VectorOf<Rows>
  /** The row with this index, from 0. */
  row(index: number): VectorOf<Columns>
}

export interface Mat2 extends Matrix<2, 2>, SquareMethods<Mat2> {}
export interface Mat3 extends Matrix<3, 3>, SquareMethods<Mat3> {}
export interface Mat4 extends Matrix<4, 4>, SquareMethods<Mat4> {}

export type Vector = Vec2 | Vec3 | Vec4
export type AnyMatrix = MatrixOf<Size, Size>
export type Expression = Scalar | Vector | AnyMatrix
export type Operand = Scalar | number

interface Results {
  /** Only in `gen`: writes this expression into a shader variable of that name. */
  output(name: string): void
  /** Only in `gen`: writes the partial derivative with respect to an input, such as `x` or `position.y()`, into a shader variable. */
  outputDeriv(name: string, input: Scalar): void
}

/** A component, which can be called: `v.y` and `v.y()` are the same. */
type Component<Value> = Value & (() => Value)

/** All selections of one to four components, such as `x`, `zy` and `xxx`. */
type Swizzles<Letter extends string> = { [Name in Letter]: Component<Scalar> } & {
  [Name in `${Letter}${Letter}`]: Component<Vec2>
} & { [Name in `${Letter}${Letter}${Letter}`]: Component<Vec3> } & {
  [Name in `${Letter}${Letter}${Letter}${Letter}`]: Component<Vec4>
}

interface XY extends Swizzles<'x' | 'y'> {}
interface RG extends Swizzles<'r' | 'g'> {}
interface ST extends Swizzles<'s' | 't'> {}
interface UV extends Swizzles<'u' | 'v'> {}
interface XYZ extends Swizzles<'x' | 'y' | 'z'> {}
interface RGB extends Swizzles<'r' | 'g' | 'b'> {}
interface STP extends Swizzles<'s' | 't' | 'p'> {}
interface XYZW extends Swizzles<'x' | 'y' | 'z' | 'w'> {}
interface RGBA extends Swizzles<'r' | 'g' | 'b' | 'a'> {}
interface STPQ extends Swizzles<'s' | 't' | 'p' | 'q'> {}
