// Tests that all four wasm modules work in strict environments: under a Content-Security-Policy without unsafe-eval, in a worker, and from
// a file without a server. Runs in Chromium and in Firefox.
import assert from 'node:assert/strict'
import { mkdirSync, writeFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { servePages } from '../support/browser/server.js'
import { browsers } from '../support/browser/two-browsers.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const folder = '.build/wasm-modules'

/** The source of a function that uses each module in the folder `dist`, and returns the results. */
const work = `async function work(dist) {
  const { compileWarp } = await import(dist + '/warpjet.js')
  const { loadMesh, subdivide } = await import(dist + '/mesh.js')
  const { glslOffset } = await import(dist + '/glsl.js')
  const text = 'vec3 offset(vec3 position) { return 2.0 * position; }'
  const warp = compileWarp(glslOffset(text))
  const mesh = await loadMesh(new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n'))
  const { positions } = warp.evaluate(subdivide(mesh, { warp, tolerance: 0.1 }))
  const bounds = warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] })
  return [typeof warp.code, positions.slice(0, 9), bounds.max.map(Math.round)].join()
}`
const expectedResults = 'string,0,0,0,3,0,0,0,3,0,3,3,3'

/** Returns code that writes the result of `promise` into the title of the page. */
const writeToTitle = (promise) =>
  `${promise}.then((text) => (document.title = text), (error) => (document.title = String(error)))`

const files = {
  'page.js': `${work}\n${writeToTitle("work('/dist')")}`,
  'worker.js': `${work}\nwork(location.origin + '/dist').then(postMessage, (error) => postMessage(String(error)))`,
  'file.html': `<!doctype html><meta charset="utf-8"><script src="../../node_modules/p5/lib/p5.min.js"></script>
    <script src="../../dist/p5.warpjet.min.js"></script><script src="../../dist/warpjet.glsl.min.js"></script><script>
    const warp = warpjet.compileWarp(warpjet.glslOffset('vec3 offset(vec3 position) { return 2.0 * position; }'))
    document.title = warp.evaluateAt([1, 2, 3]).position.join()
    </script>`,
}

let server
before(async () => {
  mkdirSync(root + folder, { recursive: true })
  for (const [name, text] of Object.entries(files)) writeFileSync(`${root}${folder}/${name}`, text)
  server = await servePages()
})
after(() => server.close())

for (const [name, launch] of Object.entries(browsers))
  describe(name, () => {
    let browser
    before(async () => (browser = await launch()))
    after(() => browser?.close())

    async function titleOf(url) {
      const page = await browser.newPage()
      await page.goto(url)
      await page.waitForFunction('document.title')
      const title = await page.title()
      await page.close()
      return title
    }

    test('runs all modules under a strict Content-Security-Policy', async () => {
      const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'"
      const html = `<!doctype html><meta http-equiv="Content-Security-Policy" content="${policy}">`
      const script = `<script type="module" src="/${folder}/page.js"></script>`
      assert.equal(await titleOf(server.page(html + script)), expectedResults)
      // The policy is in effect: code without permission does not run.
      const htmlWithoutPermission = html.replace(" 'wasm-unsafe-eval'", '')
      assert.match(
        await titleOf(server.page(htmlWithoutPermission + script)),
        /^WarpError: .*wasm-unsafe-eval/,
      )
    })

    test('runs all modules in a module worker', async () => {
      const html = `<!doctype html><script type="module">
        const worker = new Worker('/${folder}/worker.js', { type: 'module' })
        worker.onmessage = ({ data }) => (document.title = data)
        worker.onerror = ({ message }) => (document.title = message)
      </script>`
      assert.equal(await titleOf(server.page(html)), expectedResults)
    })

    test('runs all modules from a file', async () => {
      assert.equal(await titleOf(pathToFileURL(`${root}${folder}/file.html`).href), '3,6,9')
    })
  })
