// The compute passes of the option `detail`, a file of its own: ComputedMesh loads it when a mesh first needs it.
export { ComputeDivision } from '../../detail/gpu/compute-division.js'
export { CutWatch } from '../../detail/gpu/cut-watch.js'
export { compilePasses } from '../../detail/gpu/passes.js'
