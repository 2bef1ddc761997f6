/** Makes `exactNormals` a function of sketches on a page whose scripts are warpjet's and p5's. */
import { exactNormals } from './exact-normals.js'

const page = globalThis as unknown as { warpjet?: unknown; p5?: Function }

export function registerExactNormals() {
  if (page.warpjet && typeof page.p5 === 'function')
    Object.assign(page.p5.prototype as object, { exactNormals })
}
