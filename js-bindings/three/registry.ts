// Maps warped objects to the variants that draw them. Renderers look here for each object that they draw.
import type { Material, Object3D } from 'three'
import type { Variants } from './variants.js'

const warped = new WeakMap<Object3D, Variants>()

/** Materials whose objects are all warped: those of the option `share`. */
const shared = new Map<Material, (object: Object3D) => Variants | undefined>()

/** Returns the variants of a warped object, and `undefined` for any other. */
export function variantsOf(object: Object3D): Variants | undefined {
  const variants = warped.get(object)
  return variants === undefined && shared.size > 0 ? adopt(object) : variants
}

export const isWarped = (object: Object3D) => warped.has(object)

export const register = (object: Object3D, variants: Variants) => void warped.set(object, variants)
export const unregister = (object: Object3D) => void warped.delete(object)

/** Warps every object that has the material, from the next time that the object is drawn. */
export const share = (material: Material, adopt: (object: Object3D) => Variants | undefined) =>
  void shared.set(material, adopt)
export const unshare = (material: Material) => void shared.delete(material)

/** Warps an object that has a material of the option `share`, and returns the object's variants. */
function adopt(object: Object3D) {
  const { material } = object as { material?: Material | Material[] }
  const adoptShared = Array.isArray(material)
    ? material.map((each) => shared.get(each)).find((found) => found)
    : material && shared.get(material)
  return adoptShared?.(object)
}
