// The two tiers of the tests: `npm test` is the everyday run, `npm test -- --all` is everything. The everyday run leaves out tests
// that are slow and rarely fail, or whose subject other tests cover too. A file that you start with `node --test` runs all its tests.

/** Test files that only run with `--all`. */
export const rareFiles = [
  // The benchmark and the site's pages, whose parts are covered by everyday tests.
  ...['bench', 'bench-pages', 'bench-results'].map((name) => `tests/scripts/${name}`),
  ...['drop', 'site', 'site-motion', 'site-offline', 'docs'].map((name) => `web/tests/${name}`),
  ...['', '-save', '-costs', '-help', '-habits', '-hosts', '-examples'].map(
    (name) => `web/tests/playground${name}`,
  ),
  // These hosts draw the same warps that the everyday tests draw with p5 on WebGL, but slowly without a GPU.
  ...['webgpu', 'webgpu-examples', 'p5-1-pictures', 'script'].map((name) => `tests/p5/${name}`),
  ...['three/webgpu', 'three/react', 'babylon/babylon', 'entries/bundler'].map(
    (name) => `tests/${name}`,
  ),
].map((name) => `${name}.browser.test.js`)

const variable = 'WARPJET_TIER'

/** Sets the tier of this process and of its child processes: 'everyday' or 'all'. */
export const chooseTier = (tier) => (process.env[variable] = tier)

export const isEveryday = () => process.env[variable] === 'everyday'

/** Returns whether this run includes the parts of test files that only run with `--all`. Callers name the part for the reader. */
export const isRun = (_part) => !isEveryday()
