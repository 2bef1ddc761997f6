// Written by `npm run reference` from the tables of operations: src/ops/declarations.hpp, src/ops/documentation.hpp and
// src/builder/compositions.hpp. Everything else is in types.ts.
import type {
  ColumnsOf,
  IfSquare,
  Jacobian,
  MatrixOf,
  RowsOf,
  Shape,
  Size,
  SquareBeside,
  Transposed,
  VectorOf,
} from './signatures.js'
import type {
  AnyMatrix,
  Expression,
  Mat2,
  Mat3,
  Mat4,
  Operand,
  Scalar,
  Vec2,
  Vec3,
  Vec4,
  Vector,
} from './types.js'

/** Of numbers, vectors and matrices. */
export interface AnyMethods<Self> {
  /** The vector times a number. */
  scale(factor: Operand): Self
  /** The exact partial derivative of each component with respect to an input. */
  derivative(input: Scalar): Self
}

/** Of numbers and vectors, by component. */
export interface ComponentMethods<Self> extends AnyMethods<Self> {
  /** `x.neg()`: -x */
  neg(): Self
  /** The square root; its derivative at 0 counts as 0. */
  sqrt(): Self
  /** `x.inversesqrt()`: 1 / sqrt(x) */
  inversesqrt(): Self
  /** `x.exp()`: e to the power of x. */
  exp(): Self
  /** `x.exp2()`: 2 to the power of x. */
  exp2(): Self
  /** `x.log()`: The natural logarithm of x, which must be greater than 0. */
  log(): Self
  /** `x.log2()`: The base-2 logarithm of x, which must be greater than 0. */
  log2(): Self
  /** The sine of an angle in radians. */
  sin(): Self
  /** The cosine of an angle in radians. */
  cos(): Self
  /** The tangent of an angle in radians. */
  tan(): Self
  /** `x.asin()`: The angle from -π/2 to π/2 whose sine is x, which is from -1 to 1. */
  asin(): Self
  /** `x.acos()`: The angle from 0 to π whose cosine is x, which is from -1 to 1. */
  acos(): Self
  /** The hyperbolic sine. */
  sinh(): Self
  /** The hyperbolic cosine. */
  cosh(): Self
  /** The hyperbolic tangent, between -1 and 1. */
  tanh(): Self
  /** `x.asinh()`: The number whose hyperbolic sine is x. */
  asinh(): Self
  /** `x.acosh()`: The nonnegative number whose hyperbolic cosine is x, which is at least 1. */
  acosh(): Self
  /** `x.atanh()`: The number whose hyperbolic tangent is x, which is between -1 and 1. */
  atanh(): Self
  /** `x.abs()`: The absolute value of x. */
  abs(): Self
  /** -1, 0 or 1. */
  sign(): Self
  /** `x.floor()`: The whole number at or below x. */
  floor(): Self
  /** `x.ceil()`: The whole number at or above x. */
  ceil(): Self
  /** The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2. */
  round(): Self
  /** `x.trunc()`: x without its fractional part. */
  trunc(): Self
  /** `x.fract()`: x - floor(x) */
  fract(): Self
  /** `x.not()`: True if x is false. */
  not(): Self
  /** `degrees.radians()`: An angle in degrees, as radians. */
  radians(): Self
  /** `radians.degrees()`: An angle in radians, as degrees. */
  degrees(): Self
}

