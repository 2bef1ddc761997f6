// The types of an offset function, its inputs and its uniforms.
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

/** A p5.Vector, or another object with these properties. */
export interface VectorLike {
  readonly x: number
  readonly y: number
  readonly z: number
}

/** A p5.Color. */
export interface ColorLike {
  setAlpha(alpha: number): unknown
}

/** A p5.Image, p5.Graphics, p5.Framebuffer or video, for `glsl.texture`; only p5's createWarp can pass it to the shader. */
export interface ImageLike {
  readonly width: number
  readonly height: number
}

export type UniformValues = Readonly<Record<string, UniformValue>>

/** The option `uniforms`: maps a name → value, or a function that returns it, which is called whenever the warp is used. */
export type UniformOptions<Values extends UniformValues = UniformValues> = {
  [Name in keyof Values]: Values[Name] | (() => Values[Name])
}

/**
 * The type of the expression of a uniform with values of type `Value`. An array whose length TypeScript does not know may be of any size.
 */
export type UniformExpression<Value> = Value extends number | boolean
  ? Scalar
  : Value extends ImageLike
    ? ImageName
    : Value extends { readonly length: infer Length extends number }
      ? number extends Length
        ? Vector | Mat3 | Mat4
        : OfLength<Length>
      : Value extends ColorLike
        ? Vec4
        : Vec3

/** The shader's name of an image among the uniforms, for `glsl.texture`. */
export type ImageName = string

type OfLength<Length> = Length extends 2 | 3 | 4
  ? VectorOf<Length>
  : Length extends 9
    ? Mat3
    : Length extends 16
      ? Mat4
      : never

/** The input `uniforms` of an offset function. */
export type UniformExpressions<Values> = {
  readonly [Name in keyof Values]: UniformExpression<Values[Name]>
}

/** Values that a call may pass in place of the declared ones. */
export type UniformOverrides<Values> = {
  readonly [Name in keyof Values]?: UniformExpression<Values[Name]> extends Scalar
    ? number | boolean
    : UniformExpression<Values[Name]> extends ImageName
      ? ImageLike
      : ArrayLike<number> | VectorLike | ColorLike
}

/** The inputs of an offset function. */
export interface WarpInputs<Uniforms extends UniformValues = {}> {
  /** The uniforms that the option `uniforms` declares. Reading another name throws. */
  uniforms: UniformExpressions<Uniforms>
  /** The builder: `glsl.vec3(x, y, z)`, `glsl.val(2)`, and every operation as a function. */
  glsl: Glsl
  /** The position of the vertex, in the space of the warp: a `sphere()` of p5 ranges from -1 to 1 there, whatever its radius; with
   * `space: 'world'`, positions are in pixels. */
  position: Vec3
  /** The vertex's normal in the mesh, normally of length 1. The warped normal takes into account how `normal` and `uv` vary over the
   * surface, if the mesh says how (`surfaceVariation` of 'warpjet/mesh'); `color` is treated as constant. */
  normal: Vec3
  /** Texture coordinates. */
  uv: Vec2
  /** Red, green, blue and alpha from 0 to 1: the color of the vertex if it has one, otherwise the fill. */
  color: Vec4
  /** Milliseconds since the sketch started. */
  millis: Scalar
  /** The position of the mouse in pixels from the top left corner of the canvas, like p5's mouseX and mouseY. */
  mouse: Vec2
  /** The first number of `mouse`. */
  mouseX: Scalar
  /** The second number of `mouse`. */
  mouseY: Scalar
  /** The size of the canvas in CSS pixels, like p5's width and height: not multiplied by pixelDensity. */
  size: Vec2
  /** The first number of `size`. */
  width: Scalar
  /** The second number of `size`. */
  height: Scalar
  /** The number of screen pixels per canvas pixel, like p5's `pixelDensity()`. */
  pixelDensity: Scalar
  /** The index of the drawn instance, from 0, as of `model(shape, count)` in p5 2. Needs WebGL 2 or WebGPU. */
  instance: Scalar
}

/** Returns the offset that moves a vertex. It is called once; its loops and functions act as macros. */
export type OffsetFunction<Uniforms extends UniformValues = {}> = (
  inputs: WarpInputs<Uniforms>,
) => Vec3
