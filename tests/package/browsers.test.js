// A project with p5, built by each bundler, must run in Chromium: `import 'warpjet/p5'` registers the functions, a model is loaded, a mesh
// is warped, and nothing is printed.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { rolldown } from 'rolldown'
import * as vite from 'vite'
import { launchBrowser, openPage } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'
import { folder, load, project, runIn } from './support/project.js'

let browser, pages
before(async () => {
  browser = await launchBrowser()
  pages = await servePages()
})
after(async () => {
  await browser.close()
  await pages.close()
})

/** Asserts that a page draws and warps a mesh, without messages. */
async function assertDraws(url) {
  const { page, messages } = await openPage(browser, url)
  await page
    .waitForFunction(() => document.title.startsWith('drawn'), { timeout: 20_000 })
    .catch(() => messages.push(`nothing was drawn at ${page.url()}`))
  assert.deepEqual(messages, [])
  assert.equal(await page.title(), 'drawn 1,0,0')
  await page.close()
}

/** Returns the address of a page with a script. */
const pageWith = (script) =>
  pages.page(`<!doctype html><body><script type="module" src="/${folder}/${script}"></script>`)
const viteOptions = { configFile: false, logLevel: 'error', root: project }

test('a build by Vite draws', async () => {
  const outDir = 'out/vite'
  await vite.build({ ...viteOptions, base: './', build: { outDir, emptyOutDir: true } })
  await assertDraws(`${pages.url}/${folder}/${outDir}/index.html`)
})

test('a worker built by Vite warps a mesh', async () => {
  const rolldownOptions = {
    input: `${project}/with-worker.js`,
    output: { entryFileNames: 'main.js' },
  }
  await vite.build({
    ...viteOptions,
    base: './',
    worker: { format: 'es' },
    build: { outDir: 'out/vite-worker', rolldownOptions },
  })
  await assertDraws(pageWith('out/vite-worker/main.js'))
})

test("a page of Vite's development server draws", async () => {
  const server = await vite.createServer({ ...viteOptions, server: { port: 0, host: '127.0.0.1' } })
  try {
    await server.listen()
    const { port } = server.httpServer.address()
    // Vite reloads the page as soon as it has found packages to prebundle.
    await server.warmupRequest('/sketch.js')
    await server.environments.client.depsOptimizer?.scanProcessing
    const { page, messages } = await openPage(browser, `http://127.0.0.1:${port}/`)
    await page.waitForFunction(() => document.title === 'drawn 1,0,0', { timeout: 30_000 })
    assert.deepEqual(
      messages.filter((message) => !message.startsWith('[vite]')),
      [],
    )
    await page.close()
  } finally {
    await server.close()
  }
})

for (const entry of ['sketch', 'with-worker'])
  test(`a build by webpack draws, ${entry}`, async () => {
    const { default: webpack } = await load('webpack')
    const path = `${project}/out/webpack-${entry}`
    const stats = await new Promise((resolve, reject) =>
      webpack(
        {
          mode: 'development',
          devtool: false,
          context: project,
          entry: `./${entry}.js`,
          output: { path, filename: 'main.js', publicPath: `/${folder}/out/webpack-${entry}/` },
          performance: false,
        },
        (error, found) => (error ? reject(error) : resolve(found)),
      ),
    )
    const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true })
    assert.deepEqual(
      [...errors, ...warnings].map(({ message }) => message),
      [],
    )
    await assertDraws(pageWith(`out/webpack-${entry}/main.js`))
  })

test('a build by esbuild draws', async () => {
  const { build } = await load('esbuild')
  const { warnings } = await build({
    absWorkingDir: project,
    entryPoints: ['sketch.js'],
    bundle: true,
    format: 'esm',
    splitting: true,
    outdir: 'out/esbuild',
    logLevel: 'silent',
  })
  assert.deepEqual(warnings, [])
  await assertDraws(pageWith('out/esbuild/sketch.js'))
})

/**
 * Builds with Rollup or rolldown, which have the same options here. Both would warn about suspicious code, such as an import without
 * effect.
 */
async function testRollBundler(bundler, dir, plugins) {
  const warnings = []
  const onwarn = ({ message }) => warnings.push(message)
  const bundle = await bundler({ input: `${project}/sketch.js`, onwarn, plugins })
  await bundle.write({ dir: `${project}/${dir}`, format: 'es' })
  await bundle.close()
  assert.deepEqual(warnings, [])
  await assertDraws(pageWith(`${dir}/sketch.js`))
}

