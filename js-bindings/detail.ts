/**
 * 'warpjet/detail': meshes with as many triangles as their warped surface needs on the screen, for renderers of your own. Those of p5.js
 * and three.js have it as the option `detail`. Its own wasm module starts when it is first used.
 */
export {
  createDetail,
  type DetailMesh,
  type DetailMeshOptions,
  type DetailUpdate,
  type DetailView,
  type DividedMesh,
} from './detail/create-detail.js'
export { WarpError } from './errors/errors.js'
