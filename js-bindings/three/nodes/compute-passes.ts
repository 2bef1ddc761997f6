// The compute passes of the option `detail`, in a separate file, which ComputedMesh loads when a mesh first needs it.
export { ComputedDetail } from '../../detail/gpu/computed-detail.js'
export { compilePasses } from '../../detail/gpu/passes.js'
