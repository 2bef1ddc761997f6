// Names of three.js objects, for messages.
import type { Material, Object3D } from 'three'
import { WarpError, describe } from '../errors/errors.js'

const flags = ['isObject3D', 'isMaterial', 'isBufferGeometry', 'isTexture']

/** Describes an object of three.js by its type, as in `a BoxGeometry`, and other values like `describe`. */
export function describeOfThree(value: unknown): string {
  const properties = (value ?? {}) as Record<string, unknown>
  const isOfThree = flags.some((flag) => properties[flag] === true)
  return isOfThree && typeof properties.type === 'string' ? `a ${properties.type}` : describe(value)
}

/** Returns `the Mesh "boat"`, or `this Mesh` if it has no name. */
export const nameOf = ({ name, type }: Object3D) =>
  name ? `the ${type} "${name}"` : `this ${type}`

/** Returns `the MeshStandardMaterial "wood"`, or `the MeshStandardMaterial` if it has no name. */
export const nameOfMaterial = ({ name, type }: Material) =>
  name ? `the ${type} "${name}"` : `the ${type}`

export const spriteError = (method: string, what: string) =>
  new WarpError(
    `${method}: ${what} always faces the camera and has no surface to warp; use a Mesh with a PlaneGeometry.`,
  )
