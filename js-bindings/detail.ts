/**
 * 'warpjet/detail': meshes with as many triangles as their warped surface needs on the screen, for renderers of your own. With p5.js and
 * three.js, use the option `detail` instead. This entry has its own wasm module, which is started when it is first used.
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
