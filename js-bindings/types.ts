// The types that a sketch sees. At run time every expression is one class; see expression.ts.
//
// Every method throws a `WarpError` for an argument that is no finite number or expression of the same
// warp, for vectors of different sizes, and where constants give no finite result.
//
// Derivatives at kinks: that of abs at 0 is 0; floor, sign, step and comparisons have 0; fract has 1;
// min, max, clamp and ifElse have that of the branch taken; sqrt, length, dist and normalize have 0 at 0,
// as have pow at 0, asin and acos at 1 and -1, and atan at the origin.

/** An expression of one number a vertex. A vector beside it gives a vector. */
export interface Scalar extends Methods<Scalar, Operand, ScalarChain>, Results {
  /** Without an argument the arc tangent; with one the angle of the point (x, this), in radians. */
  atan(x?: Operand): Scalar
  mix: ScalarMix
  /** One of two values; a number other than 0 counts as true. */
  ifElse<Value extends Expression = Scalar>(yes: Value | number, no: Value | number): Value
  vecIfElse<Value extends Vector>(yes: Value, no: Value): Value
  and(...conditions: Scalar[]): Scalar
  or(...conditions: Scalar[]): Scalar
  not(): Scalar
}

export interface Vec2 extends VectorMethods<Vec2>, XY, RG, ST {}

export interface Vec3 extends VectorMethods<Vec3>, XYZ, RGB, STP {
  cross(other: Vec3): Vec3
  /** The unit normal after the warp of `position` by this offset; zero where there is none. */
  adjustNormal(normal: Vec3, position: Vec3): Vec3
}

export interface Vec4 extends VectorMethods<Vec4>, XYZW, RGBA, STPQ {}

export type Vector = Vec2 | Vec3 | Vec4
export type Expression = Scalar | Vector
export type Operand = Scalar | number

interface Results {
  /** Writes this expression into a shader variable of that name. */
  output(name: string): void
  /** Writes the partial derivative by an input, such as `x` or `position.y()`. */
  outputDeriv(name: string, input: Scalar): void
}

interface ScalarChain {
  (...others: Operand[]): Scalar
  <Value extends Vector>(...others: (Value | Operand)[]): Value
}

interface ScalarMix {
  (other: Operand, amount: Operand): Scalar
  <Value extends Vector>(other: Value, amount: Value | Operand): Value
}

/** Methods of scalars, and of vectors by component. Angles are in radians. */
interface Methods<Self, Other, Chain> {
  neg(): Self
  add: Chain
  sub: Chain
  mult: Chain
  div: Chain
  min: Chain
  max: Chain
  /** this - divisor * floor(this / divisor): has the sign of the divisor. */
  mod(divisor: Other): Self
  /** A whole exponent from -16 to 16 is a product, right for negative numbers too; with any other
   * exponent this must not be negative. */
  pow(exponent: Other): Self
  sqrt(): Self
  inversesqrt(): Self
  exp(): Self
  /** The natural logarithm, of what is greater than 0. */
  log(): Self
  sin(): Self
  cos(): Self
  tan(): Self
  asin(): Self
  acos(): Self
  atan(): Self
  abs(): Self
  /** -1, 0 or 1. */
  sign(): Self
  floor(): Self
  fract(): Self
  /** `low` must not be above `high`. */
  clamp(low: Other, high: Other): Self
  /** 0 where `x` is below this edge, otherwise 1. */
  step(x: Other): Self
  /** From 0 where `x` is at this edge, smoothly to 1 where it is at `high`, a different number. */
  smoothstep(high: Other, x: Other): Self
  radians(): Self
  degrees(): Self
  /** Comparisons are conditions for `ifElse`; as numbers they are 1 and 0. */
  lt(other: Other): Self
  le(other: Other): Self
  gt(other: Other): Self
  ge(other: Other): Self
  eq(other: Other): Self
  ne(other: Other): Self
}

interface VectorMethods<Self> extends Methods<Self, Self | Operand, VectorChain<Self>>, Results {
  mix(other: Self | Operand, amount: Self | Operand): Self
  /** The product with a single number. */
  scale(factor: Operand): Self
  dot(other: Self): Scalar
  length(): Scalar
  dist(other: Self): Scalar
  distance(other: Self): Scalar
  /** Length 1, or 0 where this is zero. */
  normalize(): Self
}

type VectorChain<Self> = (...others: (Self | Operand)[]) => Self

/** All selections of one to four components, such as `x()`, `zy()` and `xxx()`. */
type Swizzles<Letter extends string> = { [Name in Letter]: () => Scalar } & {
  [Name in `${Letter}${Letter}`]: () => Vec2
} & { [Name in `${Letter}${Letter}${Letter}`]: () => Vec3 } & {
  [Name in `${Letter}${Letter}${Letter}${Letter}`]: () => Vec4
}

