// Decides in each frame whether compute passes divide a mesh, or the CPU has to: it does until the passes are compiled, and wherever they
// cannot do it.
import type { HostWarp } from '../../compile/host-warp.js'
import type { DrawValues } from '../../compile/offset-warp.js'
import type { DetailViews, DetailedMesh, ToSpace } from '../detailed-mesh.js'
import { ComputeDivision } from './compute-division.js'
import { CutWatch } from './cut-watch.js'
import type { Passes } from './passes.js'
import type { GpuDevice } from './webgpu.js'

/** The values on which a mesh depends in a frame: see `DetailedMesh.update`. */
export interface ComputedFrame {
  readonly given: DrawValues
  readonly views: DetailViews
  readonly tolerance: number
  readonly toSpace?: ToSpace | undefined
  readonly place: readonly number[]
  readonly instances: number
}

/** After the CPU had to cut a mesh, compute passes take it over again when this many frames have left it uncut. */
const framesAfterCut = 4

interface Current {
  readonly division: ComputeDivision
  /** The version of the mesh from which it was made. */
  readonly baseVersion: number
  readonly watch: CutWatch
}

export class ComputedDetail {
  /** Present from the first call of `takeOver` on. */
  private compiling: Promise<Passes> | undefined
  /** `undefined` until the passes are compiled, and if they cannot divide this mesh. */
  private passes: Passes | undefined
  private current: Current | undefined
  private framesToWait = 0
  private lastBaseVersion = -1

  constructor(
    private readonly warp: HostWarp,
    private readonly mesh: DetailedMesh,
    private readonly device: GpuDevice,
    private readonly compile: () => Promise<Passes>,
  ) {}

  /** Divides the mesh for a frame. Returns `undefined` if the CPU has to. */
  divide(frame: ComputedFrame): ComputeDivision | undefined {
    const { mesh, current } = this
    if (!current) return undefined
    const { division, baseVersion, watch } = current
    // Another caller, such as a ray, can have cut the mesh.
    if (mesh.baseVersion !== baseVersion) {
      this.release()
      return undefined
    }
    const { given, views, tolerance, toSpace, place, instances } = frame
    const state = mesh.stateOf(given, place)
    if (watch.isCoarse(given, state, toSpace)) {
      mesh.measureNext()
      return undefined
    }
    if (mesh.hasMovedFronts(given, toSpace, place)) return undefined
    division.update(given, state, views, tolerance, instances)
    if (!division.isTooLarge) return division
    this.release()
    this.passes = undefined
    return undefined
  }

  /** Called when the CPU has divided the mesh. Compute passes take over in the next frame, if they can. */
  takeOver() {
    const { warp, mesh, current, passes } = this
    if (current) {
      // The CPU has tried to cut the mesh. If it did not, there would be too many triangles.
      if (current.baseVersion === mesh.baseVersion) return current.watch.stop()
      this.release()
      this.framesToWait = framesAfterCut
    }
    // The passes measure no kinks.
    if (warp.surfacePhases()?.hasKinks) return
    if (!this.compiling) void this.start()
    if (!passes || this.isWaiting()) return
    const parts = mesh.parts()
    const division = ComputeDivision.of(this.device, passes, mesh, parts)
    if (!division) {
      this.passes = undefined
      return
    }
    const watch = new CutWatch(warp.surfacePhases(), parts)
    this.current = { division, baseVersion: mesh.baseVersion, watch }
  }

  /** Tests whether the mesh was cut in one of the last frames. While a front moves over it, the CPU cuts it again and again. */
  private isWaiting(): boolean {
    const { baseVersion } = this.mesh
    if (this.framesToWait > 0 && baseVersion !== this.lastBaseVersion)
      this.framesToWait = framesAfterCut
    this.lastBaseVersion = baseVersion
    return this.framesToWait > 0 && this.framesToWait-- > 0
  }

  /** Frees the buffers of the division. */
  release() {
    this.current?.division.destroy()
    this.current = undefined
  }

  /** Compiles the passes. If that fails, the CPU divides the mesh in all frames. */
  private async start() {
    try {
      this.passes = await (this.compiling = this.compile())
    } catch {
      return
    }
  }
}
