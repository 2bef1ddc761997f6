// 'warpjet/autodiff': a drop-in replacement for glsl-autodiff.
export { gen } from './compile/compile.js'
export type { GenSettings } from './compile/compile.js'
export type {
  Glsl as AD,
  Scalar as Op,
  Scalar as Param,
  Vector as VectorOp,
} from './core/types/types.js'
