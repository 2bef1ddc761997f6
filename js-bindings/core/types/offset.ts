// What an offset function is given, and the uniforms that a sketch names.
import type { Mat3, Mat4, Scalar, Vec2, Vec3, Vec4, Vector } from './expressions.js'
import type { Glsl } from './glsl.js'
import type { VectorOf } from './signatures.js'

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
  /** The builder: `glsl.vec3(x, y, z)`, `glsl.val(2)`, and every operation as a function. */
  glsl: Glsl
  /** The vertex, in the space of the warp: a `sphere()` of p5 goes from -1 to 1 there, whatever its radius, unless
   * `space: 'world'` makes it pixels. */
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
  /** The first number of `mouse`. */
  mouseX: Scalar
  /** The second number of `mouse`. */
  mouseY: Scalar
  /** The canvas in pixels, as p5's width and height: not multiplied by pixelDensity. */
  size: Vec2
  /** The first number of `size`. */
  width: Scalar
  /** The second number of `size`. */
  height: Scalar
  /** Pixels of the screen for one of the canvas, as p5's `pixelDensity()`. */
  pixelDensity: Scalar
  /** The number of the instance that is drawn, from 0, as of `model(shape, count)` in p5 2. Needs WebGL 2 or WebGPU. */
  instance: Scalar
}

/** From a vertex to the offset that moves it. Called once; loops and functions act as macros. */
export type OffsetFunction<Uniforms extends UniformValues = {}> = (
  inputs: WarpInputs<Uniforms>,
) => Vec3
