// A mesh that is divided as finely as its warped surface needs it on the screen (src/detail).
import type { HostWarp } from '../compile/host-warp.js'
import type { DrawValues } from '../compile/offset-warp.js'
import type { Vertices } from '../core/inputs/vertices.js'
import type { Place } from '../options/place.js'
import { diagonalOf } from './arrays.js'
import type { DetailBase } from './detail-base.js'
import { LastNumbers } from './last-numbers.js'
import { Pace } from './pace.js'
import { SurfaceSamples, noPhases, type ToSpace } from './surface-samples.js'
import { WasmMesh } from './wasm-mesh.js'

export type { DetailAttribute, DetailBase } from './detail-base.js'
export type { ToSpace } from './surface-samples.js'

/**
 * The views of a mesh, with 19 numbers each: a matrix by columns that transforms warped positions to clip space, half of the viewport's
 * width and height in pixels, and 1 if triangles that face away are not drawn, -1 if triangles that face the eye are not drawn, or 0 if all are.
 */
export type DetailViews = readonly number[]

export interface DetailParts {
  readonly vertices: number
  readonly triangles: number
  readonly sides: number
  /** See src/detail/topology.hpp. */
  readonly topology: Uint32Array
  /** The numbers of pieces, by edge. */
  readonly pieces: Uint32Array
  /** `true` if the surface between vertices is curved, so that new vertices are not linear blends. */
  readonly isCurved: boolean
  readonly samples: Vertices
  /** Returns the values of an attribute at the vertices. `i` is its index, as for `DetailedMesh.values`. */
  readonly attribute: (i: number, size: number) => Float32Array
}

/** At least this many pieces across the mesh, so that samples see how smooth warps bend it. */
const minPiecesAcross = 8

/** Cutting ends after this many passes: each can split an edge into 32, or in two at a front. */
const maxPasses = 12

/**
 * Fronts that move over a mesh leave cuts behind. So the mesh is cut anew, from the given one, if it has more than this many times as
 * many samples as after it was cut first, or if it was cut this many times since.
 */
const [maxGrowth, maxLaterCuts] = [1.5, 32]

const noPlace: readonly number[] = []

/** The mesh in the wasm, and its samples. */
interface Started {
  readonly mesh: WasmMesh
  readonly samples: SurfaceSamples
}

export class DetailedMesh {
  private started: Started | undefined
  /** The inputs of the warp for which the samples are warped now. */
  private readonly lastState = new LastNumbers()
  private readonly lastViews = new LastNumbers()
  private lastTolerance = 0
  private readonly pace = new Pace()
  private readonly state: number[] = []
  private posed: DetailBase | undefined
  /** Changes when the arrays change. */
  version = 0
  /** Changes when the base is cut or moved. */
  baseVersion = 0
  private readonly maxLength: number
  /** The number of samples after the mesh was cut first; `undefined` before. */
  private firstSampleCount: number | undefined
  /** The number of times that the mesh was cut since. */
  private laterCuts = 0

  constructor(
    private readonly warp: HostWarp,
    private readonly base: DetailBase,
    /** The call that errors name. Default: the call that made the warp. */
    private readonly call?: Place,
  ) {
    this.maxLength = diagonalOf(base.positions) / minPiecesAcross || 1
  }

  /**
   * Divides the mesh for a frame. `given` are the values of the draw call, and `place` the numbers that `toSpace` depends on.
   * Returns `true` if the arrays changed. While camera and surface move slowly and steadily, every second frame keeps the division.
   * Creates no garbage while the cuts stay the same and the warp's inputs are numbers.
   */
  update(
    given: DrawValues,
    views: DetailViews,
    tolerance: number,
    toSpace?: ToSpace,
    place: readonly number[] = noPlace,
  ): boolean {
    this.startedMesh()
    const { state, lastState, lastViews } = this
    const now = this.warp.withUniformsNow(given, this.call)
    const count = this.writeState(now, place, state)
    const isSameTolerance = tolerance === this.lastTolerance
    const isSameSurface = lastState.are(state, count)
    if (isSameTolerance && isSameSurface && lastViews.are(views)) return false
    if (isSameTolerance && this.pace.leavesOut(state, count, views)) return false
    if (!isSameSurface) {
      // If the warp fails, as without one of its uniforms, the samples have no state.
      lastState.forget()
      this.cut(now, toSpace, place)
      this.started!.samples.warpFirst(now)
      lastState.set(state, count)
    }
    const { mesh, samples } = this.started!
    this.lastTolerance = tolerance
    lastViews.set(views)
    samples.warpMissing(mesh.show(views, !samples.areAllWarped), now)
    const isChanged = mesh.update(tolerance)
    // A front that moves reaches triangles that showed nothing of it.
    this.pace.measured(!samples.haveFronts && mesh.staysExact())
    if (isChanged) this.version++
    return isChanged
  }

