/** Adds `exactNormals` to p5's sketches on a page that loads warpjet and p5 by script tags. */
import { exactNormals } from './exact-normals.js'

const page = globalThis as unknown as { warpjet?: unknown; p5?: Function }

export function registerExactNormals() {
  if (page.warpjet && typeof page.p5 === 'function')
    Object.assign(page.p5.prototype as object, { exactNormals })
}
