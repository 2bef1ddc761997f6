// The materials whose normals follow their positionNode.
import type { Settings } from '../../settings.js'
import type { ExactWarp } from './exact-warp.js'

export interface ExactMaterial {
  settings: Settings
  /** Maps the code of a positionNode → the warp that it is, or the message why it cannot be one. */
  warps: Map<string, ExactWarp | string>
  /** The messages that the console has. */
  warned: Set<string>
}

const materials = new WeakMap<object, ExactMaterial>()

/** Returns what a material with `exactNormals` needs; `undefined` for others, and without a positionNode. */
export const exactOf = (material: { positionNode: unknown }): ExactMaterial | undefined =>
  material.positionNode ? materials.get(material) : undefined

export function addExact(material: object, settings: Settings) {
  materials.set(material, { settings, warps: new Map(), warned: new Set() })
}
