// The surface variation of a mesh, in vertex buffers: how its normals and texture coordinates change along the surface.
import { Buffer, VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import { Material } from '@babylonjs/core/Materials/material.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { variationAttribute, variationNames, type HostWarp } from '../compile/hosts.js'
import { describe } from '../errors/errors.js'
import { Place } from '../options/place.js'

/** The kinds of these vertex buffers: three for the normal, then two for the texture coordinates. */
export const variationKinds = variationNames.map(variationAttribute)

/** Returns the kinds of those buffers that a mesh has, if the warp reads them. */
export const variationOf = ({ varies }: HostWarp, mesh: AbstractMesh) =>
  varies ? variationKinds.filter((kind) => mesh.isVerticesDataPresent(kind)) : []

/**
 * Computes how normal and uv vary over a mesh and adds this to the mesh as vertex buffers. Then the warped normals are exact also for
 * offsets that depend on normal or uv, such as offsets along the normal. Call `await addSurfaceVariation(mesh)` once, before the mesh is
 * drawn. Loads 'warpjet/mesh'. Returns the mesh.
 *
 * @throws {WarpError} for a mesh without vertices.
 */
export async function addSurfaceVariation<Kind extends Mesh>(mesh: Kind): Promise<Kind> {
  const read = (kind: string) => (mesh as Partial<Mesh> | undefined)?.getVerticesData?.(kind)
  const positions = read(VertexBuffer.PositionKind)
  if (!positions)
    throw new Place('addSurfaceVariation').expected(
      'a mesh of Babylon.js with vertices',
      describe(mesh),
    )
  const [normals, uvs] = [read(VertexBuffer.NormalKind), read(VertexBuffer.UVKind)]
  const indices = mesh.getIndices()
  const { surfaceVariation } = await import('../mesh/surface-variation.js')
  const variation = surfaceVariation({
    positions: Float32Array.from(positions),
    ...(normals && { normals: Float32Array.from(normals) }),
    ...(uvs && { uvs: Float32Array.from(uvs) }),
    ...(indices && { indices: Uint32Array.from(indices) }),
  })
  const lists = variationNames.flatMap((name) => variation[`${name}s`] ?? [])
  // All vectors are in one buffer, since WebGPU allows only 8 buffers per draw.
  const stride = 3 * lists.length
  const numbers = new Float32Array(lists.length * positions.length)
  lists.forEach((list, index) => {
    for (let i = 0; i < list.length; i += 3)
      numbers.set(list.subarray(i, i + 3), (i / 3) * stride + 3 * index)
  })
  const buffer = new Buffer(mesh.getEngine(), numbers, false, stride)
  lists.forEach((_, i) =>
    mesh.setVerticesBuffer(buffer.createVertexBuffer(variationKinds[i]!, 3 * i, 3)),
  )
  mesh.material?.markAsDirty(Material.AttributesDirtyFlag)
  return mesh
}
