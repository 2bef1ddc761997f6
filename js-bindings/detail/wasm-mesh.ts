// A mesh in the memory of the wasm. The methods that are called in each frame create no garbage: they call plain exports, and return the
// same views as before unless the memory has grown.
import type { SurfacePhases } from '../compile/host-warp.js'
import { details, type Detail, type DetailModule } from '../wasm/detail.js'
import { Views } from '../wasm/views.js'
import type { DetailBase } from './detail-base.js'

/** A mesh in the wasm, which must be freed with the `WasmMesh` that owns it. */
interface Owned {
  readonly bound: DetailModule
  readonly detail: Detail
}

const registry = new FinalizationRegistry<Owned>(free)

function free({ bound, detail }: Owned) {
  if (!bound.isBroken) detail.delete()
}

enum View {
  Warped,
  Phases,
}

export class WasmMesh {
  readonly detail: Detail
  /** The number of samples. It changes when the mesh is cut, like the next two. */
  sampleCount = 0
  /** The number of vertices, which are the first samples. */
  vertexCount = 0
  /** The number of samples at which phases are needed. They are the first ones. */
  cutSampleCount = 0
  readonly bound = details.get()
  private readonly address: number
  private readonly views = new Views()

  constructor(
    base: DetailBase,
    private readonly phases: SurfacePhases,
  ) {
    const { positions, attributes, indices, groups = [], isCurved = false } = base
    const all = [{ size: 3, isUnit: false }, ...attributes]
    const sizes = all.map(({ size }) => size)
    const areUnit = all.map(({ isUnit }) => (isUnit ? 1 : 0))
    const [vertices, triangles] = [positions.length / 3, indices.length / 3]
    const { bound } = this
    const detail = new bound.Detail(sizes, areUnit, vertices, triangles, groups, isCurved)
    this.detail = detail
    this.address = detail.address()
    registry.register(this, { bound, detail }, this)
    this.fill(base)
    detail.givenIndices().set(indices)
    detail.setPhases([...phases.sizes], [...phases.steps], [...phases.fronts])
    detail.begin()
    this.readCounts()
  }

  /** `true` if the wasm has failed, and the mesh is lost. */
  get isBroken(): boolean {
    return this.bound.isBroken
  }

  /** Copies the values of the vertices. */
  fill({ positions, attributes }: DetailBase) {
    this.detail.given(0).set(positions)
    attributes.forEach(({ values }, i) => this.detail.given(i + 1).set(values))
  }

  /** Returns the array for the phases, which `cut` reads. */
  phaseArray(): Float32Array {
    const { bound, address, cutSampleCount } = this
    const at = bound._detail_phases(address) / 4
    return this.views.get(View.Phases, bound.HEAPF32, at, this.phases.size * cutSampleCount)
  }

  /** Cuts sides that are longer than `maxLength`, along which phases change too much, or at fronts. Returns `true` if there were any. */
  cut(maxLength: number): boolean {
    const isCut = Boolean(this.bound._detail_cut(this.address, maxLength))
    if (isCut) this.readCounts()
    return isCut
  }

  /** Tests whether `cut` would cut any sides. */
  isCoarse(maxLength: number): boolean {
    return Boolean(this.bound._detail_is_coarse(this.address, maxLength))
  }

  /** Forgets the warped samples. */
  forgetSamples() {
    this.bound._detail_forget_samples(this.address)
  }

  /** Returns the array for the warped samples. */
  warped(): Float32Array {
    const { bound, address, sampleCount } = this
    const at = bound._detail_warped(address) / 4
    return this.views.get(View.Warped, bound.HEAPF32, at, 3 * sampleCount)
  }

  /** Shows the mesh, whose vertices must be warped. If `listsSamples`, returns the number of other samples that must be warped, too. */
  show(views: readonly number[], listsSamples: boolean): number {
    const { bound, address } = this
    const at = bound._detail_views(address, views.length) / 4
    const floats = bound.HEAPF32
    for (let i = 0; i < views.length; i++) floats[at + i] = views[i]!
    return bound._detail_show(address, Number(listsSamples))
  }

  /** The memory of the wasm as integers. */
  get words(): Uint32Array {
    return this.bound.HEAPU32
  }

  /** Returns where the indices of the samples start that `show` has listed, in `words`. */
  missingSamplesAt(): number {
    return this.bound._detail_missing_samples(this.address) / 4
  }

  /** Divides the mesh. Returns `true` if the arrays changed. */
  update(tolerance: number): boolean {
    return Boolean(this.bound._detail_update(this.address, tolerance))
  }

  /** Tests whether the division will be exact enough if camera and surface change once more as they did before the last update. */
  staysExact(): boolean {
    return Boolean(this.bound._detail_stays_exact(this.address))
  }

  dispose() {
    registry.unregister(this)
    free(this)
  }

  private readCounts() {
    const { detail } = this
    this.sampleCount = detail.sampleCount()
    this.vertexCount = detail.vertexCount()
    this.cutSampleCount = detail.cutSampleCount()
  }
}
