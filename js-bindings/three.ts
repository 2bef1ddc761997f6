/**
 * 'warpjet/three': warps what three.js draws with WebGLRenderer, and with WebGPURenderer where
 * 'warpjet/three/webgpu' is imported too. `three` is the application's own, from 0.159 on.
 */
export { warp, type WarpedObject } from './three/warp.js'
export { warpMaterial, type Warped, type WarpedMaterial } from './three/material.js'
export { exactNormals, type ExactNormalsOptions } from './three/exact-normals/exact-normals.js'
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
