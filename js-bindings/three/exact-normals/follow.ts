/**
 * Lets shadows, culling and rays of a mesh follow the displacement of its material. Before three.js has compiled the material, the
 * displacement is read from a new shader that is passed to the material's `onBeforeCompile`.
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
import { MeshDisplacement } from './mesh-displacement.js'
import { displaceShadow } from './shadow.js'

const followed = new WeakSet<Mesh>()

export function followDisplacement(mesh: Mesh, method: string) {
  if (followed.has(mesh)) return
  followed.add(mesh)
  if (Array.isArray(mesh.material)) {
    console.warn(
      `${method}: ${nameOf(mesh)} has several materials, so its shadows, culling and raycasts ignore their displacement.`,
    )
    return
  }
  const displacement = new MeshDisplacement(mesh)
  followBounds(mesh, displacement)
  followRays(mesh, displacement)
  mesh.customDepthMaterial ??= displaceShadow(
    new MeshDepthMaterial({ depthPacking: RGBADepthPacking }),
    displacement,
  )
  mesh.customDistanceMaterial ??= displaceShadow(new MeshDistanceMaterial(), displacement)
}

type Extent = ReturnType<typeof extentOf>

const extents = new WeakMap<ThreeWarp, Extent>()

/** Returns the function that computes the current extent. Each warp is made for one mesh, so it has one extent. */
function extentFor(warp: ThreeWarp, mesh: Mesh): Extent {
  let extent = extents.get(warp)
  if (!extent) extents.set(warp, (extent = extentOf(warp, mesh)))
  return extent
}

/**
 * Gives the mesh bounds of its displaced surface. Three.js culls by the bounds of an object, if it has any, and otherwise by those of its
 * geometry.
 */
function followBounds(mesh: Mesh, displacement: MeshDisplacement) {
  const bounds = (name: 'boundingSphere' | 'boundingBox', part: 'sphere' | 'box') => {
    let original = (mesh as unknown as Record<string, Sphere | Box3 | null | undefined>)[name]
    return {
      get() {
        const warp = displacement.readForCpu()?.warp
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

function followRays(mesh: Mesh, displacement: MeshDisplacement) {
  wrapMethod<Raycast>(mesh, 'raycast', (original) => {
    const raycasts = new WeakMap<ThreeWarp, Raycast>()
    return function (this: Mesh, raycaster, intersects) {
      const warp = displacement.readForCpu()?.warp
      if (warp && !warp.canRunOnCpu)
        displacement.exact?.warn(
          'moves vertices by values that only the GPU has, so raycasts hit the undisplaced mesh.',
        )
      if (!warp?.canRunOnCpu) return original.call(this, raycaster, intersects)
      let cast = raycasts.get(warp)
      if (!cast)
        raycasts.set(
          warp,
          (cast = raycastOf(warp, mesh, original, () => extentFor(warp, mesh)().sphere)),
        )
      cast(raycaster, intersects)
    }
  })
}
