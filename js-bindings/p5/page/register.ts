/** The addon for a p5 that is a global of the page, whichever of the two comes first. */
import { warpjet } from '../addon.js'

const globals = globalThis as { p5?: unknown }

/** Registers with p5 if it is a global, and says whether it was. If not, it does so as soon as p5 becomes one. */
export function registerGlobally(): boolean {
  const { p5 } = globals
  if (typeof p5 === 'function') {
    warpjet(p5)
    return true
  }
  if (typeof document === 'object') waitForP5()
  return false
}

/** No event would do: where the page has loaded already, p5 starts the sketch right after its script. */
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
