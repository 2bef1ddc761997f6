// The types of `glsl`, the builder.
import type { AliasesOf, MadeFunctions } from './aliases.js'
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
} from './expressions.js'
import type { Functions } from './methods.js'
import type { NoiseFunctions } from './noise.js'
import type { ImageName } from './offset.js'
import type { ByComponent, Shape, Size, VectorOf } from './signatures.js'

type Parts = (Scalar | Vector | number)[]

interface FromColumns<Self, Column> {
  /** A matrix from numbers, column by column; one number fills the diagonal. */
  (...numbers: Operand[]): Self
  /** A matrix from its columns. */
  (...columns: Column[]): Self
  /** A matrix from one of another size, truncated, or extended with ones on the diagonal. */
  (matrix: AnyMatrix): Self
}

interface FromRows<Self, Row> {
  /** A matrix from numbers, row by row; one number fills the diagonal. */
  (...numbers: Operand[]): Self
  /** A matrix from its rows. */
  (...rows: Row[]): Self
}

/** `glsl`: inputs, constants, and every operation as a function. */
export interface Glsl extends Functions, NoiseFunctions, AliasesOf<Functions>, MadeFunctions {
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
  /** The column of a matrix with an index, from 0. */
  column<C extends Size, R extends Size>(matrix: Shape<C, R>, index: number): VectorOf<R>
  /** The row of a matrix with an index, from 0. */
  row<C extends Size, R extends Size>(matrix: Shape<C, R>, index: number): VectorOf<C>
  /**
   * The color of an image at `uv`: red, green, blue and alpha. `uv` is (0, 0) at the top left and (1, 1) at the bottom right.
   * `sampler` is the image among `uniforms`, or the name of an image that your shader declares: a `uniform sampler2D`, or in WGSL a
   * `texture_2d<f32>` variable. `glsl100`, WebGL 1's language, cannot query the size of an image: for a `heightMap`, also
   * declare `uniform vec2 heightMapSize`, in texels. Works in vertex and fragment shaders, and only on the GPU.
   *
   * It reads texels and filters them itself, so that its derivatives are exactly those of its values, whatever filter is set for
   * the image. It does not read mipmaps.
   */
  texture(sampler: ImageName, uv: Vec2, options?: TextureOptions): Vec4
  /**
   * Applies `body` to a state `count` times, as a loop of the shader. `body` is called once, with expressions of the state and of the
   * number of the step, from 0, and returns the next state, of the same shape. A state is a number, a vector, or an object of them.
   *
   *     const { z } = glsl.repeat(8, { z: position.xy() }, ({ z }, i) => ({ z: z.mult(1.1).add(i) }))
   *
   * Loops of JavaScript are unrolled in the shader. Use them for a few steps, or for steps that differ; use `repeat` for many steps
   * that are alike: the code stays short, and the shader compiles faster. `count` is a number, not an expression. It is at most
   * 10,000, as is the product of the counts of nested repeats; 0 returns the start.
   *
   * Throws a `WarpError` for another `count`, if `body` returns no state or one of another shape, and if an expression of the state
   * that `body` gets is used outside of `body`.
   */
  repeat<State extends RepeatState>(
    count: number,
    start: State,
    body: (state: RepeatExpressions<State>, i: Scalar) => RepeatNext<State>,
  ): RepeatExpressions<State>
  /**
   * Makes a function of GLSL source callable with numbers and expressions, with its exact derivatives. Import 'warpjet/glsl' first.
   * The function is `options.function`, or the one named `offset`, or the last one. `options.uniforms` has the values of the
   * source's uniforms: pass `uniforms`.
   *
   *     const ripple = glsl.source('float ripple(vec2 p, float t) { return sin(length(p) - t); }')
   *     ripple(position.xy(), millis)
   */
  source<Result extends Expression = Scalar>(
    source: string,
    options?: SourceOptions,
  ): (...operands: readonly (Operand | Expression)[]) => Result
  /** Declares a function in the shader's language, which can be called like a built-in one. */
  fn<Arity extends FunctionArity>(options: FunctionOptions<Arity>): OwnFunction<Arity>
}

type RepeatPart = Operand | Vector

/** The start of `glsl.repeat`: a number, a vector, or an object of them. */
export type RepeatState = RepeatPart | { readonly [name: string]: RepeatPart }

