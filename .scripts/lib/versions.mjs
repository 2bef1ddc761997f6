// Versions of programs and headers. Programs are asked once and remembered until their file changes,
// so that set-up takes no time when all is there.
import { createHash } from 'node:crypto'
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  realpathSync,
  statSync,
  writeFileSync,
} from 'node:fs'
import { delimiter, join } from 'node:path'
import { path } from './files.mjs'
import { capture } from './run.mjs'

const store = path('.build/setup.json')
const known = existsSync(store) ? JSON.parse(readFileSync(store, 'utf8')) : {}

/** The answer of `ask`, remembered for as long as `file` stays as it is; failures are not remembered. */
export async function remembered(file, question, ask) {
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

/** What `program --version` says: the first dotted number in it. */
export const versionOf = (program) =>
  remembered(program, '--version', async () => {
    const text = await capture(program, ['--version'])
    return text?.match(/\d+(\.\d+)+/)?.[0] ?? null
  })

/** Compares dotted numbers: '3.1.10' is at least '3.1.6'. */
export function atLeast(version, least) {
  const [a, b] = [version, least].map((text) => text.split('.').map(Number))
  const differs = b.findIndex((part, i) => (a[i] ?? 0) !== part)
  return differs < 0 || (a[differs] ?? 0) > b[differs]
}

const prefixes = ['/usr', '/usr/local', '/opt/homebrew', '/opt/local']
const listed = (name) => (process.env[name] ?? '').split(delimiter).filter(Boolean)
const includes = [
  ...listed('CPATH'),
  ...listed('CPLUS_INCLUDE_PATH'),
  ...prefixes.map((prefix) => join(prefix, 'include')),
]

/** The version that the first of `names` found among the compiler's headers says it has. */
export function headerVersion(names, pattern) {
  const files = includes.flatMap((folder) => names.map((name) => join(folder, name)))
  return versionIn(files, pattern)
}

/** The version of a package that CMake can find, such as GTest. */
export function cmakePackageVersion(name) {
  const libraries = prefixes.flatMap((prefix) => [join(prefix, 'lib'), join(prefix, 'lib64')])
  // Debian keeps libraries one folder deeper, by architecture.
  const folders = libraries.filter(existsSync).flatMap((folder) => [
    folder,
    ...readdirSync(folder, { withFileTypes: true })
      .filter((entry) => entry.isDirectory() && /-linux-/.test(entry.name))
      .map((entry) => join(folder, entry.name)),
  ])
  const files = folders.map((folder) => join(folder, 'cmake', name, `${name}ConfigVersion.cmake`))
  return versionIn(files, /PACKAGE_VERSION "([\d.]+)"/)
}

function versionIn(files, pattern) {
  const file = files.find(existsSync)
  if (!file) return null
  return readFileSync(file, 'utf8').match(pattern)?.[1] ?? 'of unknown version'
}
