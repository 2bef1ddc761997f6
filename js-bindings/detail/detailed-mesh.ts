// A mesh that is divided as finely as its warped surface needs it on the screen (src/detail).
import type { HostWarp, SurfacePhases } from '../compile/host-warp.js'
import type { DrawValues } from '../compile/offset-warp.js'
import type { VertexInput } from '../core/inputs/inputs.js'
import { arrayNames, type Vertices } from '../core/inputs/vertices.js'
import { details, type Detail, type DetailModule } from '../wasm/detail.js'
import { areEqual, copyInto, diagonalOf, gather, scatter } from './arrays.js'

export interface DetailAttribute {
  /** The input array of the warp that this attribute is; missing if it is none. */
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
  /** The indices of the triangles at which groups begin, in ascending order. */
  readonly groups?: readonly number[]
  /** `true` makes the surface between vertices of curved triangles, if an attribute has unit vectors. */
  readonly isCurved?: boolean
}

/**
 * The views of a mesh, with 19 numbers each: a matrix by columns that transforms warped positions to clip space, half of the viewport's
 * width and height in pixels, and 1 if triangles that face away are not drawn, -1 if triangles that face the eye are not drawn, or 0 if all are.
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
  /** `true` if the surface between vertices is curved, so that new vertices are not linear blends. */
  readonly isCurved: boolean
  readonly samples: Vertices
  /** Returns the values of an attribute at the vertices. `i` is its index, as for `DetailedMesh.values`. */
  readonly attribute: (i: number, size: number) => Float32Array
}

/** A mesh in wasm memory, which is freed with the `DetailedMesh` that owns it. */
interface WasmMesh {
  readonly bound: DetailModule
  readonly detail: Detail
}

const registry = new FinalizationRegistry<WasmMesh>(free)

function free({ bound, detail }: WasmMesh) {
  if (!bound.isBroken) detail.delete()
}

/** At least this many pieces across the mesh, so that samples see how smooth warps bend it. */
const minPiecesAcross = 8

/** Cutting ends after this many passes: each can split an edge into 32. */
const maxPasses = 4

/** The phases of a warp without waves and noises. */
const noPhases: SurfacePhases = { sizes: [], steps: [], size: 0, evaluate: () => undefined }

/** For warps with fewer operations, evaluating all samples takes less time than choosing some. */
const minOperations = 300

/** All samples are warped if more than this share of them is missing in a frame. */
const maxShare = 0.75

export class DetailedMesh {
  private wasmMesh: WasmMesh | undefined
  private samples: Vertices = { positions: new Float32Array() }
  private inSpace = new Float32Array()
  /** The samples in the space of the offset. */
  private placed = this.samples
  /** The values of the draw call for which samples are warped now. */
  private given: DrawValues = {}
  /** Samples below this index are warped whether views show them or not. */
  private warpedFirst = 0
  /** The other samples that are warped, one after another. */
  private chosen: Vertices = { positions: new Float32Array() }
  private warped = new Float32Array()
  private phases = new Float32Array()
  /** The inputs of the warp for which the samples are warped now; `undefined` if they are not. */
  private state: readonly number[] | undefined
  private views: readonly number[] = []
  private posed: DetailBase | undefined
  /** Changes when the arrays change. */
  version = 0
  /** Changes when the base is cut or moved. */
  baseVersion = 0
  private readonly maxLength: number

  constructor(
    private readonly warp: HostWarp,
    private readonly base: DetailBase,
  ) {
    this.maxLength = diagonalOf(base.positions) / minPiecesAcross || 1
  }

  /**
   * Divides the mesh for a frame. `given` are the values of the draw call, and `place` the numbers that `toSpace` depends on.
   * Returns `true` if the arrays changed.
   */
  update(
    given: DrawValues,
    views: DetailViews,
    tolerance: number,
    toSpace?: ToSpace,
    place: readonly number[] = [],
  ): boolean {
    if (!this.wasmMesh || this.wasmMesh.bound.isBroken) this.start()
    const { detail } = this.wasmMesh!
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

  /** Returns the numbers that the warped samples depend on. */
  stateOf(given: DrawValues, place: readonly number[] = []): number[] {
    return [...this.warp.state(given), ...place]
  }

  /**
   * Returns the base and its present division, for compute passes. Call it after an update; the result is valid until the next call of any
   * mesh.
   */
  parts(): DetailParts {
    const { detail } = this.wasmMesh!
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
    if (!this.wasmMesh || this.wasmMesh.bound.isBroken) return
    this.fill(posed)
    this.wasmMesh.detail.pose()
    this.readSamples()
    this.state = undefined
    this.baseVersion++
  }

  /**
   * Returns the values of an attribute, by its index in the base; -1 is positions. The result is a view, which is valid until the next call
   * of any mesh.
   */
  values(attribute: number): Float32Array {
    return this.wasmMesh?.detail.attribute(attribute + 1) ?? new Float32Array()
  }

  /** Returns a view, which is valid as long as that of `values`. */
  indices(): Uint32Array {
    return this.wasmMesh?.detail.indices() ?? new Uint32Array()
  }

  /** Returns, for each triangle, the index of the triangle of the base that it is a part of. */
  origins(): ArrayLike<number> {
    return this.wasmMesh!.detail.origins()
  }

  /**
   * Returns the vertices along lines, each between two vertices of the base: for each line the number of its vertices, then the vertices. A
   * line that is no side of a triangle is one piece.
   */
  lines(ends: ArrayLike<number>): ArrayLike<number> {
    return this.wasmMesh!.detail.lines(ends)
  }

  /** Returns the indices of the divided triangles at which groups begin. */
  groups(): Uint32Array {
    return this.wasmMesh!.detail.groups()
  }

  dispose() {
    if (!this.wasmMesh) return
    registry.unregister(this)
    free(this.wasmMesh)
    this.wasmMesh = undefined
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
    this.wasmMesh = { bound, detail }
    registry.register(this, this.wasmMesh, this)
    this.fill(this.base)
    detail.givenIndices().set(indices)
    detail.begin()
    this.readSamples()
    this.state = undefined
    this.baseVersion++
    if (this.posed) this.pose(this.posed)
  }

  private fill({ positions, attributes }: DetailBase) {
    const { detail } = this.wasmMesh!
    detail.given(0).set(positions)
    attributes.forEach(({ values }, i) => detail.given(i + 1).set(values))
  }

  /** Cuts the mesh until no edge is too long for its samples. How long that is depends on the inputs of the warp. */
  private cut(given: DrawValues, toSpace: ToSpace | undefined) {
    const { detail } = this.wasmMesh!
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

  /** Warps the first `count` samples, which begin with the vertices. */
  private warpFirst(count: number) {
    const { warped } = this
    this.warp.evaluatePositions(this.placed, count, this.given, warped)
    this.wasmMesh!.detail.warped().set(warped.subarray(0, 3 * count))
    this.warpedFirst = count
  }

  /** Warps the samples with these indices, which views may show. */
  private warpMissing(missing: Uint32Array) {
    const { detail } = this.wasmMesh!
    const count = detail.sampleCount()
    if (!missing.length || this.warpedFirst === count) return
    if (missing.length > maxShare * count) return this.warpFirst(count)
    gather(this.placed, missing, this.chosen)
    this.warp.evaluatePositions(this.chosen, missing.length, this.given, this.warped)
    scatter(this.warped, missing, detail.warped())
  }

  private readSamples() {
    const { detail } = this.wasmMesh!
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
