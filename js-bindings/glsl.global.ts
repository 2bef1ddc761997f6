/** What reads shader text, for a <script> tag after the one of p5.warpjet.min.js: adds its names to the global `warpjet`, and
 * `exactNormals` to the sketches of a p5 that is there. */
import * as glsl from './glsl.js'

const globals = globalThis as unknown as {
  warpjet: object
  p5?: (new () => void) & { prototype: object }
}

Object.assign(globals.warpjet, glsl)
if (typeof globals.p5 === 'function')
  Object.assign(globals.p5.prototype, { exactNormals: glsl.exactNormals })
