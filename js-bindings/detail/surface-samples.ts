// The samples of a mesh, at which the warp and its phases are evaluated. In a frame in which only numbers change, it creates no garbage.
import type { HostWarp, SurfacePhases } from '../compile/host-warp.js'
import type { DrawValues } from '../compile/offset-warp.js'
import type { VertexInput } from '../core/inputs/inputs.js'
import { arrayNames, type Vertices } from '../core/inputs/vertices.js'
import type { Place } from '../options/place.js'
import { copyInto, gather, scatter } from './arrays.js'
import type { DetailBase } from './detail-base.js'
import { LastNumbers } from './last-numbers.js'
import { arraysInSpace, type InSpace } from './transform.js'
import type { WasmMesh } from './wasm-mesh.js'

/** Transforms samples into the space of the offset: see `transformSamples`. */
export type ToSpace = (samples: Vertices, to: InSpace) => Vertices

/** The phases of a warp without waves, noises, normals and fronts. */
export const noPhases: SurfacePhases = {
  sizes: [],
  steps: [],
  fronts: [],
  hasPeaksOrSteps: false,
  hasKinks: false,
  size: 0,
  writeState: () => 0,
  evaluate: () => undefined,
}

/** For warps with fewer operations, evaluating all samples takes less time than choosing some. */
const minOperations = 300

/** All samples are warped if more than this share of them is missing in a frame. */
const maxShare = 0.75

export class SurfaceSamples {
  /** `true` if all samples are warped in each frame, since the warp is cheap. */
  readonly areAllWarped: boolean
  readonly arrays: Vertices = { positions: new Float32Array() }
  private inSpace: InSpace | undefined
  /** The samples in the space of the offset. */
  private placed = this.arrays
  private readonly lastPlace = new LastNumbers()
  private readonly lastPhases = new LastNumbers()
  private readonly phaseState: number[] = []
  /** Samples below this index are warped whether views show them or not. */
  private warpedFirst = 0
  /** The other samples that are warped, one after another. */
  private readonly chosen: Vertices = { positions: new Float32Array() }
  private warpedChosen = new Float32Array()

  constructor(
    private readonly warp: HostWarp,
    private readonly phases: SurfacePhases,
    private readonly base: DetailBase,
    private readonly mesh: WasmMesh,
    /** The call that errors name. Default: the call that made the warp. */
    private readonly call?: Place,
  ) {
    this.areAllWarped = warp.operations() < minOperations
    this.read()
  }

  get haveFronts(): boolean {
    return this.phases.fronts.length > 0
  }

  get havePeaksOrSteps(): boolean {
    return this.phases.hasPeaksOrSteps
  }

  /** Reads the samples after the mesh was cut or moved. */
  read() {
    const { arrays, chosen } = this
    const read = (name: keyof Vertices, attribute: number) => {
      arrays[name] = copyInto(arrays[name], this.mesh.detail.sample(attribute))
      const { length } = arrays[name]
      if (this.isRead(name) && chosen[name]?.length !== length)
        chosen[name] = new Float32Array(length)
    }
    read('positions', 0)
    this.base.attributes.forEach(({ input }, i) => input && read(input, i + 1))
    const { length } = arrays.positions
    if (this.warpedChosen.length !== length) this.warpedChosen = new Float32Array(length)
    this.lastPlace.forget()
    this.lastPhases.forget()
  }

  /** Moves the samples into the space of the offset, if the numbers `place` that the transform depends on have changed. */
  place(toSpace: ToSpace | undefined, place: readonly number[]) {
    if (this.lastPlace.are(place)) return
    if (toSpace) {
      this.inSpace = arraysInSpace(this.arrays, this.inSpace)
      this.placed = toSpace(this.arrays, this.inSpace)
    } else this.placed = this.arrays
    this.lastPlace.set(place)
    this.lastPhases.forget()
  }

  /** Writes the phases into the wasm. Returns `false` if it has written the same ones before. */
  writePhases(given: DrawValues): boolean {
    const { mesh, phases, phaseState, lastPhases } = this
    const count = phases.writeState(given, phaseState, this.call)
    if (lastPhases.are(phaseState, count)) return false
    phases.evaluate(this.placed, mesh.cutSampleCount, given, mesh.phaseArray(), this.call)
    lastPhases.set(phaseState, count)
    return true
  }

  /** Forgets the phases, so that `writePhases` writes them again. */
  forgetPhases() {
    this.lastPhases.forget()
  }

  /** Warps the samples that are warped whether views show them or not: at least the vertices. */
  warpFirst(given: DrawValues) {
    const { mesh } = this
    mesh.forgetSamples()
    this.warpUpTo(this.areAllWarped ? mesh.sampleCount : mesh.vertexCount, given)
  }

  /** Warps the samples that `show` has listed. */
  warpMissing(count: number, given: DrawValues) {
    const { mesh, chosen, warpedChosen } = this
    const { sampleCount, words } = mesh
    if (!count || this.warpedFirst === sampleCount) return
    if (count > maxShare * sampleCount) return this.warpUpTo(sampleCount, given)
    const at = mesh.missingSamplesAt()
    gather(this.placed, words, at, count, chosen)
    this.warp.evaluatePositions(chosen, count, given, warpedChosen, this.call)
    scatter(warpedChosen, words, at, count, mesh.warped())
  }

  /** Warps the first `count` samples. */
  private warpUpTo(count: number, given: DrawValues) {
    this.warp.evaluatePositions(this.placed, count, given, this.mesh.warped(), this.call)
    this.warpedFirst = count
  }

  /** Tests whether the warp reads an array. */
  private isRead(name: keyof Vertices) {
    return Object.entries(arrayNames).some(
      ([input, array]) => array === name && this.warp.reads(input as VertexInput),
    )
  }
}
