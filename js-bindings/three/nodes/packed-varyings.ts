/**
 * Vectors that pass from the vertex stage to pixels, packed into varyings of four numbers: WebGPU guarantees 16 varyings, of which
 * three.js needs up to 9.
 */
import { tsl, type AnyNode } from './tsl.js'

const axes = ['x', 'y', 'z', 'w'] as const
const makers = { 2: 'vec2', 3: 'vec3', 4: 'vec4' } as const

export type VectorSize = keyof typeof makers

export class PackedVaryings {
  private readonly varyings: readonly AnyNode[]

  /** `sizes` maps the name of a vector → the number of its components. */
  constructor(
    prefix: string,
    private readonly sizes: ReadonlyMap<string, VectorSize>,
  ) {
    const total = [...sizes.values()].reduce<number>((sum, size) => sum + size, 0)
    this.varyings = Array.from({ length: Math.ceil(total / 4) }, (_, i) =>
      tsl.varyingProperty('vec4', `${prefix}${i}`),
    )
  }

  get count(): number {
    return this.varyings.length
  }

  /** Assigns all vectors, in the vertex stage. */
  pass(vectors: ReadonlyMap<string, AnyNode>) {
    const numbers = [...this.sizes].flatMap(([name, size]) => {
      const vector = vectors.get(name)!.toVar()
      return axes.slice(0, size).map((axis) => vector[axis])
    })
    this.varyings.forEach((varying, i) =>
      varying.assign(tsl.vec4(...axes.map((_, k) => numbers[4 * i + k] ?? 0))),
    )
  }

  /** Returns the interpolated vectors, in the fragment stage. */
  read(): ReadonlyMap<string, AnyNode> {
    let component = 0
    const next = () => this.varyings[component >> 2]![axes[component++ & 3]!]
    return new Map(
      [...this.sizes].map(([name, size]) => [
        name,
        tsl[makers[size]](...Array.from({ length: size }, next)),
      ]),
    )
  }
}
