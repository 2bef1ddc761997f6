// `VertexLayout`: the order of the numbers in the buffer of vertices that compute passes write and a draw call reads.

export interface VertexAttribute {
  /** Numbers per vertex. */
  readonly size: number
  readonly isUnit: boolean
}

export class VertexLayout {
  /** The numbers per vertex of all attributes. */
  readonly stride: number
  /** The numbers per vertex of the attributes before each one. */
  readonly before: readonly number[]

  constructor(
    /** The first one has the positions. */
    readonly attributes: readonly VertexAttribute[],
    /** `true` if each attribute is an array of its own; `false` if all numbers of a vertex follow each other. */
    readonly isPlanar: boolean,
  ) {
    let stride = 0
    this.before = attributes.map(({ size }) => (stride += size) - size)
    this.stride = stride
  }

  /** Returns the index of an attribute's first number in a buffer with room for `vertices`. */
  startOf(attribute: number, vertices: number): number {
    return this.before[attribute]! * (this.isPlanar ? vertices : 1)
  }

  /** Returns the distance between an attribute's first numbers of two adjacent vertices. */
  stepOf(attribute: number): number {
    return this.isPlanar ? this.attributes[attribute]!.size : this.stride
  }
}
