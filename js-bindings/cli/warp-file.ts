// Loads an offset function from a file of JavaScript, GLSL or WGSL.
import { readFile } from 'node:fs/promises'
import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import { inputSizes } from '../core/inputs/inputs.js'
import type { OffsetFunction, UniformOptions } from '../core/types/types.js'
import { WarpError, describe } from '../errors/errors.js'
import { glslOffset, wgslOffset } from '../glsl-source/offset.js'
import { maxIterationLimit } from '../options/iterations.js'
import { optional, wholeNumber } from '../options/kinds.js'
import { numeric } from './usage.js'

/** The offset function in a file, and its uniforms. */
export interface WarpFile {
  /** The default export, or the only function. */
  offset: OffsetFunction
  /** The option `uniforms` of `compileWarp`. */
  uniforms: UniformOptions | undefined
}

/** Options for `glslOffset` and `wgslOffset` from the command line. */
export interface SourceOptions {
  function?: string | undefined
  returns?: string | undefined
  maxIterations?: number | undefined
}

/** The flags of the command line for `SourceOptions`. */
export const sourceFlags = {
  function: { type: 'string' },
  returns: { type: 'string' },
  'max-iterations': {
    type: 'string',
    kind: numeric(optional(wholeNumber({ min: 1, max: maxIterationLimit }))),
  },
} as const

export const sourceOptionsOf = (values: {
  function?: string | undefined
  returns?: string | undefined
  'max-iterations'?: number | undefined
}): SourceOptions => ({
  function: values.function,
  returns: values.returns,
  maxIterations: values['max-iterations'],
})

/**
 * Imports a JavaScript file, or parses a GLSL or WGSL file. The extension of the file name decides the language. For GLSL and WGSL,
 * `values` are the values of the uniforms that the source declares.
 */
export async function readWarp(
  file: string,
  options: SourceOptions = {},
  values: object = {},
): Promise<WarpFile> {
  if (isSource(file)) {
    const offsetOf = isWgsl(file) ? wgslOffset : glslOffset
    return {
      offset: offsetOf(await readText(file), removeUndefined(options)),
      uniforms: removeInputs(values),
    }
  }
  const module: Record<string, unknown> = await load(file)
  const uniforms = module.uniforms as UniformOptions | undefined
  const warpFile = (offset: unknown) => ({ offset: offset as OffsetFunction, uniforms })
  if (typeof module.default === 'function') return warpFile(module.default)
  const functions = Object.values(module).filter((value) => typeof value === 'function')
  if (functions.length === 1) return warpFile(functions[0])
  throw new WarpError(
    functions.length
      ? `${file} exports ${functions.length} functions; export the offset function as default.`
      : `${file} exports no function; write \`export default ({ glsl, position }) => glsl.vec3(…)\`.`,
  )
}

/** Removes the values of inputs, such as `millis`, which are not declared as uniforms. */
const removeInputs = (values: object) =>
  Object.fromEntries(
    Object.entries(values).filter(([name]) => !Object.hasOwn(inputSizes, name)),
  ) as UniformOptions

export const isWgsl = (file: string) => /\.wgsl$/i.test(file)

const isSource = (file: string) => isWgsl(file) || /\.(?:glsl|vert|frag|vs|fs)$/i.test(file)

/** Removes options that are `undefined`. */
export const removeUndefined = (options: object) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined))

export async function readText(file: string): Promise<string> {
  try {
    return await readFile(file, 'utf8')
  } catch (error) {
    const { code } = error as { code?: string }
    throw new WarpError(
      code === 'ENOENT'
        ? `The file ${file} does not exist.`
        : `${file} cannot be read: the system reports ${code}.`,
    )
  }
}

async function load(file: string): Promise<Record<string, unknown>> {
  const url = pathToFileURL(resolve(file)).href
  const neverResolves = Symbol()
  const module = await Promise.race([
    import(/* @vite-ignore */ url).catch((error: unknown) => {
      throw new WarpError(importErrorMessage(file, url, error))
    }),
    // Without this promise, Node would exit silently when nothing is left to do.
    new Promise<symbol>((resolve) => process.once('beforeExit', () => resolve(neverResolves))),
  ])
  if (module !== neverResolves) return module
  throw new WarpError(`${file} never finishes loading: its top-level await never resolves.`)
}

function importErrorMessage(file: string, url: string, error: unknown): string {
  if (!(error instanceof Error)) return `${file} cannot be run: it throws ${describe(error)}.`
  const { code, name, message } = error as Error & { code?: string }
  const firstLine = String(message).split('\n')[0]!
  if (
    code === 'ERR_MODULE_NOT_FOUND' &&
    firstLine.includes(resolve(file)) &&
    !firstLine.includes('imported from ' + resolve(file))
  )
    return `The file ${file} does not exist.`
  // Node before 20.19 treats a .js file as CommonJS unless a package.json says otherwise.
  if (name === 'SyntaxError' && /\bexport\b/.test(firstLine))
    return `${file} is an ES module; name it .mjs, or put "type": "module" into its package.json.`
  return `${file} cannot be run: ${name}: ${firstLine.replace(url, file)}`
}

/** Runs `work`, which calls functions of a file, and adds the file and line to the message of an error. */
export async function withFileInErrors<Result>(file: string, work: () => Result): Promise<Result> {
  try {
    return work()
  } catch (error) {
    if (error instanceof WarpError) {
      const line = lineOf(file, error)
      throw line ? new WarpError(`${error.message} (${file}, line ${line})`) : error
    }
    if (!(error instanceof Error)) throw new WarpError(`${file} throws ${describe(error)}.`)
    const { name, message } = error
    const line = lineOf(file, error)
    const location = line && ` (line ${line})`
    throw new WarpError(`${file}: ${name}: ${message.split('\n')[0]}${location}`)
  }
}

/** Returns the line number of the innermost call from the file in the stack of an error, as a string; empty if there is none. */
function lineOf(file: string, { stack = '' }: Error): string {
  const url = pathToFileURL(resolve(file)).href
  const start = stack.indexOf(url)
  const [, line] = start < 0 ? [] : (/^:(\d+)/.exec(stack.slice(start + url.length)) ?? [])
  return line ?? ''
}
