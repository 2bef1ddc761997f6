// The steps of `npm test`, each ends well or throws.
import { availableParallelism } from 'node:os'
import { pathToFileURL } from 'node:url'
import { fuzz } from '../fuzz.mjs'
import { staleFiles } from '../reference.mjs'
import { installEnvironments } from './environments.mjs'
import { withBrowsers } from './browsers.mjs'
import { path, walk } from './files.mjs'
import { cmakeBuild } from './cmake.mjs'
import { checkHouse } from './house.mjs'
import { exitCode, run } from './run.mjs'
import { Stop } from './terminal.mjs'
import { isEveryday, leftOut } from './tiers.mjs'

const node = (...args) => run(process.execPath, args)
const binary = (name) => path('node_modules', name)

export const cppFiles = () =>
  ['src', 'js-bindings', 'tests', '.scripts'].flatMap((folder) => walk(folder, /\.[ch]pp$/))

const prettier = (mode) => [
  binary('prettier/bin/prettier.cjs'),
  mode,
  ...['--log-level', 'warn', '--cache', '--cache-location', path('.build/prettier')],
  '.',
]

export async function format() {
  await run('clang-format', ['-i', ...cppFiles()])
  await node(...prettier('--write'))
}

async function checkFormat() {
  const cpp = ['clang-format', ['--dry-run', '-Werror', ...cppFiles()]]
  const failures = [await exitCode(...cpp), await exitCode(process.execPath, prettier('--check'))]
  if (failures.some(Boolean)) throw new Stop('`npm run format` puts this right.')
}

async function checkReference() {
  const stale = (await staleFiles()).map(({ file }) => file)
  if (stale.length)
    throw new Stop(`Stale: ${stale.join(', ')}; \`npm run reference\` puts this right.`)
}

async function cpp(preset) {
  await cmakeBuild(preset)
  await run('ctest', [
    '--preset',
    preset,
    '--parallel',
    `${availableParallelism()}`,
    '--no-tests=error',
  ])
}

async function nodeTests(folder, atOnce = availableParallelism()) {
  const files = walk(folder, /\.test\.js$/).filter(
    (file) => !(isEveryday() && file in leftOut.files),
  )
  if (!files.length) throw new Stop(`There are no tests in ${folder}.`)
  // Node's own choice is one file fewer than there are cores.
  const concurrency = `--test-concurrency=${atOnce}`
  // A file of its own never takes so long; one that hangs is to fail, not to keep all others from being heard of.
  const limit = `--test-timeout=${15 * 60_000}`
  const ours = (name) => pathToFileURL(path('.scripts/lib', name)).href
  const printing = ['--import', ours('tests-console.mjs')]
  const reporting = ['spec', ours('why-failed.mjs')].flatMap((reporter) => [
    `--test-reporter=${reporter}`,
    '--test-reporter-destination=stdout',
  ])
  await node('--test', ...reporting, ...printing, concurrency, limit, ...files)
}

// Browsers wait for each other: two on two cores leave a sixth of the time idle, three none.
const browsersAtOnce = availableParallelism() + 1
const browser = () => withBrowsers(browsersAtOnce, () => nodeTests('tests/browser', browsersAtOnce))

async function environments() {
  await installEnvironments()
  await nodeTests('tests/package')
}

/** `group` is what `npm test -- <group>` selects; tiers.mjs names the titles that the everyday run leaves out. */
export const checks = [
  { group: 'format', title: 'Formatting', work: checkFormat },
  {
    group: 'house',
    title: 'Rooms: no circles, and no language but in a dialect',
    work: checkHouse,
  },
  {
    group: 'types',
    title: 'Types',
    work: () => node(binary('typescript/bin/tsc'), '--project', 'tsconfig.json'),
  },
  { group: 'reference', title: 'Types and reference of operations', work: checkReference },
  { group: 'cpp', title: 'C++ tests and fuzz corpus', work: () => cpp('native') },
  { group: 'cpp', title: 'The same under ASan and UBSan', work: () => cpp('sanitize') },
  // From the committed seeds alone, so that it takes the same time everywhere.
  { group: 'fuzz', title: 'Fuzzing', work: () => fuzz({ seconds: 60, isKept: false }) },
  { group: 'js', title: 'JavaScript tests', work: () => nodeTests('tests/js') },
  { group: 'browser', title: 'Browser tests', work: browser },
  { group: 'package', title: 'The package in its environments', work: environments },
]
