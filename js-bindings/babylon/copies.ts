// Copies of a warp: `material.clone()` and `Parse` of Babylon.js make a plugin from the name of its class and from plain data,
// which cannot contain an offset function. So the data contain an id, under which the warp is stored as long as its material exists.
import type { Material } from '@babylonjs/core/Materials/material.js'
import { Tools } from '@babylonjs/core/Misc/tools.js'
import { RegisterClass } from '@babylonjs/core/Misc/typeStore.js'

/** A warp that can be copied onto another material. */
export interface CopyableWarp {
  copyOnto(material: Material): unknown
}

const warps = new Map<string, CopyableWarp>()

/** Stores a warp under a new id. The caller must call `forget` when the warp's material is disposed. */
export function remember(warp: CopyableWarp) {
  const id = Tools.RandomId()
  warps.set(id, warp)
  return { id, forget: () => void warps.delete(id) }
}

/** Takes the place of a plugin while Babylon.js parses a material. `parse` is the only method that Babylon.js calls for this. */
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
