// How the numbers of a value are arranged.

/** Columns and rows; a number has one of each, a vector one column, an image none. */
export type Shape = readonly [columns: number, rows: number]

export const imageShape: Shape = [0, 1]

/** An input by its number in a module. */
export interface Variable {
  name: string
  shape: Shape
  number: number
  /** Unless the host has floats there. */
  read?: ReadAsFloats
}

type Whole = 'int' | 'uint' | 'ivec2' | 'ivec3' | 'ivec4' | 'uvec2' | 'uvec3' | 'uvec4'
type Condition = 'bool' | 'bvec2' | 'bvec3' | 'bvec4'

/** In no language's words, though GLSL has the same. */
export type TypeName = ShapeName | Whole | Condition
export type ShapeName = 'float' | 'vec2' | 'vec3' | 'vec4' | 'mat2' | 'mat3' | 'mat4' | 'sampler2D'

/** An input that the host has as numbers of another type: whole numbers as two inputs, since a float tells only 24 of their bits. */
export interface ReadAsFloats {
  name: string
  type: TypeName
  half: 'low' | 'high' | undefined
  /** How each language does. */
  texts: Readonly<Record<string, string>>
}

/** What such an input is of a number of the host. */
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
