// Connects `warp` to both renderers: WebGLRenderer, and WebGPURenderer once 'warpjet/three/webgpu' is imported.
import type { Material, Mesh, Object3D } from 'three'
import { WarpError } from '../errors/errors.js'
import { noteReplaced } from '../errors/notes.js'
import type { ThreeWarp } from './three-warp.js'
import { nameOf } from './describe.js'
import { type Woven, checkMaterial, weaveInto } from './material.js'

/** The functions of 'warpjet/three/webgpu' that `warp` calls. */
export interface Nodes {
  check: (method: string, material: Material, object?: Mesh) => void
  /** Draws an object warped, with whichever material; call the result to end that. */
  carryObject: (object: Object3D, warp: ThreeWarp) => () => void
  /** Draws all objects that have the material warped; call the result to end that. */
  carryMaterial: (material: Material, warp: ThreeWarp) => () => void
  /** Tests whether a renderer is of the three.js whose methods are replaced. */
  isOurs: (renderer: unknown) => boolean
}

let nodes: Nodes | undefined

/** For 'warpjet/three/webgpu': three.js 0.159 has no 'three/tsl' that 'warpjet/three' could import. */
export const provideNodes = (given: Nodes) => void (nodes = given)

const isOfNodes = (material: unknown) =>
  (material as { isNodeMaterial?: boolean } | undefined)?.isNodeMaterial === true

export function checkForAll(
  method: string,
  material: unknown,
  object?: Mesh,
): asserts material is Material {
  if (nodes && isOfNodes(material)) nodes.check(method, material as Material, object)
  else checkMaterial(method, material)
}

/** Weaves a material for WebGLRenderer. WebGPURenderer needs the material only if it is shared: it finds the warp by the object. */
export function weaveForAll(given: Material, warp: ThreeWarp): Woven {
  const ofNodes = nodes && isOfNodes(given)
  const woven = ofNodes ? { material: given, restore() {} } : weaveInto(given, warp)
  const release = warp.settings.isShared && nodes ? nodes.carryMaterial(given, warp) : undefined
  return {
    material: woven.material,
    restore() {
      release?.()
      woven.restore()
    },
  }
}

/** Draws an object warped with WebGPURenderer, if that is imported; call the result to end that. */
export const carryByNodes = (object: Object3D, warp: ThreeWarp): (() => void) =>
  nodes?.carryObject(object, warp) ?? (() => {})

/** Makes the `onBeforeRender` of a warped object. It throws for a renderer that cannot draw it warped. */
export function refusing(
  { method }: { method: string },
  object: Mesh,
  isReplaced: () => boolean,
): Mesh['onBeforeRender'] {
  const { onBeforeRender } = object
  const present = nodes
  let isNoted = false
  return function (this: Mesh, renderer, ...others) {
    if ('isWebGPURenderer' in renderer) {
      if (!present)
        throw new WarpError(
          `${method}: ${nameOf(object)} is drawn by WebGPURenderer; import 'warpjet/three/webgpu' once, before it is warped.`,
        )
      if (!present.isOurs(renderer))
        throw new WarpError(
          `${method}: ${nameOf(object)} is drawn by a renderer of another copy of three.js than 'warpjet/three/webgpu' imports; let both resolve to one 'three/webgpu'.`,
        )
    } else if (!isNoted && isReplaced()) {
      isNoted = true
      noteReplaced(method, nameOf(object))
    }
    onBeforeRender.call(this, renderer, ...others)
  }
}
