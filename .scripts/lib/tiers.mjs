// The two tiers of the tests, named here and nowhere else: `npm test` is the everyday run, `npm test -- --all` is everything.
// On two quiet cores, with everything built, they take at most 6 and 15 minutes. Where nothing was ever compiled, the everyday
// run takes at most 10; building adds five minutes or more to everything.
// What is not left out below is run every day. What is started by hand, such as one file by `node --test`, is run whole.

/** What an everyday run leaves out, each with the reason: whole steps by title, whole files, and parts that files ask `isRun` for. */
export const leftOut = {
  steps: {
    'The same under ASan and UBSan':
      'compiling it takes twice as long as for the native tests; these have the checks of the standard library',
    Fuzzing:
      'searching takes twenty seconds of each core; its corpus is run every day with the C++ tests',
    'The package in its environments':
      'it installs 900 MB of bundlers and needs the npm registry; what it proves changes only with package.json and the build',
  },
  files: {
    'tests/scripts/bench.browser.test.js':
      'the benchmark is run seldom, by hand, and ships to nobody',
    'tests/scripts/bench-pages.browser.test.js': 'likewise its page',
    'tests/scripts/bench-results.browser.test.js': 'likewise the page of its results',
    'web/tests/drop.browser.test.js':
      'the page for one’s own model changes seldom; what it calls has its tests every day',
    'web/tests/site.browser.test.js':
      'it opens every page twice, which takes minutes; web/tests/site.test.js holds their links, and gallery.test.js opens some',
    'web/tests/site-motion.browser.test.js':
      'likewise; gallery.test.js sees every day that the first page draws',
    'web/tests/site-offline.browser.test.js': 'likewise; it waits until all of the site is kept',
    'web/tests/docs.browser.test.js':
      'each block starts a p5 of its own, which takes minutes in all; what they call has its tests every day',
    'web/tests/playground.browser.test.js':
      'each of its sketches starts a p5 of its own, which takes minutes in all; the page ships to nobody',
    'web/tests/playground-costs.browser.test.js': 'likewise, for its costs and checks',
    'web/tests/playground-help.browser.test.js': 'likewise, for what completes and explains',
    'web/tests/playground-habits.browser.test.js': 'likewise, for what one does beside writing',
    'web/tests/playground-hosts.browser.test.js': 'likewise, for each of its hosts',
    'web/tests/playground-examples.browser.test.js':
      'likewise; gallery.test.js draws every example every day',
    'tests/p5/script.browser.test.js':
      'the loader of the script changes seldom; p5.test.js and all like it load it every day',
    'tests/entries/bundler.browser.test.js': 'likewise what a bundler makes of the modules',
    'tests/p5/webgpu.browser.test.js': 'what it compares with WebGL has its tests there every day',
    'tests/p5/webgpu-examples.browser.test.js':
      'each is drawn by WebGL every day, and on a CPU a page with both takes ten seconds',
    'tests/p5/p5-1-pictures.browser.test.js':
      'it opens ninety pages twice; p5-1.test.js has a smoke test, and docs.test.js and gallery.test.js draw them by p5 2',
    'tests/three/webgpu.browser.test.js':
      'without a GPU it is slow, and the nodes hold the text that three.test.js draws',
    'tests/three/react.browser.test.js': 'what it wraps has its tests every day',
    'tests/babylon/babylon.browser.test.js':
      'the plugin is small, and bundling Babylon.js takes long',
  },
  parts: {
    'p5 1.11':
      'what it does differently is little and changes seldom; p5-1.test.js has a smoke test',
    'p5 on WebGPU':
      'it draws the same warps through the same hooks, on a CPU at a fifth of the speed',
    'three 0.159': 'what the oldest three.js does differently is little and changes never',
    'a thousand rays': 'a hundred find what is wrong for all',
    'every material of three':
      'the shaders of three’s materials are made of the same chunks; every day seven go through them',
    'all dialects':
      'WebGL 1 and WebGPU run the same nodes as WebGL 2, in words that tests/golden keeps for each dialect',
    'every example through the page':
      'the page frames every example alike; every day each is drawn by itself, and three through it',
    'the gallery built, and on a phone':
      'it takes Vite ten seconds, and shows the pages that the server shows',
    'every model':
      'normals.test.js bakes every warp every day, on a mesh that has everything; a quarter of them meets a model, too',
    'every vertex': 'a third of them still lies on every side, edge and axis',
    'every random expression':
      'the others are of the same kinds; 500 are run on the CPU every day, 400 on the GPU',
    'glass and lanterns':
      'without a GPU both take half a minute; three.test.js draws such materials and instances every day',
    'every TypeScript':
      'one run with the oldest TypeScript and one with the newest find nearly all there is to find',
    'a week of every warp': 'each is reduced in the same way; every day three go through it',
    'rare pages of p5': 'what a sketch seldom does changes seldom, and each page takes a second',
    'thousands of warps': 'fewer show a leak of one byte a warp just as well',
    'deep domain warping':
      'its texts take a compiler without a GPU half a minute; the others are drawn by gallery.test.js',
  },
}

/** In minutes. */
export const limits = { everyday: 6, all: 15 }

const variable = 'WARPJET_TIER'

/** Sets the tier of this process and of those that it starts. */
export const chooseTier = (tier) => (process.env[variable] = tier)

export const isEveryday = () => process.env[variable] === 'everyday'

/** Whether a part of a test file belongs to this run. */
export function isRun(part) {
  if (!(part in leftOut.parts)) throw new Error(`tiers.mjs gives no reason to leave out ${part}.`)
  return !isEveryday()
}
