// Warnings on the console, once per warp.
import type { ThreeWarp } from './three-warp.js'

const warned = new WeakSet<ThreeWarp>()

/** Warns why normals are computed at vertices although the option asks for pixels. `name` names the material and its object. */
export function warnOfVertices(warp: ThreeWarp, name: string, obstacle: string) {
  if (warned.has(warp)) return
  warned.add(warp)
  console.warn(
    `${warp.settings.method}: the normals of ${name} are computed at vertices, although the option normals is 'pixel': ${obstacle}.`,
  )
}
