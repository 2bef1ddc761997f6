// Copies of a warp: `material.clone()` and `Parse` of Babylon.js make a plugin from the name of its class and from data that must be plain
// values, so that they cannot contain an offset function. So the data contain an id, by which the warp is found while its material lives.
import type { Material } from '@babylonjs/core/Materials/material.js'
import { Tools } from '@babylonjs/core/Misc/tools.js'
import { RegisterClass } from '@babylonjs/core/Misc/typeStore.js'

/** A warp that can be copied onto another material. */
export interface CopyableWarp {
  copyOnto(material: Material): unknown
}

const warps = new Map<string, CopyableWarp>()

/** Stores a warp under a new id. `forget` must be called when its material is disposed. */
export function remember(warp: CopyableWarp) {
  const id = Tools.RandomId()
  warps.set(id, warp)
  return { id, forget: () => void warps.delete(id) }
}

/** Stands for a plugin while Babylon.js parses a material: has only the method that Babylon.js calls then. */
class ParsedPlugin {
  constructor(private readonly material: Material) {}

  parse({ warpjet }: { warpjet?: string }) {
    const warp = warps.get(warpjet ?? '')
    if (warp) warp.copyOnto(this.material)
    else
      console.warn(
        `BabylonWarp: the material "${this.material.name}" was saved with a warp, whose offset function is not saved; call new BabylonWarp(material, offset) after loading.`,
      )
  }
}

/** Registers the class for parsing under the name with which a warp serializes itself. */
export const registerCopies = (className: string) =>
  RegisterClass(`BABYLON.${className}`, ParsedPlugin)
