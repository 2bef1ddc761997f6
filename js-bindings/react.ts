/**
 * 'warpjet/react': `<Warp>` for @react-three/fiber. The application provides `react`, `@react-three/fiber` and `three`.
 */
export { Warp, type WarpProps } from './three/react/warp.js'
export type { ThreeOffset, WarpSpace } from './three/settings.js'
export type {
  ThreeUniform,
  ThreeUniforms,
  UniformHandle,
  UniformHandles,
  ValuesOf,
} from './three/uniforms.js'
export type { WarpedObject } from './three/warp.js'
export { WarpError } from './errors/errors.js'
