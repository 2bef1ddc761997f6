// The compute passes of the option `detail`, a file of its own: ComputedMesh loads it when a mesh first needs it.
export { ComputedDetail } from '../../detail/gpu/computed-detail.js'
export { compilePasses } from '../../detail/gpu/passes.js'
