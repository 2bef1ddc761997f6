// A module worker that warps a mesh.
import { compileWarp } from 'warpjet'
import { loadMesh } from 'warpjet/mesh'

const mesh = await loadMesh(new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'))
const { positions } = compileWarp(({ position }) => position.mult(0)).evaluate(mesh)
postMessage(`drawn ${positions.slice(3, 6)}`)
