// The two tiers of the tests: `npm test` is the everyday run, `npm test -- --all` is everything. The everyday run leaves out tests
// that are slow and rarely fail, or whose subject other tests cover too. A file that you start with `node --test` runs all its tests.

/** Steps that only run with `--all`, by title, each with the reason. */
export const rareSteps = {
  'C++ tests under ASan and UBSan': 'compiling takes twice as long as for the native tests',
  Fuzzing: 'it searches for 20 s on each core, and the C++ tests already run its corpus',
  'The package in its environments': 'it installs 900 MB of bundlers from the npm registry',
}

/** Test files that only run with `--all`. */
export const rareFiles = [
  // The benchmark and the site's pages, whose parts are covered by everyday tests.
  ...['bench', 'bench-pages', 'bench-results'].map((name) => `tests/scripts/${name}`),
  ...['drop', 'site', 'site-motion', 'site-offline', 'docs'].map((name) => `web/tests/${name}`),
  ...['', '-costs', '-help', '-habits', '-hosts', '-examples'].map(
    (name) => `web/tests/playground${name}`,
  ),
  // These hosts draw the same warps that the everyday tests draw with p5 on WebGL, but slowly without a GPU.
  ...['webgpu', 'webgpu-examples', 'p5-1-pictures', 'script'].map((name) => `tests/p5/${name}`),
  ...['three/webgpu', 'three/react', 'babylon/babylon', 'entries/bundler'].map(
    (name) => `tests/${name}`,
  ),
].map((name) => `${name}.browser.test.js`)

/** Parts of test files that only run with `--all`; the files ask `isRun`. */
export const rareParts = [
  'p5 1.11',
  'p5 on WebGPU',
  'three 0.159',
  'a thousand rays',
  'every material of three',
  'all dialects',
  'every example in the gallery',
  'the built gallery, and the gallery on a phone',
  'every model',
  'every vertex',
  'every random expression',
  'glass and lanterns',
  'every TypeScript',
  'every warp after a week of uptime',
  'unusual p5 pages',
  'thousands of warps',
  'deep domain warping',
]

/**
 * In minutes, on two otherwise idle cores, with everything built. On a fresh checkout the everyday run takes at most 10, and
 * building adds 5 or more to the full run.
 */
export const limits = { everyday: 6, all: 15 }

const variable = 'WARPJET_TIER'

/** Sets the tier of this process and of its child processes. */
export const chooseTier = (tier) => (process.env[variable] = tier)

export const isEveryday = () => process.env[variable] === 'everyday'

/** Returns whether a part of a test file belongs to this run. */
export function isRun(part) {
  if (!rareParts.includes(part))
    throw new Error(`Expected one of tiers.mjs' rareParts, got ${part}.`)
  return !isEveryday()
}
