/**
 * 'warpjet/glsl': warps and derivatives from GLSL and WGSL source. Its own wasm module starts with the first source. It also makes
 * `glsl.source` work in offset functions.
 */
import { registerFrontEnd } from './glsl-source/call.js'
import { registerExactNormals } from './p5/exact-normals/register.js'

export { WarpError } from './errors/errors.js'
export { differentiate, type DifferentiateOptions } from './glsl-source/differentiate.js'
export { exactNormals } from './p5/exact-normals/exact-normals.js'
export {
  glslOffset,
  wgslOffset,
  type GlslOffset,
  type GlslOffsetOptions,
  type WgslOffset,
  type WgslOffsetOptions,
} from './glsl-source/offset.js'
export type { GlslOptions } from './glsl-source/options.js'

registerFrontEnd()
registerExactNormals()
