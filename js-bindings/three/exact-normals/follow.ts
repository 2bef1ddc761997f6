/**
 * Lets shadows, culling and rays of a mesh follow the displacement of its material. What three.js has not compiled yet is read from the
 * material's `onBeforeCompile`, which is called with a shader of its own for that.
 */
import {
  MeshDepthMaterial,
  MeshDistanceMaterial,
  RGBADepthPacking,
  type Box3,
  type Mesh,
  type Sphere,
} from 'three'
import { nameOf } from '../describe.js'
import { extentOf } from '../extent.js'
import { replaceProperties, wrapMethod } from '../properties.js'
import { raycastOf, type Raycast } from '../rays.js'
import type { ThreeWarp } from '../three-warp.js'
import { MeshReading } from './mesh-reading.js'
import { putShadow } from './shadow.js'

const followed = new WeakSet<Mesh>()

export function followDisplacement(mesh: Mesh, method: string) {
  if (followed.has(mesh)) return
  followed.add(mesh)
  if (Array.isArray(mesh.material)) {
    console.warn(
      `${method}: ${nameOf(mesh)} has several materials, so that its shadows, culling and rays stay as they are.`,
    )
    return
  }
  const reading = new MeshReading(mesh)
  followBounds(mesh, reading)
  followRays(mesh, reading)
  mesh.customDepthMaterial ??= putShadow(
    new MeshDepthMaterial({ depthPacking: RGBADepthPacking }),
    reading,
  )
  mesh.customDistanceMaterial ??= putShadow(new MeshDistanceMaterial(), reading)
}

type Extent = ReturnType<typeof extentOf>

const extents = new WeakMap<ThreeWarp, Extent>()

/** Returns a function for the present extent. A reading belongs to one mesh. */
function extentFor(warp: ThreeWarp, mesh: Mesh): Extent {
  let extent = extents.get(warp)
  if (!extent) extents.set(warp, (extent = extentOf(warp, mesh)))
  return extent
}

/** Three.js culls by the bounds of an object, if it has any, and otherwise by those of its geometry. */
function followBounds(mesh: Mesh, reading: MeshReading) {
  const bounds = (name: 'boundingSphere' | 'boundingBox', part: 'sphere' | 'box') => {
    let original = (mesh as unknown as Record<string, Sphere | Box3 | null | undefined>)[name]
    return {
      get() {
        const warp = reading.onCpu()?.warp
        return warp ? extentFor(warp, mesh)()[part] : original
      },
      set: (assigned: typeof original) => void (original = assigned),
    }
  }
  replaceProperties(mesh, {
    boundingSphere: bounds('boundingSphere', 'sphere'),
    boundingBox: bounds('boundingBox', 'box'),
  })
}

function followRays(mesh: Mesh, reading: MeshReading) {
  wrapMethod<Raycast>(mesh, 'raycast', (original) => {
    const made = new WeakMap<ThreeWarp, Raycast>()
    return function (this: Mesh, raycaster, intersects) {
      const warp = reading.onCpu()?.warp
      if (warp && !warp.runs)
        reading.exact?.warn(
          'moves vertices by values that only the GPU has, so rays meet the mesh without its displacement.',
        )
      if (!warp?.runs) return original.call(this, raycaster, intersects)
      let cast = made.get(warp)
      if (!cast)
        made.set(
          warp,
          (cast = raycastOf(warp, mesh, original, () => extentFor(warp, mesh)().sphere)),
        )
      cast(raycaster, intersects)
    }
  })
}
