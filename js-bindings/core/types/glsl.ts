// `glsl`, the builder, as a sketch sees it.
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
import type { AliasesOf, MadeFunctions } from './aliases.js'
import type { Functions } from './methods.js'
import type { NoiseFunctions } from './noise.js'
import type { ByComponent, Shape, Size, VectorOf } from './signatures.js'
import type { ImageName } from './offset.js'

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
  /**
   * What `body` makes of a state when it is applied to its own result so often, as a loop of the shader: `body` is called
   * once, with expressions of the state and of the step's number, from 0 on, and returns the next state of the same
   * shape. A state is a number, a vector, or an object of them.
   *
   *     const { z } = glsl.repeat(8, { z: position.xy() }, ({ z }, i) => ({ z: z.mult(1.1).add(i) }))
   *
   * JavaScript's own loops write their body into the shader as often as they run. Take those for a few steps, or
   * where steps differ; take `repeat` where many steps are alike: the text stays short, and the shader starts sooner. `count` is a
   * number of JavaScript, up to 10,000, those of repeats within each other multiplied; with 0, the start comes back.
   *
   * Throws a `WarpError` if `count` is no such number, if `body` returns no state or one of another shape, and where an
   * expression of its state is used after it is over.
   */
  repeat<State extends RepeatState>(
    count: number,
    start: State,
    body: (state: RepeatExpressions<State>, i: Scalar) => RepeatNext<State>,
  ): RepeatExpressions<State>
  /**
   * A function of a text in GLSL, to be called with numbers and expressions, with its exact derivatives; import
   * 'warpjet/glsl' for it. It is `options.function`, or the one named `offset`, or the last. What the text's uniforms are,
   * `options.uniforms` says: hand over `uniforms`.
   *
   *     const ripple = glsl.source('float ripple(vec2 p, float t) { return sin(length(p) - t); }')
   *     ripple(position.xy(), millis)
   */
  source<Result extends Expression = Scalar>(
    source: string,
    options?: SourceOptions,
  ): (...operands: readonly (Operand | Expression)[]) => Result
  /** A function of your own, in the shader's language; used like a built-in one. */
  fn<Arity extends FunctionArity>(options: FunctionOptions<Arity>): OwnFunction<Arity>
}

type RepeatPart = Operand | Vector

/** What `glsl.repeat` starts with: a number, a vector, or an object of them. */
export type RepeatState = RepeatPart | { readonly [name: string]: RepeatPart }

/** A number that a state starts as becomes an expression. */
type RepeatExpression<Part> = Part extends Operand ? Scalar : Part

/** The state as `glsl.repeat` hands it on. */
export type RepeatExpressions<State extends RepeatState> = State extends RepeatPart
  ? RepeatExpression<State>
  : { [Name in keyof State]: RepeatExpression<State[Name]> }

/** The state as the function of `glsl.repeat` returns it: of numbers too. */
export type RepeatNext<State extends RepeatState> = State extends RepeatPart
  ? RepeatNextPart<State>
  : { [Name in keyof State]: RepeatNextPart<State[Name]> }

type RepeatNextPart<Part> = Part extends Operand ? Operand : Part

/** What `glsl.source` takes. */
export interface SourceOptions {
  /** The name of the function. */
  function?: string
  /** How often a loop runs whose end depends on what only the shader knows; without it such a loop is refused. */
  maxIterations?: number
  /** As an offset function gets them. */
  uniforms?: object
}

/** What `glsl.texture` takes. */
export interface TextureOptions {
  /**
   * How it goes on between the centres of texels.
   * - `'bilinear'`: the mix of four texels. Its slope jumps at every row and column of texels, and so does light.
   * - `'bicubic'`, of 16 texels: goes through the texels without such jumps, and a little beyond them beside edges (the
   *   Catmull-Rom spline; Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2).
   * - `'bspline'`, of 16 texels: smooths the image by about a texel, and is smooth up to its second derivatives; for
   *   heights of 8 bits and for light that shows no texels (the uniform cubic B-spline; Sigg and Hadwiger, "Fast
   *   Third-Order Texture Filtering", GPU Gems 2, chapter 20, 2005).
   * - `'nearest'`: the texel itself, for images that hold data. Its derivative is 0.
   *
   * Default: for an image among the `uniforms` of `createWarp`, `warp` and `BabylonWarp` the magnification filter that the host
   * has set for it, `'nearest'` or `'bilinear'`; elsewhere `'bilinear'`.
   */
  filter?: 'bilinear' | 'bicubic' | 'bspline' | 'nearest'
  /**
   * Beyond 0 and 1: the colour of the edge, the image again, or its mirror image. `'sampler'` leaves it to the sampler of your own
   * shader; in WGSL, where an image has none, that is `'clamp'`.
   *
   * Default: for an image among the `uniforms` of `createWarp`, `warp` and `BabylonWarp` what the host has set for it, as by p5's
   * `textureWrap`; in GLSL that warpjet reads, `'sampler'`; elsewhere `'clamp'`.
   */
  wrap?: 'clamp' | 'repeat' | 'mirror' | 'sampler'
  /**
   * `false`: `uv` as it is. Otherwise a texture of three.js or Babylon.js among the `uniforms` moves, scales and rotates it first, by
   * its `offset`, `repeat` and `rotation`, or by its matrix. `texture()` in GLSL never does.
   */
  transform?: boolean
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
