/**
 * 'warpjet/three/webgpu': what 'warpjet/three' is, for WebGPURenderer, on WebGPU and on WebGL 2. Like 'three/webgpu' and
 * 'three', which of the two is imported follows the renderer. `three` is the application's own, from 0.187 on.
 */
export {
  warp,
  warpMaterial,
  warpNode,
  type NodeWarpedMaterial,
  type WarpNode,
} from './three/webgpu.js'
export type { AnyNode } from './three/nodes.js'
export type { WarpedObject } from './three/warp.js'
export type { Warped } from './three/material.js'
export { fromBufferGeometry, toBufferGeometry } from './three/geometry.js'
export { addSurfaceVariation } from './three/variation.js'
export type { ThreeOffset, WarpOptions, WarpSpace } from './three/settings.js'
export type {
  ThreeUniform,
  ThreeUniforms,
  UniformHandle,
  UniformHandles,
  ValuesOf,
} from './three/uniforms.js'
export { WarpError } from './checks/errors.js'
