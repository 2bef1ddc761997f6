/** Registers the addon with a p5 that is a global of the page, whichever of the two scripts loads first. */
import { warpjet } from '../addon.js'

const globals = globalThis as { p5?: unknown }

/** Registers with p5 if p5 is a global, and returns whether it is one. If not, registers as soon as p5 becomes a global. */
export function registerGlobally(): boolean {
  const { p5 } = globals
  if (typeof p5 === 'function') {
    warpjet(p5)
    return true
  }
  if (typeof document === 'object') waitForP5()
  return false
}

/** Uses a setter, since any event is too late: on a page that has already loaded, p5 starts the sketch right after its script. */
function waitForP5() {
  Object.defineProperty(globals, 'p5', {
    configurable: true,
    enumerable: true,
    get: () => undefined,
    set(value: unknown) {
      Object.defineProperty(globals, 'p5', { value, writable: true })
      if (typeof value === 'function') warpjet(value)
    },
  })
}
