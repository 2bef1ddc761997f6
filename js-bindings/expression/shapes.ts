// How the numbers of a value are arranged.

/** Columns and rows; a number has one of each, a vector one column, an image none. */
export type Shape = readonly [columns: number, rows: number]

export const imageShape: Shape = [0, 1]

/** An input by its number in a module. */
export interface Variable {
  name: string
  shape: Shape
  number: number
}

/** In no language's words, though GLSL has the same. */
export type TypeName = 'float' | 'vec2' | 'vec3' | 'vec4' | 'mat2' | 'mat3' | 'mat4' | 'sampler2D'

export const typeOf = ([columns, rows]: Shape): TypeName =>
  columns === 0
    ? 'sampler2D'
    : columns > 1
      ? (`mat${columns}` as TypeName)
      : rows > 1
        ? (`vec${rows}` as TypeName)
        : 'float'
