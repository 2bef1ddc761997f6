/** The interface that 'warpjet/three/webgpu' implements to divide a mesh by compute passes. */
import type { BufferGeometry } from 'three'
import type { DetailViews, DetailedMesh, ToSpace } from '../../detail/detailed-mesh.js'
import type { Warpable } from '../pose.js'
import type { ThreeWarp } from '../three-warp.js'
import type { GeometryBase } from './base.js'
import type { Render } from './render.js'

export interface ComputeInput {
  readonly warp: ThreeWarp
  readonly object: Warpable
  readonly mesh: DetailedMesh
  readonly base: GeometryBase
  readonly toWorld: ToSpace | undefined
}

export interface ComputeDetail {
  /** Divides the mesh for a render call. Returns `undefined` if the CPU has to. */
  geometryFor(render: Render, views: DetailViews): BufferGeometry | undefined
  /** Called when the CPU has divided the mesh for a render call. Compute passes take over with the next one, if they can. */
  takeOver(render: Render): void
  /** Frees the buffers of the divided mesh. */
  dispose(): void
}
