// The Stanford bunny from the package draco3dgltf, as the only primitive of a GLB file.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { GltfWriter } from './writer.js'

export function bunnyFile() {
  const bytes = readFileSync(createRequire(import.meta.url).resolve('draco3dgltf/bunny.drc'))
  const writer = new GltfWriter()
  const bufferView = writer.view(new Uint8Array(bytes))
  const POSITION = writer.add('accessors', { componentType: 5126, count: 34834, type: 'VEC3' })
  const indices = writer.add('accessors', { componentType: 5125, count: 208353, type: 'SCALAR' })
  writer.extension('KHR_draco_mesh_compression')
  writer.mesh(
    { POSITION },
    {
      indices,
      extensions: { KHR_draco_mesh_compression: { bufferView, attributes: { POSITION: 0 } } },
    },
  )
  writer.node({ mesh: 0 })
  return writer.glb().file
}
