/** `'warpjet/glsl'`: warps and derivatives from shader text. */
export { WarpError } from './checks/errors.js'
export { glslOffset, type GlslOffsetOptions, type GlslOptions } from './glsl/offset.js'
