#!/usr/bin/env node
/// <reference types="node" />
// `npx warpjet`: finds the command, and turns errors into one sentence and an exit code.
import { bake } from './cli/bake.js'
import { derive } from './cli/derive.js'
import { emit } from './cli/emit.js'
import { reasonOf } from './cli/files.js'
import { help, helpOf } from './cli/help.js'
import { info } from './cli/info.js'
import { printable } from './cli/printable.js'
import { UsageError, withFlags } from './cli/usage.js'
import { WarpError } from './errors/errors.js'
import { registerFrontEnd } from './glsl-source/call.js'
import { version } from './generated/version.js'

registerFrontEnd()

const commands: Record<string, (args: string[]) => Promise<void>> = { emit, bake, derive, info }

const [name = '', ...args] = process.argv.slice(2)
const asksForHelp = (text: string) => text === '--help' || text === '-h'

// Whoever reads may have enough, as `head` does.
process.stdout.on('error', ({ code }: { code?: string }) => {
  if (code === 'EPIPE') return
  console.error(`warpjet: the output cannot be written: ${reasonOf(code)}.`)
  process.exit(1)
})
// There is nowhere left to say so.
process.stderr.on('error', () => {})

try {
  const command = Object.hasOwn(commands, name) ? commands[name] : undefined
  if (command && args.some(asksForHelp)) console.log(helpOf(name))
  else if (command) await command(args)
  else if (asksForHelp(name) || name === 'help') console.log(help)
  else if (name === '--version' || name === '-v') console.log(version)
  else throw new UsageError(name ? `There is no command "${name}".` : 'A command is missing.')
} catch (error) {
  process.exitCode = report(error)
}

// What warp.js left running, such as a timer, is not waited for; what was written is.
for (const stream of [process.stdout, process.stderr])
  await new Promise<void>((done) => stream.write('', () => done()))
process.exit()

/** Says what went wrong: 2 for a wrong command line, 1 for what it names. */
function report(error: unknown): number {
  if (error instanceof UsageError) {
    const { command, message } = error
    console.error(`warpjet: ${printable(message)} \`npx warpjet ${command}--help\` shows how.`)
    return 2
  }
  // A line of a text of GLSL stands below its sentence, with a caret.
  if (error instanceof WarpError)
    console.error(`warpjet: ${withFlags(error.message).split('\n').map(printable).join('\n')}`)
  else console.error(error)
  return 1
}
