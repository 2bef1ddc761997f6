// Converts geometries of three.js to meshes of 'warpjet/mesh', and back.
import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three'
import { arraysOf, geometryAttributes } from '../compile/hosts.js'
import { WarpError, describe } from '../errors/errors.js'
import type { Mesh, MeshInput } from '../mesh/mesh-arrays.js'

/**
 * Converts a geometry to a mesh for `bakeWarp`, `subdivide`, `exportGLB` and the other functions of 'warpjet/mesh'. The mesh
 * shares the geometry's arrays where their types fit. Throws a `WarpError` unless the argument is a geometry with positions.
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
  if (like) copyFrom(geometry, like)
  return geometry
}

function copyFrom(geometry: BufferGeometry, like: BufferGeometry) {
  const { count } = geometry.attributes.position!
  const likeCount = like.attributes.position?.count
  if (likeCount !== count)
    throw new WarpError(
      `toBufferGeometry: the mesh has ${count} vertices, but the geometry of the second argument has ${likeCount}, so its attributes cannot be copied; leave the second argument out.`,
    )
  // Interleaved attributes stay interleaved: those that share a buffer share its clone.
  const cloned = {}
  for (const [name, attribute] of Object.entries(like.attributes))
    if (!(name in geometry.attributes))
      geometry.setAttribute(name, (attribute as InterleavedBufferAttribute).clone(cloned))
  for (const { start, count, materialIndex } of like.groups)
    geometry.addGroup(start, count, materialIndex)
  geometry.userData = { ...like.userData }
}
