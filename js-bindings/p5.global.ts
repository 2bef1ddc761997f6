/**
 * The single script for a <script> tag. Its exports are what the global `warpjet` holds. It may stand before or after
 * p5's own tag: p5 starts a sketch when the page has loaded, which is after DOMContentLoaded.
 */
import { gen } from './index.js'
import { registerGlobally } from './p5.js'

export { WarpError, compile, compileWarp, gen, version } from './index.js'

if (!registerGlobally() && typeof document !== 'undefined')
  document.addEventListener('DOMContentLoaded', registerGlobally)

// glsl-autodiff's global, so that sketches written for it run unchanged.
const globals = globalThis as { AutoDiff?: unknown }
globals.AutoDiff ??= { gen }
