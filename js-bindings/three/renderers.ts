// What three.js draws with: WebGLRenderer, and WebGPURenderer once 'warpjet/three/webgpu' is imported, which brings what it needs.
import type { Material, Mesh, Object3D, WebGLRenderer } from 'three'
import { WarpError } from '../errors/errors.js'
import { nameOf } from './describe.js'
import { wrapRenderer } from './draw.js'
import type { Woven } from './material.js'
import type { WarpSpace } from './settings.js'
import { unsupportedMaterial } from './supported.js'
import type { ThreeWarp } from './three-warp.js'

/** How WebGPURenderer has a warp: as a node. */
export interface Nodes {
  check: (method: string, material: Material) => void
  obstacle: (space: WarpSpace, object: Mesh) => string | undefined
  weave: (given: Material, warp: ThreeWarp, made?: Material) => Woven
}

let nodes: Nodes | undefined

/** Called by 'warpjet/three/webgpu': three.js 0.159 has no 'three/tsl' that 'warpjet/three' could import. */
export const provideNodes = (given: Nodes) => void (nodes = given)

const isForNodes = (material: Material) =>
  (material as { isNodeMaterial?: boolean }).isNodeMaterial === true

/** Says why a material of an object cannot be warped, for a message; `undefined` if it can. */
export function problemOf(method: string, material: Material): string | undefined {
  if (!nodes || !isForNodes(material)) return unsupportedMaterial(material)
  try {
    nodes.check(method, material)
  } catch (error) {
    return (error as Error).message
  }
  return undefined
}

/** Draws an object warped with WebGPURenderer, if that is imported; call the result to end that. */
export function carryByNodes(object: Mesh, warp: ThreeWarp): () => void {
  if (!nodes) return () => {}
  const { weave } = nodes
  const before = object.material
  const woven: Woven[] = []
  const weaveOne = (material: Material) => {
    const one = weave(material, warp)
    woven.push(one)
    return one.material
  }
  const after = (object.material = Array.isArray(before) ? before.map(weaveOne) : weaveOne(before))
  return () => {
    for (const { restore } of woven) restore()
    if (object.material === after) object.material = before
  }
}

/** Prepares a renderer that is about to draw a warped object; throws if it cannot draw it warped. */
export function prepareRenderer(
  renderer: WebGLRenderer,
  { settings: { method, space } }: ThreeWarp,
  object: Object3D,
) {
  if (!('isWebGPURenderer' in renderer)) return wrapRenderer(renderer)
  const problem = nodes
    ? nodes.obstacle(space, object as Mesh)
    : `${nameOf(object)} is drawn by WebGPURenderer; import 'warpjet/three/webgpu' once, before it is warped`
  if (problem) throw new WarpError(`${method}: ${problem}.`)
}
