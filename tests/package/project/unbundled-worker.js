// Does the same as worker.js. Imports files by their paths, since workers have no import map.
import { loadMesh } from './node_modules/warpjet/dist/mesh.js'
import { compileWarp } from './node_modules/warpjet/dist/warpjet.js'

const mesh = await loadMesh(new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'))
const { positions } = compileWarp(({ position }) => position.mult(0)).evaluate(mesh)
postMessage(`drawn ${positions.slice(3, 6)}`)
