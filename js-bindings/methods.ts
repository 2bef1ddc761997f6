// Written by `npm run reference` from the tables of operations, src/ops/table.hpp and
// src/builder/compositions.hpp. What is not in them is in types.ts.
import type {
  ByComponent,
  Jacobian,
  MatrixProduct,
  Product,
  Quotient,
  Shape,
  Size,
  SquareBeside,
  Transposed,
} from './signatures.js'
import type {
  AnyMatrix,
  Expression,
  Mat2,
  Mat3,
  Mat4,
  Operand,
  Scalar,
  Vec3,
  Vector,
} from './types.js'

/** Of numbers, vectors and matrices. */
export interface AnyMethods<Self> {
  /** The product with a number. */
  scale(factor: Operand): Self
  /** The exact partial derivative of each component by an input. */
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
  /** The natural logarithm, of what is greater than 0. */
  log(): Self
  /** The logarithm to base 2, of what is greater than 0. */
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
  /** `x.acosh()`: The number from 0 up whose hyperbolic cosine is x, which is at least 1. */
  acosh(): Self
  /** `x.atanh()`: The number whose hyperbolic tangent is x, which is between -1 and 1. */
  atanh(): Self
  /** `x.abs()`: x without its sign. */
  abs(): Self
  /** -1, 0 or 1. */
  sign(): Self
  /** `x.floor()`: The whole number at or below x. */
  floor(): Self
  /** `x.ceil()`: The whole number at or above x. */
  ceil(): Self
  /** The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2. */
  round(): Self
  /** `x.trunc()`: x without what follows its point. */
  trunc(): Self
  /** `x.fract()`: x - floor(x) */
  fract(): Self
  /** `x.not()`: Whether x is false. */
  not(): Self
  /** `degrees.radians()`: An angle in degrees, as radians. */
  radians(): Self
  /** `radians.degrees()`: An angle in radians, as degrees. */
  degrees(): Self
}

/** Of numbers. A vector beside a number gives a vector. */
export interface ScalarMethods extends ComponentMethods<Scalar> {
  /** The sum of two or more. */
  add: ByComponent<Operand[], Expression>
  /** `x.sub(y, …)`: x - y, and minus all that follow. */
  sub: ByComponent<Operand[], Expression>
  /** The product of two or more; with a matrix, that of linear algebra. */
  mult: Product
  /** `x.div(y, …)`: x / y, and divided by all that follow. */
  div: ByComponent<Operand[]>
  /**
   * `x.pow(exponent)`: x to the power of the exponent. A whole number from -16 to 16 makes a
   * product, right for negative x too; with any other exponent, x must not be negative.
   */
  pow: ByComponent<[exponent: Operand]>
  /**
   * `x.atan()`: The angle from -π/2 to π/2 whose tangent is x. `y.atan(x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan: ByComponent<[x?: Operand]>
  /** `x.mod(divisor)`: x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod: ByComponent<[divisor: Operand]>
  /** The least of two or more. */
  min: ByComponent<Operand[]>
  /** The greatest of two or more. */
  max: ByComponent<Operand[]>
  /** `x.clamp(low, high)`: x, but not below low nor above high. */
  clamp: ByComponent<[low: Operand, high: Operand]>
  /** `x.mix(y, amount)`: From x where the amount is 0 to y where it is 1, and beyond. */
  mix: ByComponent<[y: Operand, amount: Operand], Expression>
  /** `edge.step(x)`: 0 where x is below the edge, otherwise 1. */
  step: ByComponent<[x: Operand]>
  /** `x.lt(y)`: x < y */
  lt: ByComponent<[y: Operand]>
  /** `x.le(y)`: x <= y */
  le: ByComponent<[y: Operand]>
  /** `x.gt(y)`: x > y */
  gt: ByComponent<[y: Operand]>
  /** `x.ge(y)`: x >= y */
  ge: ByComponent<[y: Operand]>
  /** `x.eq(y)`: x == y */
  eq: ByComponent<[y: Operand]>
  /** `x.ne(y)`: x != y */
  ne: ByComponent<[y: Operand]>
  /** Whether all are true. */
  and: ByComponent<Operand[]>
  /** Whether any is true. */
  or: ByComponent<Operand[]>
  /** One of two values; a number other than 0 counts as true. */
  ifElse: ByComponent<[yes: Operand, no: Operand], Expression>
  /**
   * `low.smoothstep(high, x)`: From 0 where x is at `low`, smoothly to 1 where it is at `high`,
   * another number.
   */
  smoothstep: ByComponent<[high: Operand, x: Operand]>
  /**
   * `angle.rotateX()`: The mat3 that turns by an angle in radians about the x axis,
   * counterclockwise for an eye that the axis points to.
   */
  rotateX(): Mat3
  /** The mat3 that turns about the y axis, as `rotateX` does. */
  rotateY(): Mat3
  /** The mat3 that turns about the z axis, as `rotateX` does. */
  rotateZ(): Mat3
  /** The exact derivatives of a number by each component of a vector of inputs. */
  gradient<Inputs extends Vector>(inputs: Inputs): Inputs
  /** Another name of `add`. */
  sum: ByComponent<Operand[], Expression>
  /** Another name of `mult`. */
  prod: Product
  /** Another name of `add`. */
  vecSum: ByComponent<Operand[], Expression>
  /** Another name of `mult`. */
  vecProd: Product
  /** Another name of `mix`. */
  vecMix: ByComponent<[y: Operand, amount: Operand], Expression>
  /** Another name of `clamp`. */
  vecClamp: ByComponent<[low: Operand, high: Operand]>
  /** Another name of `min`. */
  vecMin: ByComponent<Operand[]>
  /** Another name of `max`. */
  vecMax: ByComponent<Operand[]>
  /** Another name of `ifElse`. */
  vecIfElse: ByComponent<[yes: Operand, no: Operand], Expression>
}

