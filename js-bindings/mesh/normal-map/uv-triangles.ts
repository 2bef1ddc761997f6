// The triangles of a mesh in the plane of its normal map.

/**
 * The triangles in units of texels: the centre of the texel in column i and row j, both counted from 0 at the top left, is at (i, j). Uvs
 * outside of 0 to 1 repeat the image.
 */
export class UvTriangles {
  readonly count: number

  constructor(
    private readonly uvs: Float32Array,
    readonly indices: Uint32Array,
    readonly size: number,
  ) {
    this.count = indices.length / 3
  }

  /** Returns x or y of a corner. */
  corner(triangle: number, corner: number, axis: 0 | 1): number {
    return this.uvs[2 * this.indices[3 * triangle + corner]! + axis]! * this.size - 0.5
  }

  /** Returns the range of x or y of a triangle. */
  range(triangle: number, axis: 0 | 1): [min: number, max: number] {
    const a = this.corner(triangle, 0, axis)
    const b = this.corner(triangle, 1, axis)
    const c = this.corner(triangle, 2, axis)
    return [Math.min(a, b, c), Math.max(a, b, c)]
  }

  /**
   * Finds the barycentric coordinate of each corner k as a function of a point (x, y): forms[3k] + forms[3k + 1] x + forms[3k + 2] y.
   * Returns `false` if the triangle has no area in the image.
   */
  findBarycentricForms(triangle: number, forms: Float64Array): boolean {
    const [ax, ay] = [this.corner(triangle, 0, 0), this.corner(triangle, 0, 1)]
    const [ux, uy] = [this.corner(triangle, 1, 0) - ax, this.corner(triangle, 1, 1) - ay]
    const [vx, vy] = [this.corner(triangle, 2, 0) - ax, this.corner(triangle, 2, 1) - ay]
    const doubleArea = ux * vy - uy * vx
    if (doubleArea === 0) return false
    forms[4] = vy / doubleArea
    forms[5] = -vx / doubleArea
    forms[7] = -uy / doubleArea
    forms[8] = ux / doubleArea
    forms[1] = -forms[4]! - forms[7]!
    forms[2] = -forms[5]! - forms[8]!
    // At corner 0 the barycentric coordinates are 1, 0 and 0.
    for (const [k, coordinate] of [1, 0, 0].entries())
      forms[3 * k] = coordinate - forms[3 * k + 1]! * ax - forms[3 * k + 2]! * ay
    return true
  }

  /**
   * The image repeats every `size` texels. Returns the coordinate of that copy of a column (axis 0) or row (axis 1) that is nearest to the
   * middle of the triangle's range.
   */
  nearestRepetition(triangle: number, columnOrRow: number, axis: 0 | 1): number {
    const [min, max] = this.range(triangle, axis)
    return columnOrRow + this.size * Math.round(((min + max) / 2 - columnOrRow) / this.size)
  }
}

/** Evaluates the barycentric coordinate of corner k at (x, y). */
export const barycentric = (forms: Float64Array, k: number, x: number, y: number) =>
  forms[3 * k]! + forms[3 * k + 1]! * x + forms[3 * k + 2]! * y
