/** The divided mesh of the last frame, which rays meet. Converts hits on its triangles to hits on the user's triangles. */
import {
  BufferAttribute,
  BufferGeometry,
  Triangle,
  Vector3,
  type Intersection,
  type Mesh,
} from 'three'
import type { DetailedMesh } from '../../detail/detailed-mesh.js'
import type { Warpable } from '../pose.js'
import type { GeometryBase } from './base.js'

export interface DrawnSurface {
  /** The object with its divided geometry, which morph targets and bones have moved already. */
  readonly object: Warpable
  toOwnTriangle(hit: Intersection): Intersection
}

/** `base` is the mesh that was divided, as morph targets and bones have moved it. */
export function drawnSurfaceOf(
  object: Warpable,
  base: GeometryBase,
  mesh: DetailedMesh,
): DrawnSurface {
  const geometry = new BufferGeometry()
  for (const { name, size, attribute } of base.buffers.flat())
    geometry.setAttribute(name, new BufferAttribute(mesh.values(attribute).slice(), size))
  geometry.setIndex(new BufferAttribute(mesh.indices().slice(), 1))
  addGroups(geometry, base, mesh)
  const origins = mesh.origins()
  return {
    object: Object.create(object, {
      geometry: { value: geometry },
      isSkinnedMesh: { value: false },
    }) as Mesh,
    toOwnTriangle(hit) {
      const { faceIndex, face, barycoord } = hit as Intersection & { barycoord?: Vector3 | null }
      if (face == null || faceIndex == null) return hit
      const origin = origins[faceIndex]!
      const [a, b, c] = [0, 1, 2].map((i) => base.indices[3 * origin + i]!) as Corners
      if (barycoord) {
        const before = pointOf(geometry.attributes.position!, face, barycoord)
        triangle.setFromAttributeAndIndices(new BufferAttribute(base.positions, 3), a, b, c)
        triangle.getBarycoord(before, barycoord)
      }
      return { ...hit, faceIndex: base.faces[origin]!, face: { ...face, a, b, c } }
    },
  }
}

type Corners = [number, number, number]

const triangle = new Triangle()

/** Returns the point of a triangle before the triangle is warped. */
function pointOf(positions: object, { a, b, c }: { a: number; b: number; c: number }, at: Vector3) {
  triangle.setFromAttributeAndIndices(positions as BufferAttribute, a, b, c)
  return new Vector3()
    .addScaledVector(triangle.a, at.x)
    .addScaledVector(triangle.b, at.y)
    .addScaledVector(triangle.c, at.z)
}

/** Adds a group for each material, if there are several. */
export function addGroups(geometry: BufferGeometry, base: GeometryBase, mesh: DetailedMesh) {
  const starts = mesh.groups()
  const all = mesh.indices().length
  geometry.clearGroups()
  base.materials.forEach(({ materialIndex }, i) => {
    const start = 3 * starts[i]!
    const end = i + 1 < starts.length ? 3 * starts[i + 1]! : all
    geometry.addGroup(start, end - start, materialIndex)
  })
}