/** The type of a state inside the loop: a number with which it starts becomes an expression. */
type RepeatExpression<Part> = Part extends Operand ? Scalar : Part

/** The state that `glsl.repeat` passes to its function, and returns. */
export type RepeatExpressions<State extends RepeatState> = State extends RepeatPart
  ? RepeatExpression<State>
  : { [Name in keyof State]: RepeatExpression<State[Name]> }

/** The state that the function of `glsl.repeat` returns, which may contain numbers. */
export type RepeatNext<State extends RepeatState> = State extends RepeatPart
  ? RepeatNextPart<State>
  : { [Name in keyof State]: RepeatNextPart<State[Name]> }

type RepeatNextPart<Part> = Part extends Operand ? Operand : Part

/** The options of `glsl.source`. */
export interface SourceOptions {
  /** The name of the function. Default: `offset`, or the last function. */
  function?: string
  /** The number of iterations of a loop whose end only the shader knows. If this option is missing, such a loop throws. */
  maxIterations?: number
  /** The `uniforms` of an offset function. */
  uniforms?: object
}

/** The options of `glsl.texture`. */
export interface TextureOptions {
  /**
   * The interpolation between the centers of texels.
   * - `'bilinear'`, of 4 texels. Its slope jumps at every row and column of texels, and so does the lighting.
   * - `'bicubic'`, of 16 texels: passes through the texels without such jumps, and overshoots a little beside edges (the
   *   Catmull-Rom spline; Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2).
   * - `'bspline'`, of 16 texels: blurs the image by about a texel, and has continuous second derivatives; for heights of 8 bits and
   *   for lighting that does not show texels (the uniform cubic B-spline; Sigg and Hadwiger, "Fast
   *   Third-Order Texture Filtering", GPU Gems 2, chapter 20, 2005).
   * - `'nearest'`: the texel itself, for images that hold data. Its derivative is 0.
   *
   * Default: the magnification filter that the host has set for an image among the `uniforms` of `createWarp`, `warp` and
   * `BabylonWarp`, which is `'nearest'` or `'bilinear'`; for other images `'bilinear'`.
   */
  filter?: 'bilinear' | 'bicubic' | 'bspline' | 'nearest'
  /**
   * The color outside of the image: that of the edge, the image repeated, or mirrored. `'sampler'` uses the sampler of your own shader;
   * in WGSL, where an image has none, that is `'clamp'`.
   *
   * Default: the mode that the host has set for an image among the `uniforms` of `createWarp`, `warp` and `BabylonWarp`, such as by
   * p5's `textureWrap`; in GLSL source `'sampler'`; for other images `'clamp'`.
   */
  wrap?: 'clamp' | 'repeat' | 'mirror' | 'sampler'
  /**
   * If true, a texture of three.js or Babylon.js among the `uniforms` first transforms `uv` by its `offset`, `repeat` and `rotation`, or
   * by its matrix. `texture()` in GLSL source never does that.
   * @default true
   */
  transform?: boolean
}

export type FunctionArity = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9 | 10 | 11 | 12 | 13 | 14 | 15 | 16

/** The options of `glsl.fn`. */
export interface FunctionOptions<Arity extends FunctionArity> {
  /** The name of the function in the source. */
  name: string
  /** The source of the function, from floats to a float, and of all functions that it calls. To compile an offset for both languages,
   * pass an object with both sources. */
  source: string | { glsl?: string; wgsl?: string }
  /** The number of arguments. */
  arity: Arity
  /** The partial derivatives, one for each argument. Only needed where a derivative is taken, such as for a warp's normal. */
  derivatives?: Readonly<Arguments<FunctionDerivative<Arity>, Arity>>
}

/** The result of `glsl.fn`. TypeScript needs the annotation if a derivative calls the function itself:
 * `const bump: OwnFunction<1> = glsl.fn({ … })`. */
export type OwnFunction<Arity extends FunctionArity> = ByComponent<Arguments<Operand, Arity>>

/** A number, an expression, or a function of all arguments that returns one, such as another `glsl.fn`. */
export type FunctionDerivative<Arity extends FunctionArity> =
  Operand | ((...numbers: Arguments<Scalar, Arity>) => Operand)

type Arguments<Item, Arity, List extends Item[] = []> = List['length'] extends Arity
  ? List
  : Arguments<Item, Arity, [...List, Item]>
