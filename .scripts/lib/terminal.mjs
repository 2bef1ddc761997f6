// Terminal output: one line per fact, one heading per step.
import { realpathSync } from 'node:fs'
import { pathToFileURL } from 'node:url'

const codes = { bold: 1, dim: 2, red: 31, green: 32 }
const isColored = process.stdout.isTTY && !process.env.NO_COLOR
export const paint = (style, text) => (isColored ? `\x1b[${codes[style]}m${text}\x1b[0m` : text)

/** The root folder of the repository. */
export const root = new URL('../../', import.meta.url)

export const say = (text = '') => console.log(text)
export const heading = (text) => say(`\n${paint('bold', `▸ ${text}`)}`)
export const good = (text) => say(`${paint('green', '✓')} ${text}`)
export const bad = (text) => say(`${paint('red', '✗')} ${text}`)
/** Formats the time since `since`, a result of performance.now(). */
export const seconds = (since) => `${((performance.now() - since) / 1000).toFixed(1)} s`

/** An expected error. `main` prints its message without a stack trace. */
export class Stop extends Error {}

/** Thrown by a check that cannot run here, with the reason. It neither passes nor fails. */
export class NotRun extends Error {}

/**
 * Runs `work` as the whole program. If it throws a Stop, prints the message; if `parseArgs` rejects the command line, prints the reason and
 * `usage`.
 */
export async function main(work, usage = '') {
  try {
    await work()
  } catch (error) {
    const isUsageError = error.code?.startsWith('ERR_PARSE_ARGS')
    if (!isUsageError && !(error instanceof Stop)) throw error
    // Prints the first sentence of Node's message. The rest is about arguments that begin with a dash.
    bad(isUsageError ? `${error.message.split(/\.\s/)[0]}. ${usage}` : error.message)
    process.exitCode = 1
  }
}

/** Returns whether `meta` is the `import.meta` of the script that Node was started with. */
export const isMain = (meta) =>
  process.argv[1] && meta.url === pathToFileURL(realpathSync(process.argv[1])).href
