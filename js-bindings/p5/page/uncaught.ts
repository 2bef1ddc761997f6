/**
 * Explains uncaught errors on a page of script tags: shows a WarpError by p5's friendly errors, which don't know this class, and gives
 * advice when one of our names is not defined.
 */
import { placeOf } from './places.js'
import { addScript, isAmong } from './scripts.js'

const methods = 'createWarp warpBox loadWarpModel addSurfaceVariation subdivide exactNormals'

const globals = globalThis as unknown as {
  warpjet: object
  p5?: { prototype: object; _friendlyError?: (message: string) => void }
}

/** The browsers' messages about an undefined name. */
const notDefined = /^(?:Can't find variable: (\w+)|(\w+) is not defined)$/

function adviceFor(name: string): string | undefined {
  if (/^(vec|mat)[234]$/.test(name)) return `write glsl.${name}`
  if (isAmong('glsl position normal uv uniforms instance', name))
    return `it is an argument of the offset function, as in ({ ${name} }) => …`
  const isMethod = isAmong(methods, name)
  if (isMethod && globals.p5 && name in globals.p5.prototype)
    return `call it in setup(), or, in instance mode, as p.${name}(…)`
  if (Object.hasOwn(globals.warpjet, name))
    return `write warpjet.${name}, or before it const { ${name} } = warpjet`
  const script = addScript(name)
  return script && (isMethod ? script : `${script}, and write warpjet.${name}`)
}

function explain(error: unknown) {
  if (!(error instanceof Error)) return
  const [, ...found] = notDefined.exec(error.name === 'ReferenceError' ? error.message : '') ?? []
  const name = found.find(Boolean)
  const advice = name && adviceFor(name)
  if (!advice && error.name !== 'WarpError') return
  const message = advice ? `${name} is not defined: ${advice}.${placeOf(error)}` : error.message
  const { p5 } = globals
  if (p5?._friendlyError) p5._friendlyError(message)
  else if (advice) console.warn(message)
}

/** Starts to listen for uncaught errors. */
export function explainUncaughtErrors() {
  addEventListener('error', ({ error }) => explain(error))
  addEventListener('unhandledrejection', ({ reason }) => explain(reason))
}
