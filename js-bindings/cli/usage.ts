// How a command line is read.
import { type ParseArgsConfig, parseArgs } from 'node:util'

/** A command line that cannot be meant. */
export class UsageError extends Error {
  constructor(
    message: string,
    /** With a space after it, or nothing. */
    readonly command = '',
  ) {
    super(message)
  }
}

type Options = NonNullable<ParseArgsConfig['options']>

/** What JavaScript calls options, as the command line does. */
const flags: Readonly<Record<string, string>> = {
  function: '--function',
  returns: '--returns',
  by: '--by',
  name: '--name',
  maxIterations: '--max-iterations',
  surfaceVariation: '--surface-variation',
}

/** A sentence that names options, for somebody at the command line. */
export const withFlags = (sentence: string) =>
  sentence.replace(/(?:the|its) option "?(\w+)"?/g, (all, name: string) => flags[name] ?? all)

/** The options of a command, and its files, of which it needs exactly as many as `files` names. */
export function readArguments<const Known extends Options>(
  command: string,
  args: string[],
  files: readonly string[],
  options: Known,
) {
  const parsed = parse(command, args, options)
  const { positionals } = parsed
  const wrong = (message: string) => new UsageError(message, `${command} `)
  if (positionals.length > files.length)
    throw wrong(
      `${command} takes ${files.join(' and ')}, and nothing more, but "${positionals[files.length]}" came.`,
    )
  const missing = files[positionals.length]
  if (missing) throw wrong(`${command} needs ${missing}.`)
  return { values: parsed.values, files: positionals, wrong }
}

function parse<const Known extends Options>(command: string, args: string[], options: Known) {
  try {
    return parseArgs({ args, options, allowPositionals: true })
  } catch (error) {
    // Node's own first sentence names the option; the others are about the option's syntax in general.
    const [sentence] = (error as Error).message.split(/\. |\n/)
    throw new UsageError(`${command}: ${sentence!.replace(/\.$/, '')}.`, `${command} `)
  }
}

/** A whole number above 0, as an option has it. */
export function readCount(
  name: string,
  text: string,
  most: number,
  wrong: (message: string) => UsageError,
) {
  const value = readPositive(name, text, wrong)
  if (Number.isInteger(value) && value <= most) return value
  throw wrong(
    `--${name} must be a whole number, at most ${most.toLocaleString('en-US')}, but is "${text}".`,
  )
}

/** A number above 0, as an option has it. */
export function readPositive(name: string, text: string, wrong: (message: string) => UsageError) {
  const value = Number(text)
  if (text.trim() !== '' && value > 0 && value < Infinity) return value
  throw wrong(`--${name} must be a number above 0, but is "${text}".`)
}
