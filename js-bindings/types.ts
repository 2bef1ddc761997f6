// The types that a sketch sees. At run time every expression is one class; see expression.ts. Operations come from the
// tables, by way of methods.ts; what is no operation is here.
//
// Every method throws a `WarpError` for an argument that is no finite number or expression of the same warp, for vectors
// of different sizes, and where constants give no finite result.
// What derivatives are at kinks is said at the top of src/ops/table.hpp, and for artists in web/docs/operations.md.
import type {
  Functions,
  MatrixMethods,
  ScalarMethods,
  SquareMethods,
  Vec3Methods,
  VectorMethods,
} from './methods.js'
import type { CurlMethod, FieldMethods, NoiseFunctions, NoiseMethods } from './noise-types.js'
import type { ByComponent, MatrixOf, Shape, Size, VectorOf } from './signatures.js'

/** An expression of one number a vertex. A condition is one too: 1 or 0 where it is used as a number. */
export interface Scalar extends Shape<1, 1>, ScalarMethods, NoiseMethods, Results {}

export interface Vec2
  extends Shape<1, 2>, VectorMethods<Vec2>, NoiseMethods, Results, XY, RG, ST, UV {}

export interface Vec3
  extends
    Shape<1, 3>,
    VectorMethods<Vec3>,
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
    FieldMethods,
    CurlMethod,
    Results,
    XYZW,
    RGBA,
    STPQ,
    UV {}

/** Of different numbers of columns and rows, as some Jacobians are; GLSL's matCxR. WebGL 1 has none. */
export interface Matrix<Columns extends Size, Rows extends Size>
  extends Shape<Columns, Rows>, MatrixMethods<MatrixOf<Columns, Rows>>, Results {
  /** The column of this number, from 0. */
  column(index: number): VectorOf<Rows>
  /** The row of this number, from 0. */
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
  /** In `gen` alone: writes this expression into a shader variable of that name. */
  output(name: string): void
  /** In `gen` alone: writes the partial derivative by an input, such as `x` or `position.y()`. */
  outputDeriv(name: string, input: Scalar): void
}

