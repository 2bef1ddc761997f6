/**
 * 'warpjet/p5' where p5 cannot load, such as on a server, and as a separate file. It registers itself with a global p5, which p5's
 * script tag defines. If p5 is imported as a module, call `warpjet(p5)`.
 */
import { registerGlobally } from './p5/page/register.js'

export { warpjet as default, warpjet as setupWarp, createWarp } from './p5/addon.js'
export type { Loading, Warping } from './p5/addon.js'
export type { Distort } from './p5/create-warp.js'
export type { LoadModelOptions, ModelOf, WarpModel } from './p5/geometry/load-model.js'
export type { CreateWarpOptions, WarpSpace, WarpType } from './p5/settings.js'
export type { NormalStage, NormalsOption } from './compile/hosts.js'
export { registerGlobally } from './p5/page/register.js'
export type { WarpUniforms } from './p5/sketch-uniforms.js'

registerGlobally()
