// The materials whose normals follow their positionNode.
import type { Settings } from '../../settings.js'
import type { ExactWarp } from './exact-warp.js'

export interface ExactNodeMaterial {
  settings: Settings
  /** Distinguishes the program from that of a material without, whose nodes may be the same. */
  key: string
  /** Maps the code of a positionNode with textures → the warp that it is, or the message why it cannot be one. */
  warps: Map<string, ExactWarp | string>
  /** The messages that the console has. */
  warned: Set<string>
}

const materials = new WeakMap<object, ExactNodeMaterial>()

/** Returns what a material with `exactNormals` needs; `undefined` for others, and without a positionNode. */
export const exactOf = (material: { positionNode: unknown }): ExactNodeMaterial | undefined =>
  material.positionNode ? materials.get(material) : undefined

export function addExact(material: object, settings: Settings) {
  const key = `exactNormals ${settings.normals}`
  materials.set(material, { settings, key, warps: new Map(), warned: new Set() })
}
