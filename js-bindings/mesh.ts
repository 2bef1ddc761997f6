/**
 * 'warpjet/mesh': loads, warps, subdivides and exports meshes, in browsers and in Node. It has its own wasm module, which is started when it
 * is first used. All functions leave their arguments unchanged.
 */
export { bakeWarp, type BakeOptions } from './mesh/bake.js'
export type { Evaluates } from './mesh/evaluates.js'
export { bakeNormalMap, type NormalMapOptions } from './mesh/normal-map.js'
export { exportGLB } from './mesh/export.js'
export { loadMesh, type LoadAsOptions, type LoadOptions } from './mesh/load.js'
export type { Decoders, DracoDecoderModule, MeshoptDecoder } from './mesh/decoders.js'
export type { Material, Mesh, MeshInput, Picture } from './mesh/mesh-arrays.js'
export type { Plain } from './mesh/geometry.js'
export { subdivide, type AdaptiveOptions, type LevelsOptions } from './mesh/subdivide.js'
/** @internal */
export { fillP5Model, subdivideP5Model, varyGeometry } from './p5/geometry/with-mesh.js'
export { surfaceVariation, type SurfaceVariation } from './mesh/surface-variation.js'
export type { Bytes, Resolve, Source } from './mesh/sources.js'
export { WarpError } from './errors/errors.js'
export type { Uniforms } from './core/inputs/vertices.js'
export type { Attribute, Geometry } from './core/inputs/geometry.js'
