/**
 * The option `detail` on the WebGPU backend: compute passes divide a mesh, and one indirect call, whose arguments the passes write, draws
 * it. The CPU divides the mesh until the passes are compiled, and where they cannot divide it.
 */
import { Matrix3, type BufferGeometry, type InstancedMesh, type Material, type Mesh } from 'three'
import type { DetailViews } from '../../detail/detailed-mesh.js'
import type { ComputeDivision } from '../../detail/gpu/compute-division.js'
import type { ComputedDetail } from '../../detail/gpu/computed-detail.js'
import type { World } from '../../detail/gpu/measure-wgsl.js'
import type { ComputeDetail, ComputeInput } from '../detail/compute.js'
import type { Render } from '../detail/render.js'
import { placeOf } from '../detail/views.js'
import { disposeIndirect, indirectGeometry, type Backend } from './indirect-geometry.js'

/** The compute passes that divide the mesh in a renderer. */
interface Computed {
  readonly renderer: object
  readonly backend: Backend
  /** Missing until the code of the passes is loaded. */
  detail?: ComputedDetail
}

interface Drawn {
  readonly division: ComputeDivision
  readonly version: number
  readonly geometry: BufferGeometry
}

export class ComputedMesh implements ComputeDetail {
  /** The passes for the first renderer with a WebGPU backend. The CPU divides the mesh for other renderers. */
  private computed: Computed | undefined
  private drawn: Drawn | undefined

  constructor(private readonly input: ComputeInput) {}

  geometryFor(render: Render, views: DetailViews): BufferGeometry | undefined {
    const { warp, object, toWorld } = this.input
    const { computed } = this
    if (!computed?.detail || render.renderer !== computed.renderer || !this.isPossible(render))
      return undefined
    const division = computed.detail.divide({
      given: warp.given,
      views,
      tolerance: warp.settings.detail!.tolerance,
      toSpace: toWorld,
      place: placeOf(warp, object),
      instances: (object as InstancedMesh).count ?? 1,
    })
    return division && this.geometryOf(computed, division)
  }

  takeOver(render: Render) {
    if (!this.isPossible(render)) return
    const { renderer } = render
    const { backend } = renderer as { backend?: Backend }
    if (!this.computed && backend?.isWebGPUBackend) {
      this.computed = { renderer, backend }
      void this.load(this.computed)
    }
    if (renderer === this.computed?.renderer) this.computed.detail?.takeOver()
  }

  dispose() {
    this.disposeDrawn()
    this.computed?.detail?.release()
    this.computed = undefined
  }

  /** Loads the code of the passes. If that fails, the CPU goes on dividing the mesh. */
  private async load(computed: Computed) {
    const { warp, mesh, base, toWorld } = this.input
    const { device } = computed.backend
    const world = toWorld && this.world()
    try {
      const { ComputedDetail, compilePasses } = await import('./compute-passes.js')
      // If this was disposed of meanwhile, nothing reads `computed` any more.
      computed.detail = new ComputedDetail(warp, mesh, device, () =>
        compilePasses(device, warp, base, { world }),
      )
    } catch {
      return
    }
  }

  private world(): World {
    const { matrixWorld } = this.input.object
    const matrix = new Matrix3()
    return {
      position: () => matrixWorld.elements,
      normal: () => matrix.getNormalMatrix(matrixWorld).elements,
      hasUnitNormals: true,
    }
  }

  /** Returns whether an indirect call can draw the object: such calls draw neither groups nor wireframes. */
  private isPossible({ scene }: Render) {
    const { material } = this.input.object as Mesh
    const materials = [material, scene.overrideMaterial]
    return (
      !Array.isArray(material) &&
      !materials.some((each) => (each as (Material & { wireframe?: boolean }) | null)?.wireframe)
    )
  }

  private geometryOf({ backend }: Computed, division: ComputeDivision): BufferGeometry {
    const { drawn } = this
    const { version } = division
    if (drawn?.division === division && drawn.version === version) return drawn.geometry
    this.disposeDrawn()
    const { base, object } = this.input
    const geometry = indirectGeometry(backend, base, object.geometry, division.divided)
    this.drawn = { division, version, geometry }
    return geometry
  }

  private disposeDrawn() {
    if (this.drawn) disposeIndirect(this.drawn.geometry, this.input.base)
    this.drawn = undefined
  }
}
