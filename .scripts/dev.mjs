// npm run dev: watches the sources, rebuilds after each change, and reruns the tests that depend on the changed files.
//
//   npm run dev                 all tests but those in browsers
//   npm run dev -- tests/mesh   only test files whose path begins with tests/mesh, including browser tests
//
// A change of C++ also reruns .build/native/warpjet_tests.
import { existsSync, readFileSync, statSync, watch } from 'node:fs'
import { dirname, join } from 'node:path/posix'
import { setTimeout } from 'node:timers/promises'
import { build } from './build.mjs'
import { cmakeBuild } from './lib/cmake.mjs'
import { path, walk } from './lib/files.mjs'
import { exitCode } from './lib/run.mjs'
import { Stop, bad, heading, main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const watched = ['src', 'js-bindings', 'tests', 'web', 'examples', '.scripts']
const isCpp = (file) => /^(src|tests\/cpp)\/.*\.[ch]pp$/.test(file)
/** The milliseconds between the first change and the build, since an editor may save several files at once. */
const pause = 200

const importPattern = /\b(?:from|import)\s*\(?\s*["'](\.[^"']+)["']/g

/** Lists a test file and everything that it imports, directly or indirectly, including files of dist. */
function listDependencies(test) {
  const files = new Set([test])
  for (const file of files) {
    if (!/\.m?js$/.test(file) || !existsSync(path(file))) continue
    const text = readFileSync(path(file), 'utf8')
    for (const [, relative] of text.matchAll(importPattern))
      files.add(join(dirname(file), relative))
  }
  return files
}

/** Maps each source file → the time of its last change. */
const readSourceTimes = () =>
  new Map(
    watched
      .flatMap((folder) => walk(folder))
      .filter((file) => !file.startsWith('js-bindings/generated/'))
      .map((file) => [file, statSync(path(file)).mtimeMs]),
  )

/** Maps each file of dist → its content. */
const readDist = () =>
  new Map(walk('dist', /\.js$/).map((file) => [file, readFileSync(path(file), 'utf8')]))

/** Lists the tests that depend on the files in `changed`. `prefixes` are the starts of paths from the command line. */
function listTests(changed, prefixes) {
  const isWanted = (test) =>
    prefixes.length ? prefixes.some((start) => test.startsWith(start)) : !test.includes('.browser.')
  return ['tests', 'web/tests']
    .flatMap((folder) => walk(folder, /\.test\.js$/))
    .filter(
      (test) => isWanted(test) && [...listDependencies(test)].some((file) => changed.has(file)),
    )
}

async function buildAndTest(changed, prefixes) {
  const before = readDist()
  await build()
  for (const [file, text] of readDist()) if (before.get(file) !== text) changed.add(file)
  if ([...changed].some(isCpp)) {
    await cmakeBuild('native', 'warpjet_tests')
    await exitCode(path('.build/native/warpjet_tests'), ['--gtest_brief=1'])
  }
  const tests = listTests(changed, prefixes)
  heading(`${tests.length} test files`)
  if (tests.length) await exitCode(process.execPath, ['--test', '--test-reporter=dot', ...tests])
}

await main(async () => {
  const prefixes = process.argv.slice(2)
  process.env.WARPJET_CHROMIUM = (await setup()).chromium
  await build()
  say('\nWatching. Stop with Ctrl+C.')
  let lastSeen = readSourceTimes()
  // Ends the wait for the next change.
  let wake
  for (const folder of watched) watch(path(folder), { recursive: true }, () => wake?.())
  for (;;) {
    const now = readSourceTimes()
    const changed = new Set([...now.keys()].filter((file) => now.get(file) !== lastSeen.get(file)))
    lastSeen = now
    if (!changed.size) {
      await new Promise((resolve) => (wake = resolve))
      await setTimeout(pause)
      continue
    }
    heading([...changed].slice(0, 5).join(', '))
    try {
      await buildAndTest(changed, prefixes)
    } catch (error) {
      if (!(error instanceof Stop)) throw error
      bad(error.message)
    }
    say('\nWatching. Stop with Ctrl+C.')
  }
})
