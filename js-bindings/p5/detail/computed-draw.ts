/**
 * Shapes on WEBGPU that compute passes divide: each draw of a shape in a frame has a mesh of its own, whose buffers an indirect call
 * draws. The CPU divides the shape until the passes are compiled, and wherever they cannot do it.
 */
import { lazily, type HostWarp } from '../../compile/hosts.js'
import type { DetailedMesh } from '../../detail/detailed-mesh.js'
import type { ComputeDivision } from '../../detail/gpu/compute-division.js'
import { ComputedDetail, type ComputedFrame } from '../../detail/gpu/computed-detail.js'
import { compilePasses } from '../../detail/gpu/passes.js'
import type { GpuBuffer } from '../../detail/gpu/webgpu.js'
import type { Renderer } from '../host.js'
import { drawsWarpedLines } from '../strokes.js'
import { deviceOf, type ShapeBuffers } from './buffers.js'
import { canDrawIndirectly, type BufferPart } from './indirect.js'
import type { ShapeBase } from './shape.js'
import { normalMatrixOf } from './views.js'

/** The passes for all draws of a shape with a shader. The draws differ in their matrices. */
export class ShapePasses {
  /** The matrix of the present draw that transforms the shape into the space of the offset; empty if that is the space of the shape. */
  place: readonly number[] = []
  private readonly compile

  private constructor(
    private readonly renderer: Renderer,
    private readonly warp: HostWarp,
    private readonly base: ShapeBase,
  ) {
    this.compile = lazily(() => {
      const world = {
        position: () => this.place,
        normal: () => normalMatrixOf(this.place),
        hasUnitNormals: false,
      }
      return compilePasses(deviceOf(renderer)!, warp, base, {
        world: this.place.length ? world : undefined,
        isPlanar: true,
      })
    })
  }

  /** Returns `undefined` if the CPU has to divide the shape, such as one with groups: passes would also draw the triangles that stand for lines. */
  static of(renderer: Renderer, warp: HostWarp, base: ShapeBase): ShapePasses | undefined {
    const isPossible = deviceOf(renderer) && canDrawIndirectly(renderer) && !base.groups
    return isPossible ? new ShapePasses(renderer, warp, base) : undefined
  }

  draw(mesh: DetailedMesh): ComputedDraw {
    const { renderer, warp, base, compile } = this
    return new ComputedDraw(
      renderer,
      base,
      new ComputedDetail(warp, mesh, deviceOf(renderer)!, compile),
    )
  }
}

/** A shape that an indirect call draws. */
export interface IndirectShape {
  readonly buffers: ShapeBuffers
  /** The arguments of the call. */
  readonly drawn: GpuBuffer
}

export class ComputedDraw {
  private last:
    | { readonly division: ComputeDivision; readonly version: number; shape: IndirectShape }
    | undefined

  constructor(
    private readonly renderer: Renderer,
    private readonly base: ShapeBase,
    private readonly detail: ComputedDetail,
  ) {}

  /** Divides the shape for this draw. Returns `undefined` if the CPU has to, as for warped lines: they follow the triangles that it makes. */
  divide(frame: Omit<ComputedFrame, 'instances'>): IndirectShape | undefined {
    if (drawsWarpedLines(this.renderer)) return undefined
    const division = this.detail.divide({ ...frame, instances: 1 })
    if (!division) return undefined
    const { version } = division
    if (this.last?.division !== division || this.last.version !== version)
      this.last = { division, version, shape: this.shapeOf(division) }
    return this.last.shape
  }

  /** Called when the CPU has divided the shape. */
  takeOver() {
    if (!drawsWarpedLines(this.renderer)) this.detail.takeOver()
  }

  /** Frees the buffers of the draw. */
  release() {
    this.detail.release()
    this.last = undefined
  }

  private shapeOf({ divided }: ComputeDivision): IndirectShape {
    const { layout, vertices, indices, drawn, room } = divided
    const { positionBuffer, buffers } = this.base
    const names = [positionBuffer, ...buffers.map(({ dst }) => dst)]
    const parts = names.map((name, i): [string, BufferPart] => [
      name,
      { buffer: vertices, offset: 4 * layout.startOf(i, room.vertices) },
    ])
    return {
      buffers: { ...Object.fromEntries(parts), indexBuffer: indices, indexFormat: 'uint32' },
      drawn,
    }
  }
}
