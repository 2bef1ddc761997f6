/**
 * The script for a <script> tag, before or after p5's own tag. If a page loads it twice, the first one stays in effect, with
 * everything that was added to its global `warpjet`.
 */
import { didYouMean, throwingPrototype } from './errors/nearest.js'
import * as library from './global.js'
import { withSketchLine } from './p5/page/places.js'
import { registerGlobally } from './p5/page/register.js'
import { addScript, namesInOtherScripts } from './p5/page/scripts.js'
import { explainUncaughtErrors } from './p5/page/uncaught.js'

const globals = globalThis as {
  warpjet?: Partial<typeof library>
  AutoDiff?: unknown
  p5?: unknown
}

// `warpjet` may also be an element with that id, since elements with an id are globals.
const loadedVersion = globals.warpjet?.version
if (loadedVersion === undefined) start()
// A page with two versions of p5 may load this script after each of them.
else if (loadedVersion === library.version && globals.p5) registerGlobally()
else if (loadedVersion !== library.version)
  console.warn(
    `warpjet: this page has scripts of two versions, ${loadedVersion} and then ${library.version}; only the first one has an effect, so remove one of them.`,
  )

function start() {
  globals.warpjet = Object.setPrototypeOf(
    { ...library },
    throwingPrototype(throwForMissingName),
  ) as typeof library
  // glsl-autodiff's global, so that sketches written for it run unchanged.
  globals.AutoDiff ??= { gen: library.gen }
  if (typeof document === 'object') explainUncaughtErrors()
  if (registerGlobally() || typeof document === 'undefined') return
  if (document.readyState === 'complete') setTimeout(warnWithoutP5)
  else addEventListener('load', warnWithoutP5)
}

/** Throws for a name that the global `warpjet` does not have. The message contains the sketch's line. */
function throwForMissingName(name: string): string {
  return withSketchLine(() => {
    const script = addScript(name)
    const names = [...Object.keys(globals.warpjet!), ...namesInOtherScripts]
    throw new library.WarpError(
      `warpjet.${name}: ${script ? `no script of this page has it; ${script}.` : `there is no such function; ${didYouMean(name, names, `the functions are ${names.join(', ')}.`)}`}`,
    )
  })
}

function warnWithoutP5() {
  if (globals.p5 === undefined)
    console.warn(
      "warpjet: there is no p5 on this page, which createWarp needs; add p5's script, version 1.11 or newer. A page without p5 needs warpjet.min.js instead.",
    )
}
