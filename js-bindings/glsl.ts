/**
 * 'warpjet/glsl': warps and derivatives from shader text. It has a wasm module of its own, which starts with the first
 * source, and makes `glsl.source` work wherever an offset function gets `glsl`.
 */
import { registerFrontEnd } from './glsl-source/call.js'
import { registerExactNormals } from './p5/exact-normals/register.js'

export { WarpError } from './errors/errors.js'
export { differentiate, type DifferentiateOptions } from './glsl-source/differentiate.js'
export { exactNormals } from './p5/exact-normals/exact-normals.js'
export { glslOffset, type GlslOffset, type GlslOffsetOptions } from './glsl-source/offset.js'
export type { GlslOptions } from './glsl-source/options.js'

registerFrontEnd()
registerExactNormals()