/** Resolves p5 to its single-file build: p5 imports CommonJS modules, which Rollup does not support. */
const p5InOneFile = {
  name: 'p5-in-one-file',
  resolveId: (name) => (name === 'p5' ? `${project}/node_modules/p5/lib/p5.esm.min.js` : null),
}

for (const browser of [false, true])
  test(`a build by Rollup draws, ${browser ? 'for browsers' : 'with default settings'}`, async () => {
    const { rollup } = await load('rollup')
    const { default: nodeResolve } = await load('@rollup/plugin-node-resolve')
    await testRollBundler(rollup, `out/rollup-${browser}`, [p5InOneFile, nodeResolve({ browser })])
  })

test('a build by rolldown draws', () => testRollBundler(rolldown, 'out/rolldown', [p5InOneFile]))

// tests/package/package.json makes Parcel read `exports`, which it ignores by default, and p5's single-file build, since Parcel would drop
// parts of the other builds.
test('a build by Parcel draws', async () => {
  const { output, status } = runIn(process.execPath, [
    'node_modules/parcel/lib/bin.js',
    'build',
    'index.html',
    '--dist-dir=out/parcel',
    '--cache-dir=out/parcel-cache',
    '--public-url=./',
    '--no-source-maps',
    '--no-optimize',
  ])
  assert.equal(status, 0, output)
  await assertDraws(`${pages.url}/${folder}/out/parcel/index.html`)
})

test('Next renders a page on the server', async () => {
  const { output, status } = runIn(process.execPath, ['node_modules/next/dist/bin/next', 'build'], {
    NEXT_TELEMETRY_DISABLED: '1',
  })
  assert.equal(status, 0, output)
  assert.doesNotMatch(output, /warn/i)
  const { readFileSync } = await import('node:fs')
  const html = readFileSync(`${project}/out-next/index.html`, 'utf8')
  assert.match(html, /moved 1,0,0 function,true,true,true/)
  assert.match(html, /compiled/)
})

const importMap = (names) =>
  `<script type="importmap">${JSON.stringify({
    imports: Object.fromEntries(
      names.map(([name, file]) => [name, `/${folder}/node_modules/${file}`]),
    ),
  })}</script>`
const modules = importMap([
  ['p5', 'p5/lib/p5.esm.min.js'],
  ['warpjet', 'warpjet/dist/warpjet.js'],
  ['warpjet/p5', 'warpjet/dist/p5.browser.js'],
  ['warpjet/mesh', 'warpjet/dist/mesh.js'],
  ['warpjet/deformers', 'warpjet/dist/deformers.js'],
])
const start = `<script type="module" src="/${folder}/sketch.js"></script>`

test('an import map works without a bundler', () =>
  assertDraws(pages.page(`<body>${modules}${start}`)))

test('an import map works under a Content-Security-Policy', () =>
  assertDraws(
    pages.page(
      `<meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src * data:; connect-src data:"><body>${modules}${start}`,
    ),
  ))

test('a module worker works without a bundler', () =>
  assertDraws(
    pages.page(`<script type="module">
      const worker = new Worker('/${folder}/unbundled-worker.js', { type: 'module' })
      worker.onmessage = ({ data }) => (document.title = data)
      worker.onerror = ({ message }) => console.error(message)
    </script>`),
  ))

test('two script tags draw', () =>
  assertDraws(
    pages.page(`<body>
      <script src="/${folder}/node_modules/p5/lib/p5.min.js"></script>
      <script src="/${folder}/node_modules/warpjet/dist/p5.warpjet.min.js"></script>
      <script src="/${folder}/node_modules/warpjet/dist/warpjet.deformers.min.js"></script>
      <script>
        let distort, shape
        async function setup() {
          createCanvas(60, 60, WEBGL)
          distort = createWarp(warpjet.twist({ length: 1 }))
          shape = await loadWarpModel('/${folder}/triangle.obj', { normalize: false })
        }
        function draw() {
          if (!shape) return
          noLoop()
          distort()
          model(shape)
          const { x, y, z } = shape.vertices[1]
          document.title = 'drawn ' + [x, Math.abs(y), z]
        }
      </script>`),
  ))