/** Of vectors. A number beside a vector counts for each component. */
export interface VectorMethods<Self extends Shape<1, Size>> extends ComponentMethods<Self> {
  /** The sum of two or more. */
  add(...others: (Self | Operand)[]): Self
  /** `x.sub(y, …)`: x - y, and minus all that follow. */
  sub(...others: (Self | Operand)[]): Self
  /** The product of two or more; with a matrix, that of linear algebra. */
  mult(...factors: (Self | SquareBeside<Self> | Operand)[]): Self
  /** `x.div(y, …)`: x / y, and divided by all that follow. */
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
  mod(divisor: Self | Operand): Self
  /** The least of two or more. */
  min(...others: (Self | Operand)[]): Self
  /** The greatest of two or more. */
  max(...others: (Self | Operand)[]): Self
  /** `x.clamp(low, high)`: x, but not below low nor above high. */
  clamp(low: Self | Operand, high: Self | Operand): Self
  /** `x.mix(y, amount)`: From x where the amount is 0 to y where it is 1, and beyond. */
  mix(y: Self | Operand, amount: Self | Operand): Self
  /** `edge.step(x)`: 0 where x is below the edge, otherwise 1. */
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
  /** Whether all are true. */
  and(...others: (Self | Operand)[]): Self
  /** Whether any is true. */
  or(...others: (Self | Operand)[]): Self
  /** One of two values; a number other than 0 counts as true. */
  ifElse(yes: Self | Operand, no: Self | Operand): Self
  /** The dot product. */
  dot(b: Self): Scalar
  /** The length; its derivative at zero counts as zero. */
  length(): Scalar
  /** The distance of two points. */
  dist(b: Self): Scalar
  /** The distance of two points. */
  distance(b: Self): Scalar
  /** Length 1 in the same direction, or zero for zero. */
  normalize(): Self
  /** A direction mirrored by the surface with that unit normal. */
  reflect(normal: Self): Self
  /**
   * A unit direction behind the surface with that unit normal, for a ratio of indices of
   * refraction; zero where all light is reflected.
   */
  refract(normal: Self, eta: Operand): Self
  /**
   * `normal.faceforward(incident, reference)`: The normal, turned round where `incident` goes
   * along `reference`.
   */
  faceforward(incident: Self, reference: Self): Self
  /**
   * `low.smoothstep(high, x)`: From 0 where x is at `low`, smoothly to 1 where it is at `high`,
   * another number.
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
  cross(b: Vec3): Vec3
  /** `axis.rotate(angle)`: The mat3 that turns about any axis, as `rotateX` does. */
  rotate(angle: Operand): Mat3
  /**
   * `offset.adjustNormal(normal, position)`: The unit normal after the warp of `position` by
   * this offset; zero where there is none.
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
  /** `x.sub(y, …)`: x - y, and minus all that follow. */
  sub(...others: (Self | Operand)[]): Self
  /** The product of two or more; with a matrix, that of linear algebra. */
  mult: MatrixProduct<Self>
  /** `x.div(y, …)`: x / y, and divided by all that follow. */
  div(...divisors: Operand[]): Self
  /** `x.mix(y, amount)`: From x where the amount is 0 to y where it is 1, and beyond. */
  mix(y: Self | Operand, amount: Self | Operand): Self
  /** One of two values; a number other than 0 counts as true. */
  ifElse(yes: Self | Operand, no: Self | Operand): Self
  /** Rows become columns. */
  transpose(): Transposed<Self>
  /** Another name of `add`. */
  sum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  prod: MatrixProduct<Self>
  /** Another name of `add`. */
  vecSum(...others: (Self | Operand)[]): Self
  /** Another name of `mult`. */
  vecProd: MatrixProduct<Self>
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
  neg: ByComponent<[x: Operand], Expression>
  /** The sum of two or more. */
  add: ByComponent<Operand[], Expression>
  /** x - y, and minus all that follow. */
  sub: ByComponent<Operand[], Expression>
  /** The product of two or more; with a matrix, that of linear algebra. */
  mult: Product
  /** x / y, and divided by all that follow. */
  div: Quotient
  /**
   * x to the power of the exponent. A whole number from -16 to 16 makes a product, right for
   * negative x too; with any other exponent, x must not be negative.
   */
  pow: ByComponent<[x: Operand, exponent: Operand]>
  /** The square root; its derivative at 0 counts as 0. */
  sqrt: ByComponent<[x: Operand]>
  /** 1 / sqrt(x) */
  inversesqrt: ByComponent<[x: Operand]>
  /** e to the power of x. */
  exp: ByComponent<[x: Operand]>
  /** 2 to the power of x. */
  exp2: ByComponent<[x: Operand]>
  /** The natural logarithm, of what is greater than 0. */
  log: ByComponent<[x: Operand]>
  /** The logarithm to base 2, of what is greater than 0. */
  log2: ByComponent<[x: Operand]>
  /** The sine of an angle in radians. */
  sin: ByComponent<[x: Operand]>
  /** The cosine of an angle in radians. */
  cos: ByComponent<[x: Operand]>
  /** The tangent of an angle in radians. */
  tan: ByComponent<[x: Operand]>
  /** The angle from -π/2 to π/2 whose sine is x, which is from -1 to 1. */
  asin: ByComponent<[x: Operand]>
  /** The angle from 0 to π whose cosine is x, which is from -1 to 1. */
  acos: ByComponent<[x: Operand]>
  /**
   * `atan(x)`: The angle from -π/2 to π/2 whose tangent is x. `atan(y, x)`: The angle of the
   * point (x, y), from -π to π.
   */
  atan: ByComponent<[y: Operand, x?: Operand]>
  /** The hyperbolic sine. */
  sinh: ByComponent<[x: Operand]>
  /** The hyperbolic cosine. */
  cosh: ByComponent<[x: Operand]>
  /** The hyperbolic tangent, between -1 and 1. */
  tanh: ByComponent<[x: Operand]>
  /** The number whose hyperbolic sine is x. */
  asinh: ByComponent<[x: Operand]>
  /** The number from 0 up whose hyperbolic cosine is x, which is at least 1. */
  acosh: ByComponent<[x: Operand]>
  /** The number whose hyperbolic tangent is x, which is between -1 and 1. */
  atanh: ByComponent<[x: Operand]>
  /** x without its sign. */
  abs: ByComponent<[x: Operand]>
  /** -1, 0 or 1. */
  sign: ByComponent<[x: Operand]>
  /** The whole number at or below x. */
  floor: ByComponent<[x: Operand]>
  /** The whole number at or above x. */
  ceil: ByComponent<[x: Operand]>
  /** The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2. */
  round: ByComponent<[x: Operand]>
  /** x without what follows its point. */
  trunc: ByComponent<[x: Operand]>
  /** x - floor(x) */
  fract: ByComponent<[x: Operand]>
  /** x - divisor * floor(x / divisor), which has the sign of the divisor. */
  mod: ByComponent<[x: Operand, divisor: Operand]>
  /** The least of two or more. */
  min: ByComponent<Operand[]>
  /** The greatest of two or more. */
  max: ByComponent<Operand[]>
  /** x, but not below low nor above high. */
  clamp: ByComponent<[x: Operand, low: Operand, high: Operand]>
  /** From x where the amount is 0 to y where it is 1, and beyond. */
  mix: ByComponent<[x: Operand, y: Operand, amount: Operand], Expression>
  /** 0 where x is below the edge, otherwise 1. */
  step: ByComponent<[edge: Operand, x: Operand]>
  /** x < y */
  lt: ByComponent<[x: Operand, y: Operand]>
  /** x <= y */
  le: ByComponent<[x: Operand, y: Operand]>
  /** x > y */
  gt: ByComponent<[x: Operand, y: Operand]>
  /** x >= y */
  ge: ByComponent<[x: Operand, y: Operand]>
  /** x == y */
  eq: ByComponent<[x: Operand, y: Operand]>
  /** x != y */
  ne: ByComponent<[x: Operand, y: Operand]>
  /** Whether all are true. */
  and: ByComponent<Operand[]>
  /** Whether any is true. */
  or: ByComponent<Operand[]>
  /** Whether x is false. */
  not: ByComponent<[x: Operand]>
  /** One of two values; a number other than 0 counts as true. */
  ifElse: ByComponent<[condition: Operand, yes: Operand, no: Operand], Expression>
  /** The dot product. */
  dot<Value extends Vector>(a: Value, b: Value): Scalar
  /** The cross product. */
  cross(a: Vec3, b: Vec3): Vec3
  /** The length; its derivative at zero counts as zero. */
  length(v: Vector): Scalar
  /** The distance of two points. */
  dist<Value extends Vector>(a: Value, b: Value): Scalar
  /** The distance of two points. */
  distance<Value extends Vector>(a: Value, b: Value): Scalar
  /** Length 1 in the same direction, or zero for zero. */
  normalize<Value extends Vector>(v: Value): Value
  /** The product with a number. */
  scale<Value extends Expression>(v: Value, factor: Operand): Value
  /** A direction mirrored by the surface with that unit normal. */
  reflect<Value extends Vector>(incident: Value, normal: Value): Value
  /**
   * A unit direction behind the surface with that unit normal, for a ratio of indices of
   * refraction; zero where all light is reflected.
   */
  refract<Value extends Vector>(incident: Value, normal: Value, eta: Operand): Value
  /** The normal, turned round where `incident` goes along `reference`. */
  faceforward<Value extends Vector>(normal: Value, incident: Value, reference: Value): Value
  /** From 0 where x is at `low`, smoothly to 1 where it is at `high`, another number. */
  smoothstep: ByComponent<[low: Operand, high: Operand, x: Operand]>
  /** An angle in degrees, as radians. */
  radians: ByComponent<[degrees: Operand]>
  /** An angle in radians, as degrees. */
  degrees: ByComponent<[radians: Operand]>
  /** Rows become columns. */
  transpose<Value extends AnyMatrix>(m: Value): Transposed<Value>
  /** The determinant. */
  determinant(m: Mat2 | Mat3 | Mat4): Scalar
  /** The inverse; infinite or NaN where the determinant is 0. */
  inverse<Value extends Mat2 | Mat3 | Mat4>(m: Value): Value
  /**
   * The mat3 that turns by an angle in radians about the x axis, counterclockwise for an eye
   * that the axis points to.
   */
  rotateX(angle: Operand): Mat3
  /** The mat3 that turns about the y axis, as `rotateX` does. */
  rotateY(angle: Operand): Mat3
  /** The mat3 that turns about the z axis, as `rotateX` does. */
  rotateZ(angle: Operand): Mat3
  /** The mat3 that turns about any axis, as `rotateX` does. */
  rotate(axis: Vec3, angle: Operand): Mat3
  /** The exact partial derivative of each component by an input. */
  derivative<Value extends Expression>(value: Value, input: Scalar): Value
  /** The exact derivatives of a number by each component of a vector of inputs. */
  gradient<Inputs extends Vector>(value: Operand, inputs: Inputs): Inputs
  /**
   * The exact derivatives of a vector: a matrix with a column for each component of a vector of
   * inputs.
   */
  jacobian<Value extends Vector, Inputs extends Vector>(
    value: Value,
    inputs: Inputs,
  ): Jacobian<Value, Inputs>
  /** The unit normal after the warp of `position` by this offset; zero where there is none. */
  adjustNormal(offset: Vec3, normal: Vec3, position: Vec3): Vec3
  /**
   * The unit tangent after the warp of `position` by this offset, at right angles to `normal`,
   * the one after the warp.
   */
  adjustTangent(offset: Vec3, tangent: Vec3, normal: Vec3, position: Vec3): Vec3
  /** Another name of `add`. */
  sum: ByComponent<Operand[], Expression>
  /** Another name of `mult`. */
  prod: Product
  /** Another name of `add`. */
  vecSum: ByComponent<Operand[], Expression>
  /** Another name of `mult`. */
  vecProd: Product
  /** Another name of `mix`. */
  vecMix: ByComponent<[x: Operand, y: Operand, amount: Operand], Expression>
  /** Another name of `clamp`. */
  vecClamp: ByComponent<[x: Operand, low: Operand, high: Operand]>
  /** Another name of `min`. */
  vecMin: ByComponent<Operand[]>
  /** Another name of `max`. */
  vecMax: ByComponent<Operand[]>
  /** Another name of `ifElse`. */
  vecIfElse: ByComponent<[condition: Operand, yes: Operand, no: Operand], Expression>
}