/** Of numbers. A vector and a number give a vector. */
export interface ScalarMethods extends ComponentMethods<Scalar> {
  /** The sum of two or more. */
  add(...operands: Operand[]): Scalar
  /** The sum of two or more. */
  add<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** `x.sub(y, …)`: x - y, minus all further operands. */
  sub(...operands: Operand[]): Scalar
  /** `x.sub(y, …)`: x - y, minus all further operands. */
  sub<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...numbers: Operand[]): Scalar
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** `x.div(y, …)`: x / y, divided by all further operands. */
  div(...numbers: Operand[]): Scalar
  /** `x.div(y, …)`: x / y, divided by all further operands. */
  div<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /**
   * `x.pow(exponent)`: x to the power of the exponent. A whole number from -16 to 16 makes a
   * product, right for negative x too; with any other exponent, x must not be negative.
   */
  pow(exponent: Operand): Scalar
  /**
   * `x.pow(exponent)`: x to the power of the exponent. A whole number from -16 to 16 makes a
   * product, right for negative x too; with any other exponent, x must not be negative.
   */
  pow<Value extends Scalar | Vector>(exponent: Value | Operand): Value
  /**
   * `x.atan()`: The angle from -π/2 to π/2 whose tangent is x. `y.atan(x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan(x?: Operand): Scalar
  /**
   * `x.atan()`: The angle from -π/2 to π/2 whose tangent is x. `y.atan(x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan<Value extends Scalar | Vector>(x?: Value | Operand): Value
  /** `x.mod(divisor)`: x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod(divisor: Operand): Scalar
  /** `x.mod(divisor)`: x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod<Value extends Scalar | Vector>(divisor: Value | Operand): Value
  /** The smallest of two or more. */
  min(...operands: Operand[]): Scalar
  /** The smallest of two or more. */
  min<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** The largest of two or more. */
  max(...operands: Operand[]): Scalar
  /** The largest of two or more. */
  max<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** `x.clamp(low, high)`: x, limited to the range from low to high. */
  clamp(low: Operand, high: Operand): Scalar
  /** `x.clamp(low, high)`: x, limited to the range from low to high. */
  clamp<Value extends Scalar | Vector>(low: Value | Operand, high: Value | Operand): Value
  /**
   * `x.mix(y, amount)`: The blend from x, where the amount is 0, to y, where it is 1;
   * extrapolates beyond.
   */
  mix(y: Operand, amount: Operand): Scalar
  /**
   * `x.mix(y, amount)`: The blend from x, where the amount is 0, to y, where it is 1;
   * extrapolates beyond.
   */
  mix<Value extends Expression>(y: Value | Operand, amount: Value | Operand): Value
  /** `edge.step(x)`: 0 if x is below the edge, otherwise 1. */
  step(x: Operand): Scalar
  /** `edge.step(x)`: 0 if x is below the edge, otherwise 1. */
  step<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** `x.lt(y)`: x < y */
  lt(y: Operand): Scalar
  /** `x.lt(y)`: x < y */
  lt<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** `x.le(y)`: x <= y */
  le(y: Operand): Scalar
  /** `x.le(y)`: x <= y */
  le<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** `x.gt(y)`: x > y */
  gt(y: Operand): Scalar
  /** `x.gt(y)`: x > y */
  gt<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** `x.ge(y)`: x >= y */
  ge(y: Operand): Scalar
  /** `x.ge(y)`: x >= y */
  ge<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** `x.eq(y)`: x == y */
  eq(y: Operand): Scalar
  /** `x.eq(y)`: x == y */
  eq<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** `x.ne(y)`: x != y */
  ne(y: Operand): Scalar
  /** `x.ne(y)`: x != y */
  ne<Value extends Scalar | Vector>(y: Value | Operand): Value
  /** True if all are true. */
  and(...operands: Operand[]): Scalar
  /** True if all are true. */
  and<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** True if any is true. */
  or(...operands: Operand[]): Scalar
  /** True if any is true. */
  or<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /**
   * `condition.ifElse(yes, no)`: `yes` if the condition is true, otherwise `no`; a nonzero
   * number counts as true.
   */
  ifElse(yes: Operand, no: Operand): Scalar
  /**
   * `condition.ifElse(yes, no)`: `yes` if the condition is true, otherwise `no`; a nonzero
   * number counts as true.
   */
  ifElse<Value extends Expression>(yes: Value | Operand, no: Value | Operand): Value
  /**
   * `low.smoothstep(high, x)`: A smooth step from 0 for x at `low` to 1 for x at `high`, which
   * must differ.
   */
  smoothstep(high: Operand, x: Operand): Scalar
  /**
   * `low.smoothstep(high, x)`: A smooth step from 0 for x at `low` to 1 for x at `high`, which
   * must differ.
   */
  smoothstep<Value extends Scalar | Vector>(high: Value | Operand, x: Value | Operand): Value
  /**
   * `angle.rotateX()`: The mat3 that rotates by an angle in radians about the x axis,
   * counterclockwise when the axis points at the viewer.
   */
  rotateX(): Mat3
  /** The mat3 that rotates about the y axis, like `rotateX`. */
  rotateY(): Mat3
  /** The mat3 that rotates about the z axis, like `rotateX`. */
  rotateZ(): Mat3
  /** The exact derivatives of a number with respect to a vector of inputs. */
  gradient<Inputs extends Vector>(inputs: Inputs): Inputs
  /** Another name of `add`. */
  sum(...operands: Operand[]): Scalar
  /** Another name of `add`. */
  sum<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  prod(...numbers: Operand[]): Scalar
  /** Another name of `mult`. */
  prod<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  prod(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** Another name of `mult`. */
  prod(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** Another name of `mult`. */
  prod(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** Another name of `mult`. */
  prod<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** Another name of `mult`. */
  prod<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** Another name of `mult`. */
  prod<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** Another name of `mult`. */
  prod<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** Another name of `mult`. */
  prod<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** Another name of `add`. */
  vecSum(...operands: Operand[]): Scalar
  /** Another name of `add`. */
  vecSum<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  vecProd(...numbers: Operand[]): Scalar
  /** Another name of `mult`. */
  vecProd<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(
    ...factors: (Value | Operand)[]
  ): Value
  /** Another name of `mult`. */
  vecProd(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** Another name of `mult`. */
  vecProd(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** Another name of `mult`. */
  vecProd(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** Another name of `mult`. */
  vecProd<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** Another name of `mult`. */
  vecProd<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** Another name of `mult`. */
  vecProd<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** Another name of `mult`. */
  vecProd<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** Another name of `mult`. */
  vecProd<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** Another name of `mix`. */
  vecMix(y: Operand, amount: Operand): Scalar
  /** Another name of `mix`. */
  vecMix<Value extends Expression>(y: Value | Operand, amount: Value | Operand): Value
  /** Another name of `clamp`. */
  vecClamp(low: Operand, high: Operand): Scalar
  /** Another name of `clamp`. */
  vecClamp<Value extends Scalar | Vector>(low: Value | Operand, high: Value | Operand): Value
  /** Another name of `min`. */
  vecMin(...operands: Operand[]): Scalar
  /** Another name of `min`. */
  vecMin<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** Another name of `max`. */
  vecMax(...operands: Operand[]): Scalar
  /** Another name of `max`. */
  vecMax<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** Another name of `ifElse`. */
  vecIfElse(yes: Operand, no: Operand): Scalar
  /** Another name of `ifElse`. */
  vecIfElse<Value extends Expression>(yes: Value | Operand, no: Value | Operand): Value
}

/** Of vectors. A number is used for each component. */
export interface VectorMethods<Self extends Shape<1, Size>> extends ComponentMethods<Self> {
  /** The sum of two or more. */
  add(...others: (Self | Operand)[]): Self
  /** `x.sub(y, …)`: x - y, minus all further operands. */
  sub(...others: (Self | Operand)[]): Self
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Self | SquareBeside<Self> | Operand)[]): Self
  /** `x.div(y, …)`: x / y, divided by all further operands. */
  div(...others: (Self | Operand)[]): Self
  /**
   * `x.pow(exponent)`: x to the power of the exponent. A whole number from -16 to 16 makes a
   * product, right for negative x too; with any other exponent, x must not be negative.
   */
  pow(exponent: Self | Operand): Self
  /**
   * `x.atan()`: The angle from -π/2 to π/2 whose tangent is x. `y.atan(x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan(x?: Self | Operand): Self
  /** `x.mod(divisor)`: x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod(...given: [divisor: Self | Operand] | [x: Operand, y: Operand, ...zw: Operand[]]): Self
  /** The smallest of two or more. */
  min(...others: (Self | Operand)[]): Self
  /** The largest of two or more. */
  max(...others: (Self | Operand)[]): Self
  /** `x.clamp(low, high)`: x, limited to the range from low to high. */
  clamp(low: Self | Operand, high: Self | Operand): Self
  /**
   * `x.mix(y, amount)`: The blend from x, where the amount is 0, to y, where it is 1;
   * extrapolates beyond.
   */
  mix(
    ...given:
      [y: Self | Operand, amount: Self | Operand] | [x: Operand, y: Operand, ...others: Operand[]]
  ): Self
  /** `edge.step(x)`: 0 if x is below the edge, otherwise 1. */
  step(x: Self | Operand): Self
  /** `x.lt(y)`: x < y */
  lt(y: Self | Operand): Self
  /** `x.le(y)`: x <= y */
  le(y: Self | Operand): Self
  /** `x.gt(y)`: x > y */
  gt(y: Self | Operand): Self
  /** `x.ge(y)`: x >= y */
  ge(y: Self | Operand): Self
  /** `x.eq(y)`: x == y */
  eq(y: Self | Operand): Self
  /** `x.ne(y)`: x != y */
  ne(y: Self | Operand): Self
  /** True if all are true. */
  and(...others: (Self | Operand)[]): Self
  /** True if any is true. */
  or(...others: (Self | Operand)[]): Self
  /**
   * `condition.ifElse(yes, no)`: `yes` if the condition is true, otherwise `no`; a nonzero
   * number counts as true.
   */
  ifElse(yes: Self | Operand, no: Self | Operand): Self
  /** The dot product. */
  dot(...given: [b: Self] | [x: Operand, y: Operand, ...zw: Operand[]]): Scalar
  /** The length; its derivative at zero is defined as zero. */
  length(): Scalar
  /** The distance between two points. */
  dist(...given: [b: Self] | [x: Operand, y: Operand, ...zw: Operand[]]): Scalar
  /** The distance between two points. */
  distance(...given: [b: Self] | [x: Operand, y: Operand, ...zw: Operand[]]): Scalar
  /** The unit vector in the same direction; zero for the zero vector. */
  normalize(): Self
  /** The direction reflected by a surface with that unit normal. */
  reflect(normal: Self): Self
  /**
   * The direction refracted by a surface with that unit normal, for a ratio of indices of
   * refraction; zero in case of total internal reflection.
   */
  refract(normal: Self, eta: Operand): Self
  /**
   * `normal.faceforward(incident, reference)`: The normal, reversed if `incident` points along
   * `reference`.
   */
  faceforward(incident: Self, reference: Self): Self
  /**
   * `low.smoothstep(high, x)`: A smooth step from 0 for x at `low` to 1 for x at `high`, which
   * must differ.
   */
  smoothstep(high: Self | Operand, x: Self | Operand): Self
  /**
   * The exact derivatives of a vector: a matrix with a column for each component of a vector of
   * inputs.
   */
  jacobian<Inputs extends Vector>(inputs: Inputs): Jacobian<Self, Inputs>
  /** Another name of `add`. */
  sum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  prod(...factors: (Self | SquareBeside<Self> | Operand)[]): Self
  /** Another name of `add`. */
  vecSum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  vecProd(...factors: (Self | SquareBeside<Self> | Operand)[]): Self
  /** Another name of `mix`. */
  vecMix(y: Self | Operand, amount: Self | Operand): Self
  /** Another name of `clamp`. */
  vecClamp(low: Self | Operand, high: Self | Operand): Self
  /** Another name of `min`. */
  vecMin(...others: (Self | Operand)[]): Self
  /** Another name of `max`. */
  vecMax(...others: (Self | Operand)[]): Self
  /** Another name of `ifElse`. */
  vecIfElse(yes: Self | Operand, no: Self | Operand): Self
}

export interface Vec3Methods {
  /** The cross product. */
  cross(...given: [b: Vec3] | [x: Operand, y: Operand, ...zw: Operand[]]): Vec3
  /** `axis.rotate(angle)`: The mat3 that rotates about any axis, like `rotateX`. */
  rotate(angle: Operand): Mat3
  /**
   * `offset.adjustNormal(normal, position)`: The unit normal after the warp of `position` by
   * this offset; zero where it has none.
   */
  adjustNormal(normal: Vec3, position: Vec3): Vec3
  /**
   * `offset.adjustTangent(tangent, normal, position)`: The unit tangent after the warp of
   * `position` by this offset, at right angles to `normal`, the one after the warp.
   */
  adjustTangent(tangent: Vec3, normal: Vec3, position: Vec3): Vec3
}

export interface MatrixMethods<Self extends Shape<Size, Size>> extends AnyMethods<Self> {
  /** `x.neg()`: -x */
  neg(): Self
  /** The sum of two or more. */
  add(...others: (Self | Operand)[]): Self
  /** `x.sub(y, …)`: x - y, minus all further operands. */
  sub(...others: (Self | Operand)[]): Self
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (IfSquare<Self> | Operand)[]): Self
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (IfSquare<Self> | VectorOf<ColumnsOf<Self>> | Operand)[]): VectorOf<RowsOf<Self>>
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Columns extends Size>(
    matrix: Shape<Columns, ColumnsOf<Self>>,
  ): MatrixOf<Columns, RowsOf<Self>>
  /** `x.div(y, …)`: x / y, divided by all further operands. */
  div(...divisors: Operand[]): Self
  /**
   * `x.mix(y, amount)`: The blend from x, where the amount is 0, to y, where it is 1;
   * extrapolates beyond.
   */
  mix(y: Self | Operand, amount: Self | Operand): Self
  /**
   * `condition.ifElse(yes, no)`: `yes` if the condition is true, otherwise `no`; a nonzero
   * number counts as true.
   */
  ifElse(yes: Self | Operand, no: Self | Operand): Self
  /** The transposed matrix. */
  transpose(): Transposed<Self>
  /** Another name of `add`. */
  sum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  prod(...factors: (IfSquare<Self> | Operand)[]): Self
  /** Another name of `mult`. */
  prod(...factors: (IfSquare<Self> | VectorOf<ColumnsOf<Self>> | Operand)[]): VectorOf<RowsOf<Self>>
  /** Another name of `mult`. */
  prod<Columns extends Size>(
    matrix: Shape<Columns, ColumnsOf<Self>>,
  ): MatrixOf<Columns, RowsOf<Self>>
  /** Another name of `add`. */
  vecSum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  vecProd(...factors: (IfSquare<Self> | Operand)[]): Self
  /** Another name of `mult`. */
  vecProd(
    ...factors: (IfSquare<Self> | VectorOf<ColumnsOf<Self>> | Operand)[]
  ): VectorOf<RowsOf<Self>>
  /** Another name of `mult`. */
  vecProd<Columns extends Size>(
    matrix: Shape<Columns, ColumnsOf<Self>>,
  ): MatrixOf<Columns, RowsOf<Self>>
  /** Another name of `mix`. */
  vecMix(y: Self | Operand, amount: Self | Operand): Self
  /** Another name of `ifElse`. */
  vecIfElse(yes: Self | Operand, no: Self | Operand): Self
}

/** Of matrices of as many rows as columns. */
export interface SquareMethods<Self> {
  /** The determinant. */
  determinant(): Scalar
  /** The inverse; infinite or NaN where the determinant is 0. */
  inverse(): Self
}

/** Of the builder `glsl`. */
export interface Functions {
  /** -x */
  neg(x: Operand): Scalar
  /** -x */
  neg<Value extends Expression>(x: Value | Operand): Value
  /** The sum of two or more. */
  add(...operands: Operand[]): Scalar
  /** The sum of two or more. */
  add<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** x - y, minus all further operands. */
  sub(...operands: Operand[]): Scalar
  /** x - y, minus all further operands. */
  sub<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...numbers: Operand[]): Scalar
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** The product of two or more; with a matrix, the matrix product. */
  mult(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** The product of two or more; with a matrix, the matrix product. */
  mult<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** x / y, divided by all further operands. */
  div(...numbers: Operand[]): Scalar
  /** x / y, divided by all further operands. */
  div<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** x / y, divided by all further operands. */
  div<Value extends AnyMatrix>(matrix: Value, ...divisors: Operand[]): Value
  /**
   * x to the power of the exponent. A whole number from -16 to 16 makes a product, right for
   * negative x too; with any other exponent, x must not be negative.
   */
  pow(x: Operand, exponent: Operand): Scalar
  /**
   * x to the power of the exponent. A whole number from -16 to 16 makes a product, right for
   * negative x too; with any other exponent, x must not be negative.
   */
  pow<Value extends Scalar | Vector>(x: Value | Operand, exponent: Value | Operand): Value
  /** The square root; its derivative at 0 counts as 0. */
  sqrt(x: Operand): Scalar
  /** The square root; its derivative at 0 counts as 0. */
  sqrt<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** 1 / sqrt(x) */
  inversesqrt(x: Operand): Scalar
  /** 1 / sqrt(x) */
  inversesqrt<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** e to the power of x. */
  exp(x: Operand): Scalar
  /** e to the power of x. */
  exp<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** 2 to the power of x. */
  exp2(x: Operand): Scalar
  /** 2 to the power of x. */
  exp2<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The natural logarithm of x, which must be greater than 0. */
  log(x: Operand): Scalar
  /** The natural logarithm of x, which must be greater than 0. */
  log<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The base-2 logarithm of x, which must be greater than 0. */
  log2(x: Operand): Scalar
  /** The base-2 logarithm of x, which must be greater than 0. */
  log2<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The sine of an angle in radians. */
  sin(x: Operand): Scalar
  /** The sine of an angle in radians. */
  sin<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The cosine of an angle in radians. */
  cos(x: Operand): Scalar
  /** The cosine of an angle in radians. */
  cos<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The tangent of an angle in radians. */
  tan(x: Operand): Scalar
  /** The tangent of an angle in radians. */
  tan<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The angle from -π/2 to π/2 whose sine is x, which is from -1 to 1. */
  asin(x: Operand): Scalar
  /** The angle from -π/2 to π/2 whose sine is x, which is from -1 to 1. */
  asin<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The angle from 0 to π whose cosine is x, which is from -1 to 1. */
  acos(x: Operand): Scalar
  /** The angle from 0 to π whose cosine is x, which is from -1 to 1. */
  acos<Value extends Scalar | Vector>(x: Value | Operand): Value
  /**
   * `atan(x)`: The angle from -π/2 to π/2 whose tangent is x. `atan(y, x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan(y: Operand, x?: Operand): Scalar
  /**
   * `atan(x)`: The angle from -π/2 to π/2 whose tangent is x. `atan(y, x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan<Value extends Scalar | Vector>(y: Value | Operand, x?: Value | Operand): Value
  /** The hyperbolic sine. */
  sinh(x: Operand): Scalar
  /** The hyperbolic sine. */
  sinh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The hyperbolic cosine. */
  cosh(x: Operand): Scalar
  /** The hyperbolic cosine. */
  cosh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The hyperbolic tangent, between -1 and 1. */
  tanh(x: Operand): Scalar
  /** The hyperbolic tangent, between -1 and 1. */
  tanh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The number whose hyperbolic sine is x. */
  asinh(x: Operand): Scalar
  /** The number whose hyperbolic sine is x. */
  asinh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The nonnegative number whose hyperbolic cosine is x, which is at least 1. */
  acosh(x: Operand): Scalar
  /** The nonnegative number whose hyperbolic cosine is x, which is at least 1. */
  acosh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The number whose hyperbolic tangent is x, which is between -1 and 1. */
  atanh(x: Operand): Scalar
  /** The number whose hyperbolic tangent is x, which is between -1 and 1. */
  atanh<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The absolute value of x. */
  abs(x: Operand): Scalar
  /** The absolute value of x. */
  abs<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** -1, 0 or 1. */
  sign(x: Operand): Scalar
  /** -1, 0 or 1. */
  sign<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The whole number at or below x. */
  floor(x: Operand): Scalar
  /** The whole number at or below x. */
  floor<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The whole number at or above x. */
  ceil(x: Operand): Scalar
  /** The whole number at or above x. */
  ceil<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2. */
  round(x: Operand): Scalar
  /** The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2. */
  round<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** x without its fractional part. */
  trunc(x: Operand): Scalar
  /** x without its fractional part. */
  trunc<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** x - floor(x) */
  fract(x: Operand): Scalar
  /** x - floor(x) */
  fract<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod(x: Operand, divisor: Operand): Scalar
  /** x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod<Value extends Scalar | Vector>(x: Value | Operand, divisor: Value | Operand): Value
  /** The smallest of two or more. */
  min(...operands: Operand[]): Scalar
  /** The smallest of two or more. */
  min<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** The largest of two or more. */
  max(...operands: Operand[]): Scalar
  /** The largest of two or more. */
  max<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** x, limited to the range from low to high. */
  clamp(x: Operand, low: Operand, high: Operand): Scalar
  /** x, limited to the range from low to high. */
  clamp<Value extends Scalar | Vector>(
    x: Value | Operand,
    low: Value | Operand,
    high: Value | Operand,
  ): Value
  /** The blend from x, where the amount is 0, to y, where it is 1; extrapolates beyond. */
  mix(x: Operand, y: Operand, amount: Operand): Scalar
  /** The blend from x, where the amount is 0, to y, where it is 1; extrapolates beyond. */
  mix<Value extends Expression>(
    x: Value | Operand,
    y: Value | Operand,
    amount: Value | Operand,
  ): Value
  /** 0 if x is below the edge, otherwise 1. */
  step(edge: Operand, x: Operand): Scalar
  /** 0 if x is below the edge, otherwise 1. */
  step<Value extends Scalar | Vector>(edge: Value | Operand, x: Value | Operand): Value
  /** x < y */
  lt(x: Operand, y: Operand): Scalar
  /** x < y */
  lt<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** x <= y */
  le(x: Operand, y: Operand): Scalar
  /** x <= y */
  le<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** x > y */
  gt(x: Operand, y: Operand): Scalar
  /** x > y */
  gt<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** x >= y */
  ge(x: Operand, y: Operand): Scalar
  /** x >= y */
  ge<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** x == y */
  eq(x: Operand, y: Operand): Scalar
  /** x == y */
  eq<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** x != y */
  ne(x: Operand, y: Operand): Scalar
  /** x != y */
  ne<Value extends Scalar | Vector>(x: Value | Operand, y: Value | Operand): Value
  /** True if all are true. */
  and(...operands: Operand[]): Scalar
  /** True if all are true. */
  and<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** True if any is true. */
  or(...operands: Operand[]): Scalar
  /** True if any is true. */
  or<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** True if x is false. */
  not(x: Operand): Scalar
  /** True if x is false. */
  not<Value extends Scalar | Vector>(x: Value | Operand): Value
  /** `yes` if the condition is true, otherwise `no`; a nonzero number counts as true. */
  ifElse(condition: Operand, yes: Operand, no: Operand): Scalar
  /** `yes` if the condition is true, otherwise `no`; a nonzero number counts as true. */
  ifElse<Value extends Expression>(
    condition: Value | Operand,
    yes: Value | Operand,
    no: Value | Operand,
  ): Value
  /** The dot product. */
  dot<Value extends Vector>(a: Value, b: Value): Scalar
  /** The cross product. */
  cross(a: Vec3, b: Vec3): Vec3
  /** The length; its derivative at zero is defined as zero. */
  length(v: Vector): Scalar
  /** The distance between two points. */
  dist<Value extends Vector>(a: Value, b: Value): Scalar
  /** The distance between two points. */
  distance<Value extends Vector>(a: Value, b: Value): Scalar
  /** The unit vector in the same direction; zero for the zero vector. */
  normalize<Value extends Vector>(v: Value): Value
  /** The vector times a number. */
  scale<Value extends Expression>(v: Value, factor: Operand): Value
  /** The direction reflected by a surface with that unit normal. */
  reflect<Value extends Vector>(incident: Value, normal: Value): Value
  /**
   * The direction refracted by a surface with that unit normal, for a ratio of indices of
   * refraction; zero in case of total internal reflection.
   */
  refract<Value extends Vector>(incident: Value, normal: Value, eta: Operand): Value
  /** The normal, reversed if `incident` points along `reference`. */
  faceforward<Value extends Vector>(normal: Value, incident: Value, reference: Value): Value
  /** A smooth step from 0 for x at `low` to 1 for x at `high`, which must differ. */
  smoothstep(low: Operand, high: Operand, x: Operand): Scalar
  /** A smooth step from 0 for x at `low` to 1 for x at `high`, which must differ. */
  smoothstep<Value extends Scalar | Vector>(
    low: Value | Operand,
    high: Value | Operand,
    x: Value | Operand,
  ): Value
  /** An angle in degrees, as radians. */
  radians(degrees: Operand): Scalar
  /** An angle in degrees, as radians. */
  radians<Value extends Scalar | Vector>(degrees: Value | Operand): Value
  /** An angle in radians, as degrees. */
  degrees(radians: Operand): Scalar
  /** An angle in radians, as degrees. */
  degrees<Value extends Scalar | Vector>(radians: Value | Operand): Value
  /** The transposed matrix. */
  transpose<Value extends AnyMatrix>(m: Value): Transposed<Value>
  /** The determinant. */
  determinant(m: Mat2 | Mat3 | Mat4): Scalar
  /** The inverse; infinite or NaN where the determinant is 0. */
  inverse<Value extends Mat2 | Mat3 | Mat4>(m: Value): Value
  /**
   * The mat3 that rotates by an angle in radians about the x axis, counterclockwise when the
   * axis points at the viewer.
   */
  rotateX(angle: Operand): Mat3
  /** The mat3 that rotates about the y axis, like `rotateX`. */
  rotateY(angle: Operand): Mat3
  /** The mat3 that rotates about the z axis, like `rotateX`. */
  rotateZ(angle: Operand): Mat3
  /** The mat3 that rotates about any axis, like `rotateX`. */
  rotate(axis: Vec3, angle: Operand): Mat3
  /** The exact partial derivative of each component with respect to an input. */
  derivative<Value extends Expression>(value: Value, input: Scalar): Value
  /** The exact derivatives of a number with respect to a vector of inputs. */
  gradient<Inputs extends Vector>(value: Operand, inputs: Inputs): Inputs
  /**
   * The exact derivatives of a vector: a matrix with a column for each component of a vector of
   * inputs.
   */
  jacobian<Value extends Vector, Inputs extends Vector>(
    value: Value,
    inputs: Inputs,
  ): Jacobian<Value, Inputs>
  /** The unit normal after the warp of `position` by this offset; zero where it has none. */
  adjustNormal(offset: Vec3, normal: Vec3, position: Vec3): Vec3
  /**
   * The unit tangent after the warp of `position` by this offset, at right angles to `normal`,
   * the one after the warp.
   */
  adjustTangent(offset: Vec3, tangent: Vec3, normal: Vec3, position: Vec3): Vec3
  /** Another name of `add`. */
  sum(...operands: Operand[]): Scalar
  /** Another name of `add`. */
  sum<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  prod(...numbers: Operand[]): Scalar
  /** Another name of `mult`. */
  prod<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  prod(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** Another name of `mult`. */
  prod(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** Another name of `mult`. */
  prod(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** Another name of `mult`. */
  prod<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** Another name of `mult`. */
  prod<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** Another name of `mult`. */
  prod<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** Another name of `mult`. */
  prod<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** Another name of `mult`. */
  prod<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** Another name of `add`. */
  vecSum(...operands: Operand[]): Scalar
  /** Another name of `add`. */
  vecSum<Value extends Expression>(...operands: (Value | Operand)[]): Value
  /** Another name of `mult`. */
  vecProd(...numbers: Operand[]): Scalar
  /** Another name of `mult`. */
  vecProd<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(
    ...factors: (Value | Operand)[]
  ): Value
  /** Another name of `mult`. */
  vecProd(...factors: (Vec2 | Mat2 | Operand)[]): Vec2
  /** Another name of `mult`. */
  vecProd(...factors: (Vec3 | Mat3 | Operand)[]): Vec3
  /** Another name of `mult`. */
  vecProd(...factors: (Vec4 | Mat4 | Operand)[]): Vec4
  /** Another name of `mult`. */
  vecProd<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value
  /** Another name of `mult`. */
  vecProd<Value extends AnyMatrix>(number: Operand, matrix: Value): Value
  /** Another name of `mult`. */
  vecProd<Left extends AnyMatrix>(
    matrix: Left,
    vector: VectorOf<ColumnsOf<Left>>,
  ): VectorOf<RowsOf<Left>>
  /** Another name of `mult`. */
  vecProd<Right extends AnyMatrix>(
    vector: VectorOf<RowsOf<Right>>,
    matrix: Right,
  ): VectorOf<ColumnsOf<Right>>
  /** Another name of `mult`. */
  vecProd<Left extends AnyMatrix, Columns extends Size>(
    left: Left,
    right: Shape<Columns, ColumnsOf<Left>>,
  ): MatrixOf<Columns, RowsOf<Left>>
  /** Another name of `mix`. */
  vecMix(x: Operand, y: Operand, amount: Operand): Scalar
  /** Another name of `mix`. */
  vecMix<Value extends Expression>(
    x: Value | Operand,
    y: Value | Operand,
    amount: Value | Operand,
  ): Value
  /** Another name of `clamp`. */
  vecClamp(x: Operand, low: Operand, high: Operand): Scalar
  /** Another name of `clamp`. */
  vecClamp<Value extends Scalar | Vector>(
    x: Value | Operand,
    low: Value | Operand,
    high: Value | Operand,
  ): Value
  /** Another name of `min`. */
  vecMin(...operands: Operand[]): Scalar
  /** Another name of `min`. */
  vecMin<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** Another name of `max`. */
  vecMax(...operands: Operand[]): Scalar
  /** Another name of `max`. */
  vecMax<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value
  /** Another name of `ifElse`. */
  vecIfElse(condition: Operand, yes: Operand, no: Operand): Scalar
  /** Another name of `ifElse`. */
  vecIfElse<Value extends Expression>(
    condition: Value | Operand,
    yes: Value | Operand,
    no: Value | Operand,
  ): Value
}
