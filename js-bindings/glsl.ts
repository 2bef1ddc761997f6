/**
 * 'warpjet/glsl': warps and derivatives from GLSL and WGSL source. It has its own wasm module, which is started when the first source is
 * parsed. Importing this entry also enables `glsl.source` in offset functions.
 */
import { registerFrontEnd } from './glsl-source/call.js'
import { registerExactNormals } from './p5/exact-normals/register.js'

export { WarpError } from './errors/errors.js'
export { differentiate, type DifferentiateOptions } from './glsl-source/differentiate.js'
export { exactNormals, type ExactNormalsOptions } from './p5/exact-normals/exact-normals.js'
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
