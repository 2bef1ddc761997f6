// The steps of `npm test`. Each of them throws if it fails.
import { availableParallelism } from 'node:os'
import { pathToFileURL } from 'node:url'
import { fuzzRepeatably } from '../fuzz.mjs'
import { checkWording } from '../plain-english.mjs'
import { withBrowsers } from './browsers.mjs'
import { cmakeBuild } from './cmake.mjs'
import { checkDependencies } from './dependencies.mjs'
import { installEnvironments } from './environments.mjs'
import { path, walk } from './files.mjs'
import { exitCode, run } from './run.mjs'
import { Stop } from './terminal.mjs'
import { isFileRun } from './tiers.mjs'

const node = (...args) => run(process.execPath, args)
const binary = (name) => path('node_modules', name)

export const cppFiles = () =>
  ['src', 'js-bindings', 'tests', '.scripts'].flatMap((folder) => walk(folder, /\.[ch]pp$/))

const prettier = (mode) => [
  ...[binary('prettier/bin/prettier.cjs'), mode, '.', '--log-level', 'warn'],
  ...['--cache', '--cache-location', path('.build/prettier')],
]

export async function format() {
  await run('clang-format', ['-i', ...cppFiles()])
  await node(...prettier('--write'))
}

async function checkFormat() {
  const clangFormat = ['clang-format', ['--dry-run', '-Werror', ...cppFiles()]]
  const failures = await Promise.all([
    exitCode(...clangFormat),
    exitCode(process.execPath, prettier('--check')),
  ])
  if (failures.some(Boolean)) throw new Stop('`npm run format` fixes this.')
}

async function checkReference() {
  // Imported late, because it uses packages that set-up installs.
  const { staleFiles } = await import('../reference.mjs')
  const stale = (await staleFiles()).map(({ file }) => file)
  if (stale.length) throw new Stop(`Stale: ${stale.join(', ')}; \`npm run reference\` fixes this.`)
}

async function runCppTests(preset) {
  await cmakeBuild(preset)
  const parallel = ['--parallel', `${availableParallelism()}`]
  await run('ctest', ['--preset', preset, ...parallel, '--no-tests=error'])
}

const kindOf = (file) =>
  file.startsWith('tests/package/') ? 'package' : /\.browser\./.test(file) ? 'browser' : 'node'

/**
 * Runs the test files of a kind: `x.test.js` needs only Node, `x.browser.test.js` a browser, and files in tests/package
 * installed environments. `longest` names the files that start first; `atOnce` is the number of processes.
 */
async function runTestFiles(kind, { atOnce = availableParallelism(), longest = [] } = {}) {
  const all = ['tests', 'web/tests']
    .flatMap((folder) => walk(folder, /\.test\.js$/))
    .filter((file) => kindOf(file) === kind && isFileRun(file))
  if (!all.length) throw new Stop(`There are no tests of the kind ${kind}.`)
  const files = new Set([...longest.filter((file) => all.includes(file)), ...all])
  const libFile = (name) => path('.scripts/lib', name)
  const preload = ['--import', pathToFileURL(libFile('tests-console.mjs')).href]
  await node(...preload, libFile('run-tests.mjs'), `${atOnce}`, ...files)
}

// Tests wait for their pages: on two cores, two processes are idle for a sixth of the time, three are not.
const browsersAtOnce = availableParallelism() + 1
/** Files that take at least 40 s of CPU time or wait for long. Waiting files are placed between computing ones. */
const longest = [
  ...['operators/sketches', 'p5/detail-compute', 'three/detail'].map((name) => `tests/${name}`),
  ...['playground', 'gallery', 'site', 'playground-attacks'].map((name) => `web/tests/${name}`),
  ...['p5/detail', 'three/three', 'p5/webgpu-examples', 'p5/scenes'].map((name) => `tests/${name}`),
  ...['playground-habits', 'playground-examples'].map((name) => `web/tests/${name}`),
  ...['three/pixel-normals-webgpu', 'three/pixel-normals'].map((name) => `tests/${name}`),
  ...['playground-hosts', 'docs'].map((name) => `web/tests/${name}`),
  'tests/compile/random',
  'web/tests/site-offline',
  'tests/core/operations',
  'web/tests/playground-help',
  'tests/glsl-source/glsl',
  'tests/three/webgpu',
  'web/tests/site-motion',
  'tests/p5/webgpu',
].map((name) => `${name}.browser.test.js`)
const runBrowserTests = () =>
  withBrowsers(browsersAtOnce, () => runTestFiles('browser', { atOnce: browsersAtOnce, longest }))

async function runPackageTests() {
  await installEnvironments()
  await runTestFiles('package')
}

const runTool =
  (file, ...args) =>
  () =>
    node(binary(file), ...args)

/** `npm test -- <group>` selects a group. `rare` says why a step only runs with `--all`. */
export const checks = [
  { group: 'format', title: 'Formatting', work: checkFormat },
  { group: 'dependencies', title: 'Dependency rules', work: checkDependencies },
  {
    group: 'types',
    title: 'Types',
    work: runTool('typescript-7/bin/tsc', '--project', 'tsconfig.json'),
  },
  { group: 'lint', title: 'Lint', work: runTool('oxlint/bin/oxlint', '--deny-warnings') },
  {
    group: 'knip',
    title: 'Unused files, exports and packages',
    work: runTool('knip/bin/knip.js', '--no-progress'),
  },
  { group: 'language', title: 'Plain English in added lines', work: checkWording },
  { group: 'reference', title: 'Types and reference of operations', work: checkReference },
  { group: 'cpp', title: 'C++ tests and fuzz corpus', work: () => runCppTests('native') },
  {
    group: 'cpp',
    title: 'C++ tests under ASan and UBSan',
    work: () => runCppTests('sanitize'),
    rare: 'compiling takes twice as long as for the native tests',
  },
  {
    group: 'fuzz',
    title: 'Fuzzing',
    work: fuzzRepeatably,
    rare: 'it searches for 20 s on each core, and the C++ tests already run its corpus',
  },
  { group: 'js', title: 'JavaScript tests', work: () => runTestFiles('node') },
  { group: 'browser', title: 'Browser tests', work: runBrowserTests },
  {
    group: 'package',
    title: 'The package in its environments',
    work: runPackageTests,
    rare: 'it installs 900 MB of bundlers from the npm registry',
  },
]
