export { WarpError } from '#warp-error'
export { describe, describeShape, shorten } from './describe.js'
