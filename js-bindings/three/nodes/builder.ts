// The part of three's NodeBuilder that we use.
import type { Material, Mesh } from 'three'

/** Builds the shaders of an object. */
export interface Builder {
  context: Record<string, unknown>
  getFrontFacing(): string
  isFlatShading(): boolean
  needsPreviousData(): boolean
  addNode(node: unknown): void
  addSequentialNode(node: unknown): void
  object: Mesh
  geometry: Mesh['geometry']
  material: Material
  renderer: {
    backend: {
      gl?: WebGL2RenderingContext
      isWebGPUBackend?: boolean
      createNodeBuilder?(object: unknown, renderer: unknown): unknown
      device?: { limits?: { maxInterStageShaderVariables?: number } }
    }
  }
}
