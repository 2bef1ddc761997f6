/**
 * 'warpjet/three/webgpu': what WebGPURenderer needs, on WebGPU and on WebGL 2. Once it is imported, `warp`, the same function as in
 * 'warpjet/three', works with either renderer. `three` is the application's own, from 0.187 on.
 */
export { warp, type WarpedObject } from './three/warp.js'
export { warpMaterial, warpNode, type NodeWarpedMaterial, type WarpNode } from './three/webgpu.js'
export {
  exactNormals,
  type ExactNormalsOptions,
} from './three/nodes/exact-normals/exact-normals.js'
export {
  tslOffset,
  type TslOffset,
  type TslOffsetOptions,
} from './three/nodes/exact-normals/tsl-offset.js'
export type { AnyNode } from './three/nodes/tsl.js'
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
export { WarpError } from './errors/errors.js'
