// The shapes and types of values.

/** Columns and rows: 1 and 1 for a number, 1 column for a vector, 0 columns for an image. */
export type Shape = readonly [columns: number, rows: number]

export const imageShape: Shape = [0, 1]

/** An input or result of a module. */
export interface Variable {
  name: string
  shape: Shape
  number: number
  /** Present if the variable does not consist of floats in the host. */
  read?: ReadAsFloats
}

type Whole = 'int' | 'uint' | 'ivec2' | 'ivec3' | 'ivec4' | 'uvec2' | 'uvec3' | 'uvec4'
type Condition = 'bool' | 'bvec2' | 'bvec3' | 'bvec4'

/** The name of a type, as in GLSL. */
export type TypeName = ShapeName | Whole | Condition
export type ShapeName = 'float' | 'vec2' | 'vec3' | 'vec4' | 'mat2' | 'mat3' | 'mat4' | 'sampler2D'

/** Describes how an input is read as a float: a whole number becomes two inputs, since a float represents only 24 of its bits. */
export interface ReadAsFloats {
  name: string
  type: TypeName
  half: 'low' | 'high' | undefined
  /** Maps a language → source of the conversion. */
  texts: Readonly<Record<string, string>>
}

/** Converts a number of the host to the float that such an input reads. */
export function asFloat({ half }: ReadAsFloats, value: number): number {
  if (half === 'low') return value & 0xffff
  return half === 'high' ? value >> 16 : value
}

export const typeOf = ([columns, rows]: Shape): ShapeName =>
  columns === 0
    ? 'sampler2D'
    : columns > 1
      ? (`mat${columns}` as ShapeName)
      : rows > 1
        ? (`vec${rows}` as ShapeName)
        : 'float'
