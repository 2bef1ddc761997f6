// Finds headers, and asks programs for their versions. Answers are cached until a program changes, so that set-up is fast if nothing
// is missing.
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, realpathSync, statSync, writeFileSync } from 'node:fs'
import { delimiter, join } from 'node:path'
import { path } from './files.mjs'
import { capture } from './run.mjs'

const store = path('.build/setup.json')
const known = existsSync(store) ? JSON.parse(readFileSync(store, 'utf8')) : {}

/** Returns the answer of `ask`, cached until `file` changes. Failures are not cached. */
export async function cacheAnswer(file, question, ask) {
  const { mtimeMs, size } = statSync(file)
  const key = createHash('sha256')
    .update([realpathSync(file), mtimeMs, size, question].join('\0'))
    .digest('hex')
  if (known[key]) return known[key]
  const answer = await ask()
  if (!answer) return null
  known[key] = answer
  mkdirSync(path('.build'), { recursive: true })
  writeFileSync(store, JSON.stringify(known))
  return answer
}

/** Returns the first dotted number that `program --version` prints, or null. */
export const versionOf = (program) =>
  cacheAnswer(program, '--version', async () => {
    const text = await capture(program, ['--version'])
    return text?.match(/\d+(\.\d+)+/)?.[0] ?? null
  })

/** Compares dotted numbers: '3.1.10' is at least '3.1.6'. */
export function atLeast(version, minVersion) {
  const [a, b] = [version, minVersion].map((text) => text.split('.').map(Number))
  const differs = b.findIndex((part, i) => (a[i] ?? 0) !== part)
  return differs < 0 || (a[differs] ?? 0) > b[differs]
}

const listPaths = (name) => (process.env[name] ?? '').split(delimiter).filter(Boolean)
const includes = [
  ...listPaths('CPATH'),
  ...listPaths('CPLUS_INCLUDE_PATH'),
  ...['/usr', '/usr/local', '/opt/homebrew', '/opt/local'].map((prefix) => join(prefix, 'include')),
]

/** Returns the path of the first of `names` among the compiler's headers, or `undefined`. */
export const findHeader = (...names) =>
  includes.flatMap((folder) => names.map((name) => join(folder, name))).find(existsSync)
