// The two tiers of the tests: `npm test` is the everyday run, `npm test -- --all` is everything, as CI runs it. A file that you start
// with `node --test` runs all its tests.
//
// Browser tests draw without a GPU and take the most time, so the everyday run only has the browser files that are named here: a new one
// runs with `--all` until it is named. Test files that need only Node are in the everyday run unless they are named here.

/** Maps a subject → its browser test files in the everyday run: the one or two that find most mistakes in a few seconds of a core. */
const everydayBrowserFiles = {
  compiler: ['compile/random', 'compile/extremes'],
  p5: [
    'p5/p5',
    'p5/page',
    'p5/pixel-normals',
    'p5/exact-normals',
    'p5/detail',
    'p5/detail-cameras',
  ],
  three: [
    ...['three/three', 'three/pixel-normals', 'three/exact-normals', 'three/detail'],
    // Compute passes on WebGPU.
    'three/detail-compute',
  ],
  babylon: ['babylon/babylon'],
  'GLSL and WGSL': ['glsl-source/glsl', 'glsl-source/wgsl-values', 'glsl-source/wgsl-rules'],
  mesh: ['mesh/bake'],
  operators: ['operators/sketches'],
}

const everydaySiteFiles = ['playground-save']

/** All browser test files of the everyday run. */
export const everydayFiles = [
  ...Object.values(everydayBrowserFiles)
    .flat()
    .map((name) => `tests/${name}`),
  ...everydaySiteFiles.map((name) => `web/tests/${name}`),
].map((name) => `${name}.browser.test.js`)

/** Test files without a browser that only run with `--all`: each takes 4 s or more, and rarely fails alone. */
export const rareFiles = [
  // Commands of the program, whose parts are covered by tests of `emit` and `bake`.
  ...['cli/glsl', 'cli/info', 'cli/program'],
  // Linear time, and large models.
  ...['compile/large', 'mesh/real-models'],
  // Random and changed sources, and many noises; other tests compare fewer.
  ...['compile/untamed', 'glsl-source/grammar', 'glsl-source/long-loops', 'mesh/subdivision'],
  // The step "Dependency rules" checks the rules themselves.
  'scripts/dependencies',
].map((name) => `tests/${name}.test.js`)

const variable = 'WARPJET_TIER'

/** Sets the tier of this process and of its child processes: 'everyday' or 'all'. */
export const chooseTier = (tier) => (process.env[variable] = tier)

const isEveryday = () => process.env[variable] === 'everyday'

/** Returns whether this run includes a test file. */
export const isFileRun = (file) =>
  !isEveryday() ||
  (/\.browser\./.test(file) ? everydayFiles.includes(file) : !rareFiles.includes(file))

/** Returns whether this run includes the parts of test files that only run with `--all`. Callers name the part for the reader. */
export const isRun = (_part) => !isEveryday()
