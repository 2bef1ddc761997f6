#!/usr/bin/env node
/// <reference types="node" />
// `npx warpjet`: runs a command, and reports an error by one message and the exit code.
import { bake } from './cli/bake.js'
import { derive } from './cli/derive.js'
import { emit } from './cli/emit.js'
import { reasonOf } from './cli/files.js'
import { help, helpOf } from './cli/help.js'
import { info } from './cli/info.js'
import { printable } from './cli/printable.js'
import { UsageError, withFlags } from './cli/usage.js'
import { WarpError } from './errors/errors.js'
import { version } from './generated/version.js'
import { registerFrontEnd } from './glsl-source/call.js'

registerFrontEnd()

const commands: Record<string, (args: string[]) => Promise<void>> = { emit, bake, derive, info }

const [name = '', ...args] = process.argv.slice(2)
const isHelpFlag = (text: string) => text === '--help' || text === '-h'

// The program that reads stdout may close the pipe early, as `head` does.
process.stdout.on('error', ({ code }: { code?: string }) => {
  if (code === 'EPIPE') return
  console.error(`warpjet: the output cannot be written: ${reasonOf(code)}.`)
  process.exit(1)
})
// An error in writing to stderr cannot be reported.
process.stderr.on('error', () => {})

try {
  const command = Object.hasOwn(commands, name) ? commands[name] : undefined
  if (command && args.some(isHelpFlag)) console.log(helpOf(name))
  else if (command) await command(args)
  else if (isHelpFlag(name) || name === 'help') console.log(help)
  else if (name === '--version' || name === '-v') console.log(version)
  else throw new UsageError(name ? `There is no command "${name}".` : 'A command is missing.')
} catch (error) {
  process.exitCode = report(error)
}

// Waits until all output is written, but not for anything that the user's module left running, such as a timer.
for (const stream of [process.stdout, process.stderr])
  await new Promise<void>((resolve) => stream.write('', () => resolve()))
process.exit()

/** Prints an error and returns the exit code: 2 for a wrong command line, otherwise 1. */
function report(error: unknown): number {
  if (error instanceof UsageError) {
    const { command, message } = error
    console.error(`warpjet: ${printable(message)} \`npx warpjet ${command}--help\` shows how.`)
    return 2
  }
  // An error in GLSL source has further lines: the line of the source, and a caret.
  if (error instanceof WarpError)
    console.error(`warpjet: ${withFlags(error.message).split('\n').map(printable).join('\n')}`)
  else console.error(error)
  return 1
}
