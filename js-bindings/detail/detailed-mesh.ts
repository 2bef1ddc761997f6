// A mesh that is divided as finely as its warped surface needs it on the screen (src/detail).
import type { HostWarp, SurfacePhases } from '../compile/host-warp.js'
import type { DrawValues } from '../compile/offset-warp.js'
import type { VertexInput } from '../core/inputs/inputs.js'
import { arrayNames, type Vertices } from '../core/inputs/vertices.js'
import { details, type Detail, type DetailModule } from '../wasm/detail.js'
import { areEqual, copyInto, diagonalOf, gather, scatter } from './arrays.js'

export interface DetailAttribute {
  /** The array that it is for the warp; missing if the warp doesn't read it. */
  readonly input?: Exclude<keyof Vertices, 'positions'> | undefined
  /** Numbers per vertex. */
  readonly size: number
  readonly values: ArrayLike<number>
  /** `true` for unit vectors, which keep their length between vertices. */
  readonly isUnit?: boolean
}

export interface DetailBase {
  /** 3 numbers per vertex. */
  readonly positions: ArrayLike<number>
  readonly attributes: readonly DetailAttribute[]
  /** 3 per triangle. */
  readonly indices: ArrayLike<number>
  /** The numbers of triangles at which groups begin, in ascending order. */
  readonly groups?: readonly number[]
  /** `true` continues the surface between vertices by curved triangles, if an attribute is of unit vectors. */
  readonly isCurved?: boolean
}

/**
 * The views of a mesh, with 19 numbers each: a matrix by columns from warped positions to clip space, half of the viewport's width and
 * height in pixels, and 1 if triangles that face away are not drawn, -1 if triangles that face the eye are not drawn, or 0 if all are.
 */
export type DetailViews = number[]

/** Transforms samples into the space of the offset. Writes positions into `positions`, and returns all arrays. */
export type ToSpace = (samples: Vertices, positions: Float32Array) => Vertices

export interface DetailParts {
  readonly vertices: number
  readonly triangles: number
  readonly sides: number
  /** See src/detail/topology.hpp. */
  readonly topology: Uint32Array
  /** The numbers of pieces, by edge. */
  readonly pieces: Uint32Array
  /** `true` if vertices between others are not blends of them. */
  readonly isCurved: boolean
  readonly samples: Vertices
  /** The numbers of an attribute at the vertices. Its place is as for `DetailedMesh.values`. */
  readonly attribute: (i: number, size: number) => Float32Array
}

/** A mesh in the wasm, which is freed with the `DetailedMesh` that owns it. */
interface Held {
  readonly bound: DetailModule
  readonly detail: Detail
}

const registry = new FinalizationRegistry<Held>(free)

function free({ bound, detail }: Held) {
  if (!bound.isBroken) detail.delete()
}

/** At least this many pieces across the mesh, so that samples see how smooth warps bend it. */
const minPiecesAcross = 8

/** Cutting ends after this many passes: each can split an edge into 32. */
const maxPasses = 4

/** The phases of a warp without waves and noises. */
const noPhases: SurfacePhases = { sizes: [], steps: [], size: 0, evaluate: () => undefined }

/** Warps with fewer operations take less time for all samples than it takes to choose some. */
const minOperations = 300

/** All samples are warped if a frame lacks more than this share of them. */
const maxShare = 0.75

export class DetailedMesh {
  private held: Held | undefined
  private samples: Vertices = { positions: new Float32Array() }
  private inSpace = new Float32Array()
  /** The samples in the space of the offset, and the values for which the vertices are warped now. */
  private placed = this.samples
  private given: DrawValues = {}
  /** The number of samples, of the first ones, that are warped whether views show them or not. */
  private warpedFirst = 0
  /** Some of the samples, one after another, that are warped beside those. */
  private chosen: Vertices = { positions: new Float32Array() }
  private warped = new Float32Array()
  private phases = new Float32Array()
  /** The inputs of the warp for which the samples are warped now; `undefined` if they are not. */
  private state: readonly number[] | undefined
  private views: readonly number[] = []
  private posed: DetailBase | undefined
  /** Changes with the arrays. */
  version = 0
  /** Changes when the mesh is cut, or moved. */
  baseVersion = 0
  private readonly maxLength: number

  constructor(
    private readonly warp: HostWarp,
    private readonly base: DetailBase,
  ) {
    this.maxLength = diagonalOf(base.positions) / minPiecesAcross || 1
  }

  /**
   * Divides the mesh for a frame. `given` are the values of the draw call. `place` are numbers that `toSpace` depends on.
   * Returns `true` if the arrays changed.
   */
  update(
    given: DrawValues,
    views: DetailViews,
    tolerance: number,
    toSpace?: ToSpace,
    place: readonly number[] = [],
  ): boolean {
    if (!this.held || this.held.bound.isBroken) this.start()
    const { detail } = this.held!
    const now = this.warp.withUniformsNow(given)
    const state = this.stateOf(now, place)
    const seen = [...views, tolerance]
    if (!this.state || !areEqual(state, this.state)) {
      this.cut(now, toSpace)
      this.placed = this.inOffsetSpace(toSpace)
      this.given = now
      detail.forgetSamples()
      const isCheap = this.warp.operations() < minOperations
      this.warpFirst(isCheap ? detail.sampleCount() : detail.vertexCount())
      this.state = state
    } else if (areEqual(seen, this.views)) return false
    this.views = seen
    this.warpMissing(detail.show(views))
    const isChanged = detail.update(tolerance)
    if (isChanged) this.version++
    return isChanged
  }

  /** The numbers that the warped samples depend on. */
  stateOf(given: DrawValues, place: readonly number[] = []): number[] {
    return [...this.warp.state(given), ...place]
  }

