/**
 * The option `detail` on the WebGPU backend: compute passes divide a mesh, and one indirect call draws it. The CPU divides it until
 * they are compiled, and wherever they cannot do it.
 */
import { Matrix3, type BufferGeometry, type InstancedMesh, type Material, type Mesh } from 'three'
import type { DetailViews } from '../../detail/detailed-mesh.js'
import type { ComputeDivision } from '../../detail/gpu/compute-division.js'
import type { CutWatch } from '../../detail/gpu/cut-watch.js'
import type { World } from '../../detail/gpu/measure-wgsl.js'
import type { Passes } from '../../detail/gpu/passes.js'
import type { GpuDevice } from '../../detail/gpu/webgpu.js'
import type { ComputeDetail, ComputeInput } from '../detail/compute.js'
import type { Render } from '../detail/render.js'
import { placeOf } from '../detail/views.js'
import type * as ComputePasses from './compute-passes.js'
import { disposeIndirect, indirectGeometry, sizesOf, type Backend } from './indirect-geometry.js'

interface Compiled {
  readonly backend: Backend
  readonly device: GpuDevice
  readonly passes: Passes
  readonly code: typeof ComputePasses
}

interface Drawn {
  readonly division: ComputeDivision
  readonly geometry: BufferGeometry
  readonly version: number
  /** The version of the mesh from which it was made. */
  readonly baseVersion: number
  readonly watch: CutWatch
}

export class ComputedMesh implements ComputeDetail {
  /** The renderer that compute passes are for. The CPU divides the mesh for others. */
  private renderer: object | undefined
  private compiled: Compiled | undefined
  private drawn: Drawn | undefined

  constructor(private readonly input: ComputeInput) {}

  geometryFor(render: Render, views: DetailViews): BufferGeometry | undefined {
    const { warp, object, mesh, toWorld } = this.input
    const { drawn } = this
    if (!drawn || render.renderer !== this.renderer || !this.isPossible(render)) return undefined
    const { division, baseVersion, watch } = drawn
    // A ray can have cut the mesh.
    if (mesh.baseVersion !== baseVersion) {
      this.release()
      return undefined
    }
    const state = mesh.stateOf(warp.given, placeOf(warp, object))
    if (watch.isCoarse(warp.given, state, toWorld)) return undefined
    const { count = 1 } = object as InstancedMesh
    division.update(warp.given, state, views, warp.settings.detail!.tolerance, count)
    if (!division.isTooLarge) return this.geometryNow(drawn)
    this.release()
    this.compiled = undefined
    return undefined
  }

  takeOver(render: Render) {
    const { warp, object, mesh, base } = this.input
    if (!this.isPossible(render)) return
    if (this.drawn && render.renderer === this.renderer) {
      // The CPU has tried to cut the mesh. If it did not, there would be too many triangles.
      if (this.drawn.baseVersion === mesh.baseVersion) return this.drawn.watch.stop()
      this.release()
    }
    const { backend: present } = render.renderer as { backend?: Backend }
    if (!this.renderer && present?.isWebGPUBackend) {
      this.renderer = render.renderer
      void this.compile(present)
    }
    if (!this.compiled || render.renderer !== this.renderer) return
    const { backend, device, passes, code } = this.compiled
    const parts = mesh.parts()
    const division = code.ComputeDivision.of(device, passes, mesh, parts, sizesOf(base))
    if (!division) {
      this.compiled = undefined
      return
    }
    const geometry = indirectGeometry(backend, base, object.geometry, division.divided)
    const watch = new code.CutWatch(warp.surfacePhases(), parts)
    const { baseVersion } = mesh
    this.drawn = { division, geometry, version: division.version, baseVersion, watch }
  }

  dispose() {
    this.release()
    this.renderer = this.compiled = undefined
  }

  /** A failure leaves everything to the CPU. */
  private async compile(backend: Backend) {
    const { renderer } = this
    const { warp, base, toWorld } = this.input
    const { device } = backend
    try {
      const code = await import('./compute-passes.js')
      const passes = await code.compilePasses(device, warp, base, toWorld && this.world())
      // It may have been disposed of meanwhile.
      if (this.renderer === renderer) this.compiled = { backend, device, passes, code }
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
    }
  }

  /** Indirect calls draw neither groups nor lines of a wireframe. */
  private isPossible({ scene }: Render) {
    const { material } = this.input.object as Mesh
    const materials = [material, scene.overrideMaterial]
    return (
      !Array.isArray(material) &&
      !materials.some((each) => (each as (Material & { wireframe?: boolean }) | null)?.wireframe)
    )
  }

  private geometryNow(drawn: Drawn): BufferGeometry {
    const { division, geometry, version } = drawn
    if (version === division.version) return geometry
    const { base, object } = this.input
    disposeIndirect(geometry, base)
    const grown = indirectGeometry(this.compiled!.backend, base, object.geometry, division.divided)
    this.drawn = { ...drawn, geometry: grown, version: division.version }
    return grown
  }

  private release() {
    if (!this.drawn) return
    disposeIndirect(this.drawn.geometry, this.input.base)
    this.drawn.division.destroy()
    this.drawn = undefined
  }
}
