/** Computes the views of a `DetailedMesh` in a render call. */
import {
  BackSide,
  FrontSide,
  Matrix4,
  Vector2,
  Vector3,
  type ArrayCamera,
  type Camera,
  type InstancedMesh,
  type Material,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
} from 'three'
import type { DetailViews } from '../../detail/detailed-mesh.js'
import type { ThreeWarp } from '../three-warp.js'
import type { Render } from './render.js'
import { shadowCamerasOf, type SizedCamera } from './shadows.js'

/** The max number of instances that have views. The others share the division that the nearest ones need, although one that is seen from another side may need more. */
const maxInstances = 16

const size = new Vector2()
const matrix = new Matrix4()
const instanceMatrix = new Matrix4()
const place = new Vector3()
const eye = new Vector3()

/** Returns the numbers that samples depend on, other than the inputs of the warp. */
export const placeOf = ({ settings }: ThreeWarp, { matrixWorld }: Object3D): readonly number[] =>
  settings.space === 'world' ? matrixWorld.elements : []

export function viewsOf(warp: ThreeWarp, object: Mesh, render: Render): DetailViews {
  const { camera } = render
  const instances = nearestInstances(object, camera)
  const facing = facingOf(warp, object, render, instances)
  const views: number[] = []
  const shadowCameras = castsShadow(object, render) ? shadowCamerasOf(render) : []
  for (const { camera: shownBy, width, height } of [...camerasOf(render), ...shadowCameras])
    for (const instance of instances) {
      matrix.multiplyMatrices(shownBy.projectionMatrix, shownBy.matrixWorldInverse)
      if (warp.settings.space !== 'world') {
        matrix.multiply(object.matrixWorld)
        if (instance !== undefined) {
          ;(object as InstancedMesh).getMatrixAt(instance, instanceMatrix)
          matrix.multiply(instanceMatrix)
        }
      }
      views.push(...matrix.elements, width / 2, height / 2, facing)
    }
  return views
}

/** Returns the cameras of a render call, and the sizes of their pictures in pixels. */
function camerasOf({ renderer, camera, target }: Render): SizedCamera[] {
  if (target) size.set(target.width, target.height)
  else renderer.getDrawingBufferSize(size)
  const { x: width, y: height } = size
  const { isArrayCamera, cameras } = camera as ArrayCamera
  if (!isArrayCamera) return [{ camera, width, height }]
  const ratio = renderer.isWebGPURenderer && !target ? renderer.getPixelRatio() : 1
  return cameras.map((camera) => {
    const { viewport } = camera as PerspectiveCamera & { viewport?: { z: number; w: number } }
    return viewport
      ? { camera, width: ratio * viewport.z, height: ratio * viewport.w }
      : { camera, width, height }
  })
}

/** Returns the indices of up to 16 instances; `[undefined]` for a mesh without instances. */
function nearestInstances(object: Mesh, camera: Camera): (number | undefined)[] {
  const { isInstancedMesh, count } = object as InstancedMesh
  if (!isInstancedMesh) return [undefined]
  const all = Array.from({ length: count }, (_, i) => i)
  if (count <= maxInstances) return all
  eye.setFromMatrixPosition(camera.matrixWorld)
  const distances = all.map((i) => {
    ;(object as InstancedMesh).getMatrixAt(i, instanceMatrix)
    place.setFromMatrixPosition(instanceMatrix).applyMatrix4(object.matrixWorld)
    // A larger instance looks like a nearer one.
    return place.distanceToSquared(eye) / Math.abs(instanceMatrix.determinant()) ** (2 / 3)
  })
  return all.sort((a, b) => distances[a]! - distances[b]!).slice(0, maxInstances)
}

const castsShadow = ({ castShadow }: Mesh, { renderer }: Render) =>
  castShadow && renderer.shadowMap.enabled

/** Returns 1 or -1 if triangles that show one side are never drawn, otherwise 0: see `DetailViews`. */
function facingOf(
  warp: ThreeWarp,
  object: Mesh,
  render: Render,
  instances: readonly unknown[],
): number {
  if (castsShadow(object, render)) return 0
  if (instances.length < ((object as InstancedMesh).count ?? 1)) return 0
  const sides = [render.scene.overrideMaterial ?? object.material]
    .flat()
    .map((each: Material) => each.side)
  const isOnly = (side: number) => sides.every((each) => each === side)
  const facing = isOnly(FrontSide) ? 1 : isOnly(BackSide) ? -1 : 0
  const isReversed = object.matrixWorld.determinant() < 0
  return warp.isMirroredNow() === isReversed ? facing : -facing
}
