// The variants of one warp: one for each material that its objects are drawn with.
import type { BufferGeometry, Material } from 'three'
import { nameOf, nameOfMaterial } from './describe.js'
import type { Warpable } from './pose.js'
import { isWarpedMaterial, unsupportedMaterial } from './supported.js'
import type { ThreeWarp } from './three-warp.js'
import { Variant } from './variant.js'

/** Variants by material; `undefined` for a material that cannot be warped. */
type ByMaterial = WeakMap<Material, Variant | undefined>

export class Variants {
  private readonly plain: ByMaterial = new WeakMap()
  private readonly byOwnMaterial = new WeakMap<Material, ByMaterial>()
  private readonly all = new Set<WeakRef<Variant>>()
  private readonly readsColor: boolean

  constructor(readonly warp: ThreeWarp) {
    this.readsColor = warp.reads('color')
  }

  /** Returns the variant that draws `object` in place of `material`; `undefined` if the material cannot be warped. */
  get(material: Material, object: Warpable): Variant | undefined {
    const variants = this.readsColor ? this.forOwnMaterial(object) : this.plain
    const variant = variants.get(material)
    if (variant !== undefined || variants.has(material)) return variant
    const created = this.create(material, object)
    variants.set(material, created)
    return created
  }

  /** Frees all programs, and lets go of the materials. */
  dispose() {
    for (const variant of this.all) variant.deref()?.dispose()
    this.all.clear()
  }

  /**
   * Returns the variants of objects with the same own material: the warp may read its color, even where another material draws the
   * object's shadow.
   */
  private forOwnMaterial(object: Warpable): ByMaterial {
    const own = ownMaterialOf(object)
    let variants = this.byOwnMaterial.get(own)
    if (!variants) this.byOwnMaterial.set(own, (variants = new WeakMap()))
    return variants
  }

  private create(material: Material, object: Warpable): Variant | undefined {
    const problem = unsupportedMaterial(material, this.warp.settings.space)
    if (problem) {
      // A material that warpMaterial has warped draws the warp already.
      if (!isWarpedMaterial(material))
        console.error(
          `${this.warp.settings.method}: ${nameOfMaterial(material)} of ${nameOf(object)} is drawn without the warp: ${problem}.`,
        )
      return undefined
    }
    const variant = new Variant(material, this.warp, {
      material: ownMaterialOf(object),
      hasColors: this.readsColor && hasColors(object),
      name: `${nameOfMaterial(material)} of ${nameOf(object)}`,
    })
    this.all.add(new WeakRef(variant))
    return variant
  }
}

const ownMaterialOf = ({ material }: Warpable): Material => [material].flat()[0]!

const hasColors = (object: Warpable) =>
  ownMaterialOf(object).vertexColors && 'color' in (object.geometry as BufferGeometry).attributes
