// Names of three.js objects, for messages.
import type { Material, Object3D } from 'three'
import { WarpError, describe } from '../errors/errors.js'

const flags = ['isObject3D', 'isMaterial', 'isBufferGeometry', 'isTexture']

/** `a BoxGeometry`, `a MeshBasicMaterial`; what is not of three.js as everywhere else. */
export function describeOfThree(value: unknown): string {
  const given = (value ?? {}) as Record<string, unknown>
  const isOfThree = flags.some((flag) => given[flag] === true)
  return isOfThree && typeof given.type === 'string' ? `a ${given.type}` : describe(value)
}

/** `the Mesh "boat"`, or `this Mesh`. */
export const nameOf = ({ name, type }: Object3D) =>
  name ? `the ${type} "${name}"` : `this ${type}`

/** `the MeshStandardMaterial "wood"`, or `the MeshStandardMaterial`. */
export const nameOfMaterial = ({ name, type }: Material) =>
  name ? `the ${type} "${name}"` : `the ${type}`

export const spriteError = (method: string, what: string) =>
  new WarpError(
    `${method}: ${what} always faces the camera and has no surface to warp; use a Mesh with a PlaneGeometry.`,
  )
