// The materials whose normals follow their positionNode.
import type { ExactNodeSettings, ExactWarp } from './exact-warp.js'

export interface ExactNodeMaterial {
  settings: ExactNodeSettings
  /** Distinguishes the program from that of a material without exact normals, whose nodes may be the same. */
  key: string
  /** Maps the code of a positionNode with textures → its warp, or the message that says why it cannot be read as a warp. */
  warps: Map<string, ExactWarp | string>
  /** The messages that were printed. */
  warned: Set<string>
}

const materials = new WeakMap<object, ExactNodeMaterial>()

/** Returns the data of a material with `exactNormals`; `undefined` for other materials, and for those without a positionNode. */
export const exactOf = (material: { positionNode: unknown }): ExactNodeMaterial | undefined =>
  material.positionNode ? materials.get(material) : undefined

export function addExact(material: object, settings: ExactNodeSettings) {
  const key = `exactNormals ${settings.normals} ${settings.maxIterations}`
  materials.set(material, { settings, key, warps: new Map(), warned: new Set() })
}