  /** Tests whether an update would cut the mesh at a front that has moved. */
  hasMovedFronts(
    given: DrawValues,
    toSpace?: ToSpace,
    place: readonly number[] = noPlace,
  ): boolean {
    const { mesh, samples } = this.startedMesh()
    if (!samples.havePeaksOrSteps) return false
    samples.place(toSpace, place)
    if (!samples.writePhases(this.warp.withUniformsNow(given, this.call))) return false
    const isCoarse = mesh.isCoarse(this.maxLength)
    if (isCoarse) samples.forgetPhases()
    return isCoarse
  }

  /** Returns the numbers that the warped samples depend on. */
  stateOf(given: DrawValues, place: readonly number[] = noPlace): number[] {
    const numbers: number[] = []
    this.writeState(given, place, numbers)
    return numbers
  }

  /**
   * Returns the base and its present division, for compute passes. Call it after an update; the result is valid until the next call of any
   * mesh.
   */
  parts(): DetailParts {
    const { mesh, samples } = this.started!
    const { detail, vertexCount: vertices } = mesh
    // Compute passes do not choose a uniform division.
    detail.divideBase()
    this.version++
    const topology = detail.topology()
    // There are three samples for each side and each triangle.
    const triangles = (topology.length - mesh.sampleCount + vertices) / 3
    return {
      vertices,
      triangles,
      sides: (topology.length - 6 * triangles) / 3,
      topology,
      pieces: detail.pieces(),
      isCurved: detail.isCurved(),
      samples: samples.arrays,
      // The first of all samples are the vertices.
      attribute: (i, size) => detail.sample(i + 1).subarray(0, size * vertices),
    }
  }

  /** Moves the vertices of the base for the frames from now on. The triangles stay as they are. */
  pose(posed: DetailBase) {
    this.posed = posed
    if (!this.started || this.started.mesh.isBroken) return
    const { mesh, samples } = this.started
    mesh.fill(posed)
    mesh.detail.pose()
    samples.read()
    this.forgetSurface()
    this.baseVersion++
  }

  /**
   * Returns the values of an attribute, by its index in the base; -1 is positions. The result is a view, which is valid until the next call
   * of any mesh.
   */
  values(attribute: number): Float32Array {
    return this.started?.mesh.detail.attribute(attribute + 1) ?? new Float32Array()
  }

  /** Returns a view, which is valid as long as that of `values`. */
  indices(): Uint32Array {
    return this.started?.mesh.detail.indices() ?? new Uint32Array()
  }

  /** Returns, for each triangle, the index of the triangle of the base that it is a part of. */
  origins(): ArrayLike<number> {
    return this.started!.mesh.detail.origins()
  }

  /**
   * Returns the vertices along lines, each between two vertices of the base: for each line the number of its vertices, then the vertices. A
   * line that is no side of a triangle is one piece.
   */
  lines(ends: ArrayLike<number>): ArrayLike<number> {
    return this.started!.mesh.detail.lines(ends)
  }

  /** Returns the indices of the divided triangles at which groups begin. */
  groups(): Uint32Array {
    return this.started!.mesh.detail.groups()
  }

  dispose() {
    this.started?.mesh.dispose()
    this.started = undefined
  }

  private startedMesh(): Started {
    if (!this.started || this.started.mesh.isBroken) this.start()
    return this.started!
  }

  private start() {
    this.dispose()
    const phases = this.warp.surfacePhases() ?? noPhases
    const mesh = new WasmMesh(this.base, phases)
    const samples = new SurfaceSamples(this.warp, phases, this.base, mesh, this.call)
    this.started = { mesh, samples }
    this.firstSampleCount = undefined
    this.forgetSurface()
    this.baseVersion++
    if (this.posed) this.pose(this.posed)
  }

  /** Has the next update measure the mesh, even within a steady motion. */
  measureNext() {
    this.pace.forget()
  }

  private forgetSurface() {
    this.lastState.forget()
    this.pace.forget()
  }

  private writeState(given: DrawValues, place: readonly number[], to: number[]): number {
    let count = this.warp.writeState(given, to, this.call)
    for (let i = 0; i < place.length; i++) to[count++] = place[i]!
    return count
  }

  /** Cuts the mesh until no edge is too long for its samples. How long that is depends on the inputs of the phases. */
  private cut(given: DrawValues, toSpace: ToSpace | undefined, place: readonly number[]) {
    if (this.isOvercut()) this.start()
    const { mesh, samples } = this.started!
    samples.place(toSpace, place)
    for (let pass = 0; pass < maxPasses; pass++) {
      if (!samples.writePhases(given) || !mesh.cut(this.maxLength)) break
      samples.read()
      samples.place(toSpace, place)
      this.baseVersion++
      this.laterCuts++
    }
    if (this.firstSampleCount !== undefined) return
    this.firstSampleCount = mesh.sampleCount
    this.laterCuts = 0
  }

  private isOvercut(): boolean {
    const { firstSampleCount, laterCuts } = this
    const { mesh, samples } = this.started!
    if (firstSampleCount === undefined || laterCuts === 0 || !samples.havePeaksOrSteps) return false
    return laterCuts > maxLaterCuts || mesh.sampleCount > maxGrowth * firstSampleCount
  }
}