/** All selections of one to four components, such as `x()`, `zy()` and `xxx()`. */
type Swizzles<Letter extends string> = { [Name in Letter]: () => Scalar } & {
  [Name in `${Letter}${Letter}`]: () => Vec2
} & { [Name in `${Letter}${Letter}${Letter}`]: () => Vec3 } & {
  [Name in `${Letter}${Letter}${Letter}${Letter}`]: () => Vec4
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

type Parts = (Scalar | Vector | number)[]

interface FromColumns<Self, Column> {
  /** A matrix from numbers, which go down the columns; from one number, it stands on the diagonal. */
  (...numbers: Operand[]): Self
  /** A matrix from its columns. */
  (...columns: Column[]): Self
  /** A matrix from one of another size, cut off or filled up with ones on the diagonal. */
  (matrix: AnyMatrix): Self
}

interface FromRows<Self, Row> {
  /** A matrix from numbers, which go along the rows; from one number, it stands on the diagonal. */
  (...numbers: Operand[]): Self
  /** A matrix from its rows. */
  (...rows: Row[]): Self
}

/** `glsl`: inputs, constants, and every operation as a function. */
export interface Glsl extends Functions, NoiseFunctions {
  /** A float of the shader, by its name there or the expression that reads it. */
  param(name: string): Scalar
  /** A vec2 of the shader, by its name there or the expression that reads it. */
  vec2Param(name: string): Vec2
  /** A vec3 of the shader, by its name there or the expression that reads it. */
  vec3Param(name: string): Vec3
  /** A vec4 of the shader, by its name there or the expression that reads it. */
  vec4Param(name: string): Vec4
  /** A mat2 of the shader, by its name there or the expression that reads it. */
  mat2Param(name: string): Mat2
  /** A mat3 of the shader, by its name there or the expression that reads it. */
  mat3Param(name: string): Mat3
  /** A mat4 of the shader, by its name there or the expression that reads it. */
  mat4Param(name: string): Mat4
  /** A constant, as an expression. */
  val(value: number): Scalar
  /** A vec2 from numbers and smaller vectors, or from one number for all components. */
  vec2(...parts: Parts): Vec2
  /** A vec3 from numbers and smaller vectors, or from one number for all components. */
  vec3(...parts: Parts): Vec3
  /** A vec4 from numbers and smaller vectors, or from one number for all components. */
  vec4(...parts: Parts): Vec4
  mat2: FromColumns<Mat2, Vec2>
  mat3: FromColumns<Mat3, Vec3>
  mat4: FromColumns<Mat4, Vec4>
  mat2Rows: FromRows<Mat2, Vec2>
  mat3Rows: FromRows<Mat3, Vec3>
  mat4Rows: FromRows<Mat4, Vec4>
  /** The column of a matrix, by its number from 0. */
  column<C extends Size, R extends Size>(matrix: Shape<C, R>, index: number): VectorOf<R>
  /** The row of a matrix, by its number from 0. */
  row<C extends Size, R extends Size>(matrix: Shape<C, R>, index: number): VectorOf<C>
  /**
   * The colour of an image at `uv`, from (0, 0) to (1, 1) across it, v down: red, green, blue and alpha. `sampler` is the
   * image among `uniforms`, or the name of the shader's image: a `uniform sampler2D`, in WGSL a `texture_2d<f32>` variable, which your shader declares.
   * `glsl100`, WebGL 1's language, cannot ask for its size: declare `uniform vec2 heightMapSize` too, in texels, for a
   * `heightMap`. Works in the vertex and in the fragment stage, and only on the GPU.
   *
   * It reads texels and mixes them itself, so that its derivatives are exactly those of what it gives, whatever filter is
   * set for the image; mipmaps are not read.
   */
  texture(sampler: ImageName, uv: Vec2, options?: TextureOptions): Vec4
  /** A function of your own, in the shader's language; used like a built-in one. */
  fn<Arity extends FunctionArity>(options: FunctionOptions<Arity>): OwnFunction<Arity>
}

/** What `glsl.texture` takes. */
export interface TextureOptions {
  /**
   * How it goes on between the centres of texels.
   * - `'bilinear'` unless given: the mix of four texels. Its slope jumps at every row and column of texels, and so does light.
   * - `'bicubic'`, of 16 texels: goes through the texels without such jumps, and a little beyond them beside edges (the
   *   Catmull-Rom spline; Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2).
   * - `'bspline'`, of 16 texels: smooths the image by about a texel, and is smooth up to its second derivatives; for
   *   heights of 8 bits and for light that shows no texels (the uniform cubic B-spline; Sigg and Hadwiger, "Fast
   *   Third-Order Texture Filtering", GPU Gems 2, chapter 20, 2005).
   */
  filter?: 'bilinear' | 'bicubic' | 'bspline'
  /** Beyond 0 and 1: the colour of the edge (`'clamp'` unless given), the image again, or its mirror image. */
  wrap?: 'clamp' | 'repeat' | 'mirror'
}

export type FunctionArity = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9 | 10 | 11 | 12 | 13 | 14 | 15 | 16

/** What `glsl.fn` takes. */
export interface FunctionOptions<Arity extends FunctionArity> {
  /** As the source has it. */
  name: string
  /** The text of the function, from floats to a float, with all that it calls. An object if the same sketch is compiled
   * for both languages. */
  source: string | { glsl?: string; wgsl?: string }
  /** How many floats the function takes. */
  arity: Arity
  /** The partial derivatives, one by each argument. Only needed where something is derived, as a warp's normal is. */
  derivatives?: Readonly<Arguments<FunctionDerivative<Arity>, Arity>>
}

/** What `glsl.fn` gives. TypeScript wants it written out where a derivative calls the function itself:
 * `const bump: OwnFunction<1> = glsl.fn({ … })`. */
export type OwnFunction<Arity extends FunctionArity> = ByComponent<Arguments<Operand, Arity>>

/** A number, an expression, or a function of all arguments that gives one, such as another `glsl.fn`. */
export type FunctionDerivative<Arity extends FunctionArity> =
  Operand | ((...numbers: Arguments<Scalar, Arity>) => Operand)

type Arguments<Item, Arity, List extends Item[] = []> = List['length'] extends Arity
  ? List
  : Arguments<Item, Arity, [...List, Item]>

/** The value of a uniform: a float (`true` is 1), a vec2 to vec4 or, column by column, a mat3 or mat4. A p5.Vector is a
 * vec3 and a p5.Color a vec4 with numbers from 0 to 1; an image is for `glsl.texture`. */
export type UniformValue =
  | number
  | boolean
  | readonly [number, number]
  | readonly [number, number, number]
  | readonly [number, number, number, number]
  | ArrayLike<number>
  | VectorLike
  | ColorLike
  | ImageLike

/** A p5.Vector, or another with these. */
export interface VectorLike {
  readonly x: number
  readonly y: number
  readonly z: number
}

/** A p5.Color. */
export interface ColorLike {
  setAlpha(alpha: number): unknown
}

/** A p5.Image, p5.Graphics, p5.Framebuffer or video, for `glsl.texture`; only p5's createWarp can show it to the shader. */
export interface ImageLike {
  readonly width: number
  readonly height: number
}

export type UniformValues = Readonly<Record<string, UniformValue>>

/** The option `uniforms`: by name a value, or a function that gives it, which is asked again whenever the warp is used. */
export type UniformOptions<Values extends UniformValues = UniformValues> = {
  [Name in keyof Values]: Values[Name] | (() => Values[Name])
}

/** What the offset function gets for a value; an array of which TypeScript does not know the length may be any. */
export type UniformExpression<Value> = Value extends number | boolean
  ? Scalar
  : Value extends ImageLike
    ? ImageName
    : Value extends { readonly length: infer Length }
      ? number extends Length
        ? Vector | Mat3 | Mat4
        : OfLength<Length>
      : Value extends ColorLike
        ? Vec4
        : Vec3

/** An image among the uniforms, as `glsl.texture` takes it: the shader's name of it. */
export type ImageName = string

type OfLength<Length> = Length extends 2 | 3 | 4
  ? VectorOf<Length>
  : Length extends 9
    ? Mat3
    : Length extends 16
      ? Mat4
      : never

/** What the offset function gets as `uniforms`. */
export type UniformExpressions<Values> = {
  readonly [Name in keyof Values]: UniformExpression<Values[Name]>
}

/** What a call may give in place of the declared values. */
export type UniformOverrides<Values> = {
  readonly [Name in keyof Values]?: UniformExpression<Values[Name]> extends Scalar
    ? number | boolean
    : UniformExpression<Values[Name]> extends ImageName
      ? ImageLike
      : ArrayLike<number> | VectorLike | ColorLike
}

/** What an offset function is given. */
export interface WarpInputs<Uniforms extends UniformValues = {}> {
  /** By the names of the option `uniforms`; reading another one throws. */
  uniforms: UniformExpressions<Uniforms>
  glsl: Glsl
  /** The vertex, in the space of the warp. */
  position: Vec3
  /** The vertex's normal as the mesh has it, usually of length 1. That it varies over the surface, as `uv` does, counts
   * where the mesh says how (`surfaceVariation` of 'warpjet/mesh'); `color` counts as constant. */
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
export type OffsetFunction<Uniforms extends UniformValues = {}> = (
  inputs: WarpInputs<Uniforms>,
) => Vec3
