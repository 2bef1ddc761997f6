// Tests how loadWarpModel finds models and the scripts that it needs: in preload, from other servers, as a module, and from a script that
// was copied without the others.
import assert from 'node:assert/strict'
import { copyFileSync, mkdirSync, readFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage } from '../support/browser/browser.js'
import { addon } from '../support/browser/p5-hosts.js'
import { path, red, writeModels } from '../support/browser/p5-models.js'
import { colorAt, readPixels } from '../support/browser/pixels.js'
import { openHost, p5InThisRun, p5Versions, runSketch } from '../support/browser/sketch.js'

const size = 300
const folder = writeModels('model-loading-test')
// A copy of the script without other files next to it.
const alone = `${folder}/alone/p5.warpjet.min.js`
mkdirSync(path(`${folder}/alone`), { recursive: true })
copyFileSync(path(addon), path(alone))

const { browser, server } = await openHost()

for (const [version, p5] of p5InThisRun) {
  /** Loads a model with these scripts. Returns its number of faces, or the message of the error. */
  async function load(file, scripts) {
    const { page } = await runSketch(
      browser,
      server,
      scripts,
      `function setup() {
        createCanvas(10, 10, WEBGL)
        loadWarpModel('${folder}/${file}')
          .then(({ faces }) => faces.length, ({ message }) => message)
          .then((result) => Object.assign(window, { result, done: true }))
      }`,
    )
    const result = await page.evaluate('result')
    await leavePage(page)
    return result
  }

  test(`p5 ${version}: loading a model compressed by meshopt needs the decoder's script, and without it a message says so`, async () => {
    const decoder = '/node_modules/meshoptimizer/meshopt_decoder.cjs'
    assert.equal(await load('packed.glb', [p5, decoder, addon]), 12)
    assert.match(
      await load('packed.glb', [p5, addon]),
      /^loadWarpModel: the model is compressed by EXT_meshopt_compression, .* MeshoptDecoder/,
    )
  })

  test(`p5 ${version}: loadWarpModel names the missing file next to a script that was copied alone`, async () => {
    assert.equal(
      await load('plain.glb', [p5, alone]),
      `loadWarpModel: cannot load ${server.url}${folder}/alone/mesh.min.js; copy it there, from the package's folder dist.`,
    )
  })
}

describe('loadWarpModel in preload, on p5 1.11', () => {
  for (const mode of isRun('p5 1.11') ? ['global', 'instance'] : ['global'])
    test(`loads models before setup in ${mode} mode`, async () => {
      const [p5Object, start] = mode === 'global' ? ['window', ''] : ['p', 'new p5((p) => {']
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5Versions['1.11'], addon],
        `${start}
        let tip, bunny
        ${p5Object}.preload = () => {
          tip = ${p5Object}.loadWarpModel('${folder}/plain.glb')
          bunny = ${p5Object}.loadWarpModel('${folder}/bunny.glb')
        }
        ${p5Object}.setup = () => {
          window.report = [tip.vertices.length, tip instanceof p5.Geometry, 'then' in tip, bunny.faces.length]
          ${p5Object}.createCanvas(${size}, ${size}, ${p5Object}.WEBGL)
          ${p5Object}.noLoop()
        }
        ${p5Object}.draw = () => {
          ${p5Object}.background(0); ${p5Object}.noStroke(); ${p5Object}.fill(255, 0, 0); ${p5Object}.ortho()
          ${p5Object}.model(tip)
          window.done = true
        }
        ${start && '})'}`,
      )
      const image = await readPixels(page)
      assert.deepEqual(await page.evaluate('report'), [3, true, false, 3674])
      await leavePage(page)
      assert.deepEqual(messages, [])
      assert.deepEqual(colorAt(image, size / 2, size / 2), red)
    })
})

describe('loadWarpModel from other servers', () => {
  test('fetches mesh.min.js from the server of the script', async () => {
    const context = await browser.newContext()
    const cdn = server.url.replace('localhost', '127.0.0.1')
    const fetched = []
    await context.route(`${cdn}/**`, async (route) => {
      fetched.push(new URL(route.request().url()).pathname)
      const response = await route.fetch()
      await route.fulfill({
        response,
        headers: { ...response.headers(), 'access-control-allow-origin': '*' },
      })
    })
    const { page, messages } = await runSketch(
      context,
      server,
      [p5Versions['2.x'], `${cdn}${addon}`],
      `async function setup() {
        window.tip = await loadWarpModel('${folder}/plain.glb')
        window.done = true
      }`,
    )
    assert.deepEqual(messages, [])
    assert.equal(await page.evaluate('tip.faces.length'), 1)
    await context.close()
    assert.ok(fetched.includes('/dist/mesh.min.js'), fetched.join())
  })

  test('logs an error about a model that cannot be loaded in preload, and setup never starts', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['1.11'], addon],
      `function preload() { loadWarpModel('${folder}/words.glb') }
      function setup() { window.isSetUp = true }`,
    )
    assert.equal(await page.evaluate('window.isSetUp'), undefined)
    await leavePage(page)
    assert.deepEqual(
      messages.map((text) =>
        /^(uncaught|\s*🌸 p5\.js says): loadWarpModel: /.exec(text)?.[1].trim(),
      ),
      ['🌸 p5.js says', 'uncaught'],
    )
  })
})

test("'warpjet/p5' as a module fetches the mesh module on first use", async () => {
  assert.match(readFileSync(path('/dist/p5.warpjet.min.js'), 'utf8'), /import\(\w+\)/)
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x']],
    `import '/dist/p5.js'
    const hasFetchedMesh = () => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/meshes.js'))
    window.report = [hasFetchedMesh()]
    new p5((p) => {
      p.setup = async () => {
        const tip = await p.loadWarpModel('${folder}/plain.glb')
        report.push(hasFetchedMesh(), tip.vertices.length)
        window.done = true
      }
    })`,
    'module',
  )
  assert.deepEqual(await page.evaluate('report'), [false, true, 3])
  await leavePage(page)
  assert.deepEqual(messages, [])
})
