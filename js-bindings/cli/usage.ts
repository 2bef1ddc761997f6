// Parses the command line.
import { parseArgs, type ParseArgsConfig } from 'node:util'
import { WarpError } from '../errors/errors.js'
import type { Kind } from '../options/kinds.js'
import { Place } from '../options/place.js'

/** An error in the command line. */
export class UsageError extends Error {
  constructor(
    message: string,
    /** The command followed by a space, or empty. */
    readonly command = '',
  ) {
    super(message)
  }
}

/** Maps options of JavaScript functions → options of the command line. */
const flags: Readonly<Record<string, string>> = {
  function: '--function',
  returns: '--returns',
  by: '--by',
  name: '--name',
  maxIterations: '--max-iterations',
  surfaceVariation: '--surface-variation',
}

/** Replaces the options that a message names by those of the command line. */
export const withFlags = (message: string) =>
  message.replace(/(?:the|its) option "?(\w+)"?/g, (all, name: string) => flags[name] ?? all)

/** An option of the command line, as for Node's parseArgs; `kind` parses its value. */
export type Flag = ParseArgsConfig['options'] extends infer All | undefined
  ? All[keyof All] & { kind?: Kind<unknown, any> }
  : never

type Flags = Readonly<Record<string, Flag>>

type Parsed<Known extends Flags> = ReturnType<typeof parse<Known>>['values']

type Values<Known extends Flags> = {
  [Name in keyof Known]: Known[Name] extends { kind: Kind<infer Value, any> }
    ? Value
    : Name extends keyof Parsed<Known>
      ? Parsed<Known>[Name]
      : undefined
}

/**
 * Parses the options and file names of a command. `files` describes each required file. Returns the values of the options, the file names,
 * and `usageError`, which makes an error in the use of this command.
 */
export function readArguments<const Known extends Flags>(
  command: string,
  args: string[],
  files: readonly string[],
  options: Known,
) {
  const parsed = parse(command, args, options)
  const { positionals } = parsed
  const usageError = (message: string) => new UsageError(message, `${command} `)
  if (positionals.length > files.length)
    throw usageError(
      `${command}: expected ${files.join(' and ')}, and nothing more, got "${positionals[files.length]}".`,
    )
  const missing = files[positionals.length]
  if (missing) throw usageError(`${command} needs ${missing}.`)
  try {
    return { values: readFlags(command, options, parsed.values), files: positionals, usageError }
  } catch (error) {
    throw error instanceof WarpError ? usageError(error.message) : error
  }
}

const readFlags = <Known extends Flags>(
  command: string,
  options: Known,
  values: Readonly<Record<string, unknown>>,
) =>
  Object.fromEntries(
    Object.entries(options).map(([name, { kind }]) => [
      name,
      kind ? kind.read(values[name], new Place(command, `--${name}`)) : values[name],
    ]),
  ) as Values<Known>

/** Converts a kind of numbers to a kind of strings that contain such a number. */
export const numeric = <Value>({ read }: Kind<Value, number>): Kind<Value, string> => ({
  read(text, place) {
    const number = typeof text === 'string' && text.trim() ? Number(text) : NaN
    return read(Number.isNaN(number) ? text : number, place)
  },
})

function parse<const Known extends Flags>(command: string, args: string[], options: Known) {
  try {
    return parseArgs({ args, options, allowPositionals: true })
  } catch (error) {
    // The first sentence of Node's message names the option; the others explain the syntax of options in general.
    const [message] = (error as Error).message.split(/\. |\n/)
    throw new UsageError(`${command}: ${message!.replace(/\.$/, '')}.`, `${command} `)
  }
}
