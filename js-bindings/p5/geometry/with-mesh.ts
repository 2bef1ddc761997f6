/** The functions of the addon that need the mesh module. 'warpjet/mesh' exports them for the single script. */
export { fillP5Model } from './model.js'
export { subdivideP5Model } from './subdivide-geometry.js'
export { varyGeometry } from './vary-geometry.js'
