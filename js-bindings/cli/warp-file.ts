// The offset function of a file.
import { readFile } from 'node:fs/promises'
import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import { mostIterations } from '../glsl-source/options.js'
import { type UsageError, readCount } from './usage.js'
import { WarpError, describe } from '../errors/errors.js'
import { glslOffset } from '../glsl-source/offset.js'
import { inputSizes } from '../core/inputs/inputs.js'
import type { OffsetFunction, UniformOptions } from '../core/types/types.js'

/** What a file exports. */
export interface WarpFile {
  /** The default export, or the only function. */
  offset: OffsetFunction
  /** The option `uniforms`, as `compileWarp` takes it. */
  uniforms: UniformOptions | undefined
}

/** What a file of shader text is told, on the command line. */
export interface GlslChoice {
  function?: string | undefined
  returns?: string | undefined
  maxIterations?: number | undefined
}

/** The same as arguments. */
export const glslArguments = {
  function: { type: 'string' },
  returns: { type: 'string' },
  'max-iterations': { type: 'string' },
} as const

interface GlslArguments {
  function?: string | undefined
  returns?: string | undefined
  'max-iterations'?: string | undefined
}

export function readChoice(
  { function: name, returns, 'max-iterations': most }: GlslArguments,
  wrong: (message: string) => UsageError,
): GlslChoice {
  const maxIterations =
    most === undefined ? undefined : readCount('max-iterations', most, mostIterations, wrong)
  return { function: name, returns, maxIterations }
}

/**
 * Runs the file, or reads it, where its name says that it is shader text: its uniforms then have the types that it says, and the
 * values that are given.
 */
export async function readWarp(
  file: string,
  choice: GlslChoice = {},
  values: object = {},
): Promise<WarpFile> {
  if (isGlsl(file))
    return { offset: await readGlsl(file, choice), uniforms: uniformsOfText(values) }
  const module: Record<string, unknown> = await load(file)
  const uniforms = module.uniforms as UniformOptions | undefined
  const found = (offset: unknown) => ({ offset: offset as OffsetFunction, uniforms })
  if (typeof module.default === 'function') return found(module.default)
  const functions = Object.values(module).filter((value) => typeof value === 'function')
  if (functions.length === 1) return found(functions[0])
  throw new WarpError(
    functions.length
      ? `${file} exports ${functions.length} functions; export the offset function as default.`
      : `${file} exports no function; write \`export default ({ glsl, position }) => glsl.vec3(…)\`.`,
  )
}

/** Without the inputs, which nobody declares. */
const uniformsOfText = (values: object) =>
  Object.fromEntries(
    Object.entries(values).filter(([name]) => !Object.hasOwn(inputSizes, name)),
  ) as UniformOptions

const isGlsl = (file: string) => /\.(?:glsl|vert|frag|vs|fs)$/i.test(file)

const readGlsl = async (file: string, choice: GlslChoice) =>
  glslOffset(await readText(file), given(choice))

/** What is there of some options. */
export const given = (options: object) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined))

export async function readText(file: string): Promise<string> {
  try {
    return await readFile(file, 'utf8')
  } catch (error) {
    const { code } = error as { code?: string }
    throw new WarpError(
      code === 'ENOENT'
        ? `The file ${file} does not exist.`
        : `${file} cannot be read: the system says ${code}.`,
    )
  }
}

async function load(file: string): Promise<Record<string, unknown>> {
  const url = pathToFileURL(resolve(file)).href
  const forsaken = Symbol()
  const given = await Promise.race([
    import(/* @vite-ignore */ url).catch((error: unknown) => {
      throw new WarpError(sentence(file, url, error))
    }),
    // Node, with nothing left to do, would end without a word.
    new Promise<symbol>((resolve) => process.once('beforeExit', () => resolve(forsaken))),
  ])
  if (given !== forsaken) return given
  throw new WarpError(
    `${file} never ends: outside of its functions it awaits something that never comes.`,
  )
}

function sentence(file: string, url: string, error: unknown): string {
  if (!(error instanceof Error)) return `${file} cannot be run: it throws ${describe(error)}.`
  const { code, name, message } = error as Error & { code?: string }
  const first = String(message).split('\n')[0]!
  if (
    code === 'ERR_MODULE_NOT_FOUND' &&
    first.includes(resolve(file)) &&
    !first.includes('imported from ' + resolve(file))
  )
    return `The file ${file} does not exist.`
  // Node before 20.19 takes a .js file for CommonJS unless a package.json says otherwise.
  if (name === 'SyntaxError' && /\bexport\b/.test(first))
    return `${file} is an ES module; name it .mjs, or put "type": "module" into its package.json.`
  return `${file} cannot be run: ${name}: ${first.replace(url, file)}`
}

/** What the sketch's own code throws while it is compiled, as a sentence that names the file. */
export async function blame<Result>(file: string, work: () => Result): Promise<Result> {
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
    const place = line && ` (line ${line})`
    throw new WarpError(`${file}: ${name}: ${message.split('\n')[0]}${place}`)
  }
}

function lineOf(file: string, { stack = '' }: Error): string {
  const url = pathToFileURL(resolve(file)).href
  const at = stack.indexOf(url)
  const [, line] = at < 0 ? [] : (/^:(\d+)/.exec(stack.slice(at + url.length)) ?? [])
  return line ?? ''
}
