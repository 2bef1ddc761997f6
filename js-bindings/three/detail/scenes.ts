/**
 * Draws the objects of a scene divided: their geometries are exchanged when a render call begins, before three.js lists what it draws,
 * and restored when it ends. The shadows are drawn in between.
 */
import type { Camera, Object3D, Scene } from 'three'
import { wrapMethod } from '../properties.js'
import type { Render, Renderer } from './render.js'

/** An object that is drawn divided. */
export interface Divisible {
  readonly object: Object3D
  /** Exchanges the geometry of the object for the divided one. */
  divide(render: Render): void
  restore(): void
}

type Hook = (
  this: Scene,
  renderer: Renderer,
  scene: Scene,
  camera: Camera,
  target: Render['target'],
) => void

const hooksOf = new WeakMap<Scene, SceneHooks>()

/** Divides an object whenever the scene is rendered, until the returned function is called. */
export function addToScene(scene: Scene, part: Divisible): () => void {
  let hooks = hooksOf.get(scene)
  if (!hooks) hooksOf.set(scene, (hooks = new SceneHooks(scene)))
  hooks.parts.add(part)
  return () => {
    part.restore()
    hooks.parts.delete(part)
    if (hooks.parts.size > 0 || hooksOf.get(scene) !== hooks) return
    hooksOf.delete(scene)
    hooks.release()
  }
}

/** Returns the outermost scene that contains an object. */
export function sceneOf(object: Object3D): Scene | undefined {
  let scene: Scene | undefined
  for (let each: Object3D | null = object; each; each = each.parent)
    if ((each as Scene).isScene) scene = each as Scene
  return scene
}

class SceneHooks {
  readonly parts = new Set<Divisible>()
  readonly release: () => void
  /** The render call for which geometries are exchanged now. */
  private current: Render | undefined

  constructor(scene: Scene) {
    const begin = (render: Render) => this.begin(render)
    const end = (renderer: Renderer, camera: Camera) => this.end(renderer, camera)
    const stops = [
      wrapMethod<Hook>(scene, 'onBeforeRender', (own) => {
        return function (renderer, rendered, camera, target) {
          // The user's own function is called first, since it may move objects.
          own.call(this, renderer, rendered, camera, target)
          begin({ renderer, scene, camera, target })
        }
      }),
      wrapMethod<Hook>(scene, 'onAfterRender', (own) => {
        return function (renderer, rendered, camera, target) {
          end(renderer, camera)
          own.call(this, renderer, rendered, camera, target)
        }
      }),
    ]
    this.release = () => stops.forEach((stop) => stop())
  }

  /** Nested render calls, such as those of shadows and mirrors, draw what the outer one has divided. */
  private begin(render: Render) {
    if (this.current) return
    this.current = render
    // Three.js does not call onAfterRender after a render call that throws, nor after `compileAsync`.
    queueMicrotask(() => this.current === render && this.restore())
    for (const part of this.parts) part.divide(render)
  }

  private end(renderer: Renderer, camera: Camera) {
    if (this.current?.renderer === renderer && this.current.camera === camera) this.restore()
  }

  private restore() {
    this.current = undefined
    for (const part of this.parts) part.restore()
  }
}
