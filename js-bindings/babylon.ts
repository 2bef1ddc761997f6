/**
 * 'warpjet/babylon': a warp as a plugin of a material of Babylon.js. `@babylonjs/core` is the application's own, from 9.34 on.
 */
export type { BabylonWarpOptions } from './babylon/options.js'
export { BabylonWarp } from './babylon/warp.js'
export { addSurfaceVariation } from './babylon/variation.js'
export { WarpError } from './errors/errors.js'
