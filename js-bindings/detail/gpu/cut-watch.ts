// Watches whether a mesh that compute passes divide must be cut anew: tests a few of its sides in each frame, on the CPU.
import type { SurfacePhases } from '../../compile/host-warp.js'
import type { DrawValues } from '../../compile/offset-warp.js'
import { arrayNames, type Vertices } from '../../core/inputs/vertices.js'
import { areEqual } from '../arrays.js'
import type { DetailParts, ToSpace } from '../detailed-mesh.js'
import { arraysInSpace, type InSpace } from '../transform.js'

/** An expensive noise takes about half a millisecond for 256 sides. */
const sidesPerFrame = 256

/** The two ends of a side, and the three samples between them. */
const samplesPerSide = 5

/** Sides that are longer than this, in steps of a phase, are cut, as in `Detail::cut`. */
const maxLength = 1.1

export class CutWatch {
  /** The index of the slice of the sides that was tested last. */
  private slice = 0
  /** The number of slices that have not been tested for the present surface. */
  private untested = 0
  private readonly slices: number
  private readonly samples: Vertices
  private readonly inSpace: InSpace
  private readonly phases: Float32Array
  private state: readonly number[] = []

  /** `surface` are the phases of the warp; `undefined` if it has none. */
  constructor(
    private surface: SurfacePhases | undefined,
    private readonly parts: DetailParts,
  ) {
    this.slices = Math.ceil(parts.sides / sidesPerFrame)
    const count = samplesPerSide * Math.ceil(parts.sides / this.slices)
    this.samples = Object.fromEntries(
      Object.entries(parts.samples as unknown as Arrays).map(([name, { length }]) => [
        name,
        new Float32Array(count * (length / (parts.samples.positions.length / 3))),
      ]),
    ) as unknown as Vertices
    this.inSpace = arraysInSpace(this.samples)
    this.phases = new Float32Array((surface?.size ?? 0) * count)
  }

  /** Tests whether any side of the next slice is too long. `state` are the numbers that the warped samples depend on. */
  isCoarse(given: DrawValues, state: readonly number[], toSpace: ToSpace | undefined): boolean {
    const { surface, samples, phases, inSpace } = this
    if (!surface) return false
    if (!areEqual(state, this.state)) this.untested = this.slices
    this.state = state
    if (this.untested === 0) return false
    this.untested--
    this.slice = (this.slice + 1) % this.slices
    const count = this.gather()
    const placed = toSpace ? toSpace(samples, inSpace) : samples
    surface.evaluate(placed, samplesPerSide * count, given, phases)
    for (let i = 0; i < count; i++) if (this.isLong(surface, i)) return true
    return false
  }

  /** Ends the watch: the mesh cannot be cut further. */
  stop() {
    this.surface = undefined
  }

  /** Copies the samples of a slice; returns its number of sides. */
  private gather() {
    const { vertices, triangles, sides, topology } = this.parts
    let count = 0
    for (let side = this.slice; side < sides; side += this.slices, count++) {
      const [middle, ends] = [vertices + 3 * side, 6 * triangles + 3 * side]
      this.copy(count, [topology[ends]!, middle, middle + 1, middle + 2, topology[ends + 1]!])
    }
    return count
  }

  private copy(place: number, from: readonly number[]) {
    const [to, all] = [this.samples, this.parts.samples] as unknown as [Arrays, Arrays]
    for (const name of Object.values(arrayNames)) {
      const target = to[name]
      if (!target) continue
      const size = target.length / (this.samples.positions.length / 3)
      const source = all[name]!
      from.forEach((sample, i) => {
        const at = size * (samplesPerSide * place + i)
        for (let k = 0; k < size; k++) target[at + k] = source[size * sample + k]!
      })
    }
  }

  private isLong({ sizes, steps, size }: SurfacePhases, place: number): boolean {
    let offset = 0
    for (const [i, step] of steps.entries()) {
      let change = 0
      for (let sample = 1; sample < samplesPerSide; sample++) {
        const at = size * (samplesPerSide * place + sample) + offset
        let square = 0
        for (let k = 0; k < sizes[i]!; k++)
          square += (this.phases[at + k]! - this.phases[at - size + k]!) ** 2
        change += Math.sqrt(square)
      }
      if (Number.isFinite(change) && change > maxLength * step) return true
      offset += sizes[i]!
    }
    return false
  }
}

type Arrays = Record<string, Float32Array>
