/**
 * The single script for a <script> tag, which may stand before or after p5's own tag. Whatever comes of a second one of the
 * same page, the first one stays, with what was added to it.
 */
import * as library from './global.js'
import { didYouMean, refusing } from './errors/nearest.js'
import { withSketchLine } from './p5/page/places.js'
import { registerGlobally } from './p5/page/register.js'
import { addScript, namesInOtherScripts } from './p5/page/scripts.js'
import { explainUncaughtErrors } from './p5/page/uncaught.js'

const globals = globalThis as {
  warpjet?: Partial<typeof library>
  AutoDiff?: unknown
  p5?: unknown
}

// A page has its elements among its globals, by their ids.
const present = globals.warpjet?.version
if (present === undefined) start()
// It may stand after each of two versions of p5.
else if (present === library.version && globals.p5) registerGlobally()
else if (present !== library.version)
  console.warn(
    `warpjet: this page has scripts of two versions, ${present} and then ${library.version}; the first one counts, so leave one of them out.`,
  )

function start() {
  globals.warpjet = Object.setPrototypeOf({ ...library }, refusing(elsewhere)) as typeof library
  // glsl-autodiff's global, so that sketches written for it run unchanged.
  globals.AutoDiff ??= { gen: library.gen }
  if (typeof document === 'object') explainUncaughtErrors()
  if (registerGlobally() || typeof document === 'undefined') return
  if (document.readyState === 'complete') setTimeout(missP5)
  else addEventListener('load', missP5)
}

/** With the sketch's line. */
function elsewhere(name: string): string {
  return withSketchLine(() => {
    const script = addScript(name)
    const names = [...Object.keys(globals.warpjet!), ...namesInOtherScripts]
    throw new library.WarpError(
      `warpjet.${name}: ${script ? `no script of this page has it; ${script}.` : `there is no such function; ${didYouMean(name, names, `there are ${names.join(', ')}.`)}`}`,
    )
  })
}

function missP5() {
  if (globals.p5 === undefined)
    console.warn(
      "warpjet: there is no p5 on this page, and createWarp comes with it; add p5's script, version 1.11 or newer. A page without p5 wants warpjet.min.js instead.",
    )
}
