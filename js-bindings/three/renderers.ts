// What three.js draws with: WebGLRenderer, and WebGPURenderer once 'warpjet/three/webgpu' is imported, which brings what it needs.
import type { Material, Mesh } from 'three'
import { WarpError } from '../errors/errors.js'
import { noteReplaced } from '../errors/notes.js'
import type { ThreeWarp } from './kept.js'
import { nameOf } from './describe.js'
import { type Woven, checkMaterial, weaveInto } from './material.js'
import type { WarpSpace } from './settings.js'

/** How WebGPURenderer has a warp: as a node. */
export interface Nodes {
  check: (method: string, material: Material) => void
  /** What it cannot do with an object in a space, for a sentence. */
  obstacle: (space: WarpSpace, object: Mesh) => string | undefined
  /** Puts the node into `made`, a material for this warp alone unless it is shared. */
  weave: (given: Material, warp: ThreeWarp, made?: Material) => Woven
}

let nodes: Nodes | undefined

/** For 'warpjet/three/webgpu': three.js 0.159 has no 'three/tsl' that 'warpjet/three' could import. */
export const provideNodes = (given: Nodes) => void (nodes = given)

const isOfNodes = (material: unknown) =>
  (material as { isNodeMaterial?: boolean } | undefined)?.isNodeMaterial === true

export function checkForAll(method: string, material: unknown): asserts material is Material {
  if (nodes && isOfNodes(material)) nodes.check(method, material as Material)
  else checkMaterial(method, material)
}

/** For each renderer that there is; which of them draws it turns out when it does. */
export function weaveForAll(given: Material, warp: ThreeWarp): Woven {
  if (nodes && isOfNodes(given)) return nodes.weave(given, warp)
  const woven = weaveInto(given, warp)
  const node = nodes?.weave(given, warp, woven.material)
  return {
    material: woven.material,
    restore() {
      if (warp.settings.isShared) node?.restore()
      woven.restore()
    },
  }
}

/** Of an object that is warped now: throws when a renderer comes that would draw it as it was, or otherwise, and says once if
 * its material is another than at first. */
export function refusing(
  { method, space }: { method: string; space: WarpSpace },
  object: Mesh,
  isReplaced: () => boolean,
): Mesh['onBeforeRender'] {
  const { onBeforeRender } = object
  const present = nodes
  let isNoted = false
  return function (this: Mesh, renderer, ...others) {
    if (!isNoted && isReplaced()) {
      isNoted = true
      noteReplaced(method, nameOf(object))
    }
    if ('isWebGPURenderer' in renderer) {
      const problem = present
        ? present.obstacle(space, object)
        : "the object is drawn by WebGPURenderer; import 'warpjet/three/webgpu' once, before it is warped"
      if (problem) throw new WarpError(`${method}: ${problem}.`)
    }
    onBeforeRender.call(this, renderer, ...others)
  }
}
