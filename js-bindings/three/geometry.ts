// Geometries of three.js as the meshes of 'warpjet/mesh', and back.
import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three'
import { arraysOf, geometryAttributes } from '../compile/hosts.js'
import { WarpError, describe } from '../errors/errors.js'
import type { Mesh, MeshInput } from '../mesh/mesh-arrays.js'

/**
 * Converts a geometry to a mesh for `bakeWarp`, `subdivide`, `exportGLB` and the other functions of 'warpjet/mesh'. The mesh
 * shares the geometry's arrays where their types fit. Throws a `WarpError` unless it is a geometry with positions.
 */
export function fromBufferGeometry(geometry: BufferGeometry): Mesh {
  if (!geometry?.isBufferGeometry)
    throw new WarpError(`fromBufferGeometry: expected a BufferGeometry, got ${describe(geometry)}.`)
  if (!geometry.attributes.position)
    throw new WarpError('fromBufferGeometry: the geometry has no attribute "position".')
  return arraysOf(geometry) as unknown as Mesh
}

/**
 * Converts a mesh, as `bakeWarp` and `loadMesh` return it, to a geometry. `like` is the geometry that the mesh was made from: its
 * groups, and its attributes that meshes lack, such as `uv1`, are copied. Throws a `WarpError` if the number of vertices differs,
 * as after `subdivide`.
 */
export function toBufferGeometry(mesh: MeshInput, like?: BufferGeometry): BufferGeometry {
  if (typeof mesh !== 'object' || mesh === null || !mesh.positions)
    throw new WarpError(
      `toBufferGeometry: expected a mesh such as { positions, normals, indices }, got ${describe(mesh)}.`,
    )
  const geometry = new BufferGeometry()
  for (const [name, [attribute, size]] of Object.entries(geometryAttributes)) {
    const numbers = mesh[name as keyof typeof geometryAttributes]
    if (numbers)
      geometry.setAttribute(attribute, new BufferAttribute(Float32Array.from(numbers), size))
  }
  const { indices } = mesh
  if (indices) geometry.setIndex(new BufferAttribute(Uint32Array.from(indices), 1))
  if (like) takeOver(geometry, like)
  return geometry
}

function takeOver(geometry: BufferGeometry, like: BufferGeometry) {
  const { count } = geometry.attributes.position!
  const before = like.attributes.position?.count
  if (before !== count)
    throw new WarpError(
      `toBufferGeometry: the mesh has ${count} vertices and the geometry that it is like ${before}, so that nothing can be taken over; leave the second argument out.`,
    )
  // Interleaved attributes stay so: those of one buffer share its clone.
  const cloned = {}
  for (const [name, attribute] of Object.entries(like.attributes))
    if (!(name in geometry.attributes))
      geometry.setAttribute(name, (attribute as InterleavedBufferAttribute).clone(cloned))
  for (const { start, count, materialIndex } of like.groups)
    geometry.addGroup(start, count, materialIndex)
  geometry.userData = { ...like.userData }
}
