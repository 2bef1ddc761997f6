// Connects `warp` to both renderers: WebGLRenderer, and WebGPURenderer once 'warpjet/three/webgpu' is imported.
import type { Material, Mesh, Object3D, WebGLRenderer } from 'three'
import { WarpError } from '../errors/errors.js'
import { nameOf, nameOfMaterial } from './describe.js'
import type { ComputeDetail, ComputeInput } from './detail/compute.js'
import { wrapRenderer } from './draw.js'
import type { Settings } from './settings.js'
import { unsupportedMaterial } from './supported.js'
import type { ThreeWarp } from './three-warp.js'

/** The functions of 'warpjet/three/webgpu' that `warp` calls. */
export interface Nodes {
  check: (method: string, material: Material, object?: Mesh) => void
  /** Makes WebGPURenderer warp an object, or all objects with a material; call the returned function to stop. */
  attachWarp: (target: Object3D | Material, warp: ThreeWarp) => () => void
  /** Tests whether a renderer belongs to the copy of three.js whose methods are replaced. */
  isOurs: (renderer: unknown) => boolean
  computeDivision: (input: ComputeInput) => ComputeDetail
}

let nodes: Nodes | undefined

/** Called by 'warpjet/three/webgpu': 'warpjet/three' itself cannot import 'three/tsl', which three.js 0.159 lacks. */
export const provideNodes = (provided: Nodes) => void (nodes = provided)

const isForNodes = (material: Material) =>
  (material as { isNodeMaterial?: boolean }).isNodeMaterial === true

/** Says why an object cannot be drawn warped with a material, for a message; `undefined` if it can. */
export function problemOf(
  { method, space }: Settings,
  material: Material,
  object: Object3D,
): string | undefined {
  if (!nodes || !isForNodes(material)) {
    const problem = unsupportedMaterial(material, space)
    return (
      problem && `${nameOfMaterial(material)} of ${nameOf(object)} cannot be warped: ${problem}`
    )
  }
  try {
    nodes.check(method, material, object as Mesh)
  } catch (error) {
    return (error as Error).message.replace(/^\w+: |\.$/g, '')
  }
  return undefined
}

/** Makes WebGPURenderer, if it is imported, warp an object or all objects with a material; call the returned function to stop. */
export const attachToWebGPU = (target: Object3D | Material, warp: ThreeWarp): (() => void) =>
  nodes?.attachWarp(target, warp) ?? (() => {})

/** Returns an object that divides a mesh by compute passes; `undefined` if WebGPURenderer is not imported. */
export const computeDivision = (input: ComputeInput): ComputeDetail | undefined =>
  nodes?.computeDivision(input)

/** Prepares a renderer that is about to draw a warped object. Throws if the renderer cannot draw the object warped. */
export function prepareRenderer(
  renderer: WebGLRenderer,
  { settings: { method } }: ThreeWarp,
  object: Object3D,
) {
  if (!('isWebGPURenderer' in renderer)) return wrapRenderer(renderer)
  if (!nodes)
    throw new WarpError(
      `${method}: ${nameOf(object)} is drawn by WebGPURenderer; import 'warpjet/three/webgpu' once, before it is warped.`,
    )
  if (!nodes.isOurs(renderer))
    throw new WarpError(
      `${method}: ${nameOf(object)} is drawn by a renderer of another copy of three.js than 'warpjet/three/webgpu' imports; let both resolve to one 'three/webgpu'.`,
    )
}