interface XY extends Swizzles<'x' | 'y'> {}
interface RG extends Swizzles<'r' | 'g'> {}
interface ST extends Swizzles<'s' | 't'> {}
interface XYZ extends Swizzles<'x' | 'y' | 'z'> {}
interface RGB extends Swizzles<'r' | 'g' | 'b'> {}
interface STP extends Swizzles<'s' | 't' | 'p'> {}
interface XYZW extends Swizzles<'x' | 'y' | 'z' | 'w'> {}
interface RGBA extends Swizzles<'r' | 'g' | 'b' | 'a'> {}
interface STPQ extends Swizzles<'s' | 't' | 'p' | 'q'> {}

type Parts = (Expression | number)[]

/** `glsl`: inputs, constants, and every operation as a function. */
export interface Glsl {
  /** A float of the shader, by its name or the expression that reads it there. */
  param(name: string): Scalar
  vec2Param(name: string): Vec2
  vec3Param(name: string): Vec3
  vec4Param(name: string): Vec4
  val(value: number): Scalar
  /** From numbers and smaller vectors, or from one number for all components. */
  vec2(...parts: Parts): Vec2
  vec3(...parts: Parts): Vec3
  vec4(...parts: Parts): Vec4
  /** The exact partial derivative of each component by an input, such as `millis` or `position.x()`. */
  derivative<Value extends Expression>(value: Value, input: Scalar): Value

  neg: Unary
  sqrt: Unary
  inversesqrt: Unary
  exp: Unary
  log: Unary
  sin: Unary
  cos: Unary
  tan: Unary
  asin: Unary
  acos: Unary
  abs: Unary
  sign: Unary
  floor: Unary
  fract: Unary
  radians: Unary
  degrees: Unary
  atan(y: Operand, x?: Operand): Scalar
  add: Chain
  sub: Chain
  mult: Chain
  div: Chain
  min: Chain
  max: Chain
  sum: Chain
  prod: Chain
  pow: Binary
  mod: Binary
  step: Binary
  lt: Binary
  le: Binary
  gt: Binary
  ge: Binary
  eq: Binary
  ne: Binary
  clamp: Ternary
  mix: Ternary
  smoothstep: Ternary
  and(...conditions: Scalar[]): Scalar
  or(...conditions: Scalar[]): Scalar
  not(condition: Scalar): Scalar
  ifElse<Value extends Expression>(
    condition: Operand,
    yes: Value | number,
    no: Value | number,
  ): Value
  vecIfElse<Value extends Vector>(condition: Operand, yes: Value, no: Value): Value
  vecSum<Value extends Vector>(...vectors: Value[]): Value
  vecProd<Value extends Vector>(...vectors: Value[]): Value
  vecMin<Value extends Vector>(...vectors: Value[]): Value
  vecMax<Value extends Vector>(...vectors: Value[]): Value
  vecMix<Value extends Vector>(from: Value, to: Value, amount: Operand): Value
  vecClamp<Value extends Vector>(value: Value, low: Value, high: Value): Value
  scale<Value extends Vector>(vector: Value, factor: Operand): Value
  dot<Value extends Vector>(a: Value, b: Value): Scalar
  length(vector: Vector): Scalar
  dist<Value extends Vector>(a: Value, b: Value): Scalar
  distance<Value extends Vector>(a: Value, b: Value): Scalar
  normalize<Value extends Vector>(vector: Value): Value
  cross(a: Vec3, b: Vec3): Vec3
}

interface Unary {
  (x: Operand): Scalar
  <Value extends Vector>(x: Value): Value
}

interface Binary {
  (x: Operand, y: Operand): Scalar
  <Value extends Vector>(x: Value | Operand, y: Value | Operand): Value
}

interface Ternary {
  (x: Operand, y: Operand, z: Operand): Scalar
  <Value extends Vector>(x: Value | Operand, y: Value | Operand, z: Value | Operand): Value
}

interface Chain {
  (...operands: Operand[]): Scalar
  <Value extends Vector>(...operands: (Value | Operand)[]): Value
}

/** What an offset function is given. */
export interface WarpInputs {
  glsl: Glsl
  /** The vertex, in the space of the warp. */
  position: Vec3
  /** The vertex's normal as the mesh has it, usually of length 1. Its derivative counts as 0, as do
   * those of `uv` and `color`. */
  normal: Vec3
  /** Texture coordinates. */
  uv: Vec2
  /** Red, green, blue and alpha from 0 to 1: of the vertex if it has one, otherwise the fill. */
  color: Vec4
  /** Milliseconds since the sketch started. */
  millis: Scalar
  /** The mouse in pixels from the canvas' top left corner, as p5's mouseX and mouseY. */
  mouse: Vec2
  mouseX: Scalar
  mouseY: Scalar
  /** The canvas in pixels, as p5's width and height: not multiplied by pixelDensity. */
  size: Vec2
  width: Scalar
  height: Scalar
  pixelDensity: Scalar
}

/** From a vertex to the offset that moves it. Called once; loops and functions act as macros. */
export type OffsetFunction = (inputs: WarpInputs) => Vec3
