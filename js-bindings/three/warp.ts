// `warp`: warps an object of three.js, with its shadows, bounds and raycasts.
import { Box3, Matrix4, type Intersection, type Object3D, type Raycaster } from 'three'
import { movedBox } from './extent.js'
import { updateOf, type Warped } from './material.js'
import type { Part } from './part.js'
import { readOptions, type ThreeOffset, type WarpOptions } from './settings.js'
import { ThreeWarp } from './three-warp.js'
import type { ThreeUniforms, ValuesOf } from './uniforms.js'
import { WarpedTree } from './warped-tree.js'

export interface WarpedObject<Uniforms = {}> extends Warped<Uniforms> {
  /** Returns a box around everything that is drawn now, in the local space of the object. The box may be too large, but never too small. It is
   * infinite if only the GPU can evaluate the warp, or if the warp or a vertex is not finite. */
  bounds(): Box3
  /** Adds hits on the warped surface to `intersects`. A `Raycaster` calls it. */
  raycast(raycaster: Raycaster, intersects: Intersection[]): void
  /** The objects in a group that cannot be warped, such as sprites, and are drawn as they are. */
  readonly skipped: readonly Object3D[]
}

/**
 * Warps a mesh, points or lines, or everything in a group: moves every vertex by the offset, transforms normals and tangents by
 * its derivative, and lets shadows, culling and rays follow. Geometries and materials stay as they are, and may change or be
 * replaced at any time. Clones of the object, and objects that are added to it later, are warped, too.
 *
 * Throws a `WarpError` for an object that cannot be warped, such as a sprite, for an offset that returns no vec3 or misuses an
 * operation, and for wrong options. Works with WebGPURenderer, too, if you import 'warpjet/three/webgpu'.
 */
export function warp<const Uniforms extends ThreeUniforms = {}>(
  object: Object3D,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpedObject<ValuesOf<Uniforms>> {
  const settings = readOptions('warp', options)
  const tree = new WarpedTree(object, settings, () => new ThreeWarp(offset as never, settings))
  return {
    uniforms: tree.warp.handles as never,
    normals: tree.warp.normals,
    update: updateOf(tree.warp),
    bounds: () => boundsOf(object, tree.parts),
    raycast: (raycaster, intersects) =>
      tree.parts.forEach(({ raycast }) => raycast(raycaster, intersects)),
    skipped: tree.skipped,
    dispose: () => tree.dispose(),
  }
}

/** Returns the bounds of all parts in the local space of the warped object. */
function boundsOf(root: Object3D, parts: readonly Part[]) {
  const toRoot = new Matrix4().copy(root.matrixWorld).invert()
  const all = new Box3()
  for (const { object, bounds } of parts) {
    const box = bounds()
    const isRoot = object === (root as unknown)
    all.union(
      isRoot ? box : movedBox(box, new Matrix4().multiplyMatrices(toRoot, object.matrixWorld)),
    )
  }
  return all
}
