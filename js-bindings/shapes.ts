// What a value is.

/** Columns and rows; a number has one of each, a vector one column, an image none. */
export type Shape = readonly [columns: number, rows: number]
export const imageShape: Shape = [0, 1]

/** A variable or expression of the host. */
export interface Variable {
  name: string
  shape: Shape
}
