// Copies of a warp: `material.clone()` and `Parse` of Babylon.js make a plugin by the name of its class and data of plain values,
// which cannot hold an offset function. So the data have an id, by which the warp is found while its material lives.
import type { Material } from '@babylonjs/core/Materials/material.js'
import { Tools } from '@babylonjs/core/Misc/tools.js'
import { RegisterClass } from '@babylonjs/core/Misc/typeStore.js'

/** A warp that can be put on another material. */
export interface Copied {
  copyOnto(material: Material): unknown
}

const warps = new Map<string, Copied>()

/** Makes the id of a warp; `forget` is called when its material is disposed. */
export function remember(warp: Copied) {
  const id = Tools.RandomId()
  warps.set(id, warp)
  return { id, forget: () => void warps.delete(id) }
}

/** The class that Babylon.js looks for. It has the methods that are called on a plugin that was just made. */
class Parsed {
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

/** Registers the class under the name that a warp serializes itself with. */
export const registerCopies = (className: string) => RegisterClass(`BABYLON.${className}`, Parsed)