  /** The base and its present division, for compute passes. Valid after an update, until the next call of any mesh. */
  parts(): DetailParts {
    const { detail } = this.held!
    // Compute passes do not choose a uniform division.
    detail.divideBase()
    this.version++
    const vertices = detail.vertexCount()
    const topology = detail.topology()
    // There are three samples for each side and each triangle.
    const triangles = (topology.length - detail.sampleCount() + vertices) / 3
    return {
      vertices,
      triangles,
      sides: (topology.length - 6 * triangles) / 3,
      topology,
      pieces: detail.pieces(),
      isCurved: detail.isCurved(),
      samples: this.samples,
      // The first of all samples are the vertices.
      attribute: (i, size) => detail.sample(i + 1).subarray(0, size * vertices),
    }
  }

  /** Moves the vertices of the base for the frames from now on. The triangles stay as they are. */
  pose(posed: DetailBase) {
    this.posed = posed
    if (!this.held || this.held.bound.isBroken) return
    this.fill(posed)
    this.held.detail.pose()
    this.readSamples()
    this.state = undefined
    this.baseVersion++
  }

  /** The numbers of an attribute, by its place in the base; -1 is positions. A view, which is valid until the next call of any mesh. */
  values(attribute: number): Float32Array {
    return this.held?.detail.attribute(attribute + 1) ?? new Float32Array()
  }

  /** A view like `values`. */
  indices(): Uint32Array {
    return this.held?.detail.indices() ?? new Uint32Array()
  }

  /** The triangle of the base that each one is a part of. */
  origins(): ArrayLike<number> {
    return this.held!.detail.origins()
  }

  /**
   * The vertices along lines, each between two vertices of the base: for each line their number, then the vertices. A line that is no
   * side of a triangle is one piece.
   */
  lines(ends: ArrayLike<number>): ArrayLike<number> {
    return this.held!.detail.lines(ends)
  }

  /** The numbers of triangles at which the groups begin now. */
  groups(): Uint32Array {
    return this.held!.detail.groups()
  }

  dispose() {
    if (!this.held) return
    registry.unregister(this)
    free(this.held)
    this.held = undefined
  }

  private start() {
    const bound = details.get()
    const { positions, attributes, indices, groups = [], isCurved = false } = this.base
    const all = [{ size: 3, values: positions, isUnit: false }, ...attributes]
    const sizes = all.map(({ size }) => size)
    const areUnit = all.map(({ isUnit }) => (isUnit ? 1 : 0))
    const [vertices, triangles] = [positions.length / 3, indices.length / 3]
    const detail = new bound.Detail(sizes, areUnit, vertices, triangles, groups, isCurved)
    this.dispose()
    this.held = { bound, detail }
    registry.register(this, this.held, this)
    this.fill(this.base)
    detail.givenIndices().set(indices)
    detail.begin()
    this.readSamples()
    this.state = undefined
    this.baseVersion++
    if (this.posed) this.pose(this.posed)
  }

  private fill({ positions, attributes }: DetailBase) {
    const { detail } = this.held!
    detail.given(0).set(positions)
    attributes.forEach(({ values }, i) => detail.given(i + 1).set(values))
  }

  /** Cuts the mesh until no edge is longer than samples allow, which changes with the inputs of the warp. */
  private cut(given: DrawValues, toSpace: ToSpace | undefined) {
    const { detail } = this.held!
    const { sizes, steps, size, evaluate } = this.warp.surfacePhases() ?? noPhases
    for (let pass = 0; pass < maxPasses; pass++) {
      const count = detail.cutSampleCount()
      if (this.phases.length !== size * count) this.phases = new Float32Array(size * count)
      evaluate(this.inOffsetSpace(toSpace), count, given, this.phases)
      detail.phases(size).set(this.phases)
      if (!detail.cut(this.maxLength, sizes, steps)) return
      this.readSamples()
      this.baseVersion++
    }
  }

  /** Warps the first samples, of which the vertices are the first. */
  private warpFirst(count: number) {
    const { warped } = this
    this.warp.evaluatePositions(this.placed, count, this.given, warped)
    this.held!.detail.warped().set(warped.subarray(0, 3 * count))
    this.warpedFirst = count
  }

  /** Warps samples that views may show. */
  private warpMissing(numbers: Uint32Array) {
    const { detail } = this.held!
    const count = detail.sampleCount()
    if (!numbers.length || this.warpedFirst === count) return
    if (numbers.length > maxShare * count) return this.warpFirst(count)
    gather(this.placed, numbers, this.chosen)
    this.warp.evaluatePositions(this.chosen, numbers.length, this.given, this.warped)
    scatter(this.warped, numbers, detail.warped())
  }

  private readSamples() {
    const { detail } = this.held!
    const { samples, chosen } = this
    const read = (name: keyof Vertices, attribute: number) => {
      samples[name] = copyInto(samples[name], detail.sample(attribute))
      const { length } = samples[name]
      if (!this.isRead(name)) return
      if (chosen[name]?.length !== length) chosen[name] = new Float32Array(length)
    }
    read('positions', 0)
    this.base.attributes.forEach(({ input }, i) => input && read(input, i + 1))
    const { length } = samples.positions
    if (this.warped.length === length) return
    this.inSpace = new Float32Array(length)
    this.warped = new Float32Array(length)
  }

  /** Tests whether the warp reads an array. */
  private isRead(name: keyof Vertices) {
    return Object.entries(arrayNames).some(
      ([input, array]) => array === name && this.warp.reads(input as VertexInput),
    )
  }

  private inOffsetSpace(toSpace: ToSpace | undefined): Vertices {
    return toSpace ? toSpace(this.samples, this.inSpace) : this.samples
  }
}
