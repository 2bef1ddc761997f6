/** A render call of three.js, as it is passed to the hooks of a scene. */
import type { Camera, Scene, Vector2 } from 'three'

/** The members that this folder needs of both renderers. */
export interface Renderer {
  getDrawingBufferSize(target: Vector2): Vector2
  getPixelRatio(): number
  readonly shadowMap: { readonly enabled: boolean }
  readonly isWebGPURenderer?: boolean
}

/** The arguments of `scene.onBeforeRender`. */
export interface Render {
  readonly renderer: Renderer
  readonly scene: Scene
  readonly camera: Camera
  readonly target: { readonly width: number; readonly height: number } | null
}
