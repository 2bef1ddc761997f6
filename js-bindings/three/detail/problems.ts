/** Finds out whether an object can be divided. */
import {
  IntType,
  type BatchedMesh,
  type InstancedBufferGeometry,
  type InstancedMesh,
  type Mesh,
} from 'three'
import { onlyOnGpu } from '../../detail/warnings.js'
import { isInstancedMesh2 } from '../instances.js'
import { isSkinned, morphTextureOf, type Warpable } from '../pose.js'
import type { ThreeWarp } from '../three-warp.js'
import { isOfBones } from './base.js'

export const hasPose = (object: Warpable) =>
  isSkinned(object) ||
  Object.values(object.geometry.morphAttributes).some((targets) => targets.length > 0)

/** Describes why an object is drawn with its own vertices; `undefined` if it is divided. */
export function problemOf(warp: ThreeWarp, object: Warpable): string | undefined {
  const { attributes } = object.geometry
  const { isInstancedMesh } = object as InstancedMesh
  if (!(object as Mesh).isMesh) return 'points and lines are not divided'
  if ((object as BatchedMesh).isBatchedMesh || isInstancedMesh2(object))
    return 'the geometries of a batch are not divided'
  if (hasPose(object) && warp.settings.space === 'rest')
    return "bones or morph targets move the warped surface in the space 'rest'"
  if (morphTextureOf(object)) return 'each instance has morph targets of its own'
  if ((object.geometry as InstancedBufferGeometry).isInstancedBufferGeometry)
    return 'an InstancedBufferGeometry is not divided'
  if (isInstancedMesh && warp.settings.space === 'world')
    return "in the space 'world' each instance has a surface of its own"
  if (!warp.canRunOnCpu) return onlyOnGpu
  for (const name of ['position', 'normal', 'uv'] as const)
    if ((name === 'position' || warp.reads(name)) && !attributes[name])
      return `its geometry lacks the attribute "${name}"`
  const integers = Object.entries(attributes).find(
    ([name, each]) => isInteger(each) && !(isSkinned(object) && isOfBones(name)),
  )
  return integers && `the attribute "${integers[0]}" consists of whole numbers`
}

/** Tests whether shaders read the attribute as whole numbers, which cannot be interpolated. */
const isInteger = (attribute: object) => (attribute as { gpuType?: number }).gpuType === IntType
