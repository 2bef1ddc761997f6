// Tests the script p5.warpjet.min.js on real pages: from another origin, with other scripts in any order, and under a content security
// policy.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { leavePage, openPage } from '../support/browser/browser.js'
import { openHost, p5InThisRun, p5Versions, runSketch } from '../support/browser/sketch.js'

const path = (name) => fileURLToPath(new URL(`../..${name}`, import.meta.url))
const dist = (name) => readFileSync(path(`/dist/${name}`), 'utf8')

const script = '/dist/p5.warpjet.min.js'
const deformers = '/dist/warpjet.deformers.min.js'
const { version } = JSON.parse(readFileSync(path('/package.json'), 'utf8'))
const cdn = 'https://cdn.jsdelivr.net'
/** The address of the companion script of this version. */
const companion = `${cdn}/npm/warpjet@${version}/dist/mesh.min.js`
const triangle = 'data:model/obj,v 4 0 0%0Av 6 0 0%0Av 5 1 0%0Af 1 2 3'

const { browser, server } = await openHost()

/**
 * Returns a context in which other hosts serve only `files`, which maps addresses to contents; `requests` lists the requested addresses.
 */
async function withHosts(files) {
  const context = await browser.newContext()
  const requests = []
  await context.route(/^https:/, async (route) => {
    const url = route.request().url()
    requests.push(url)
    if (files[url] === undefined) return route.fulfill({ status: 404 })
    const headers = { 'access-control-allow-origin': '*', 'content-type': 'text/javascript' }
    return route.fulfill({ headers, body: files[url] })
  })
  return { context, requests }
}

/**
 * Loads a model in a sketch with this script. Returns the `result`, which is the number of vertices or a message of an error; `isForeign`,
 * whether a foreign script ran; and all console messages.
 */
async function loadModel(context, src) {
  const { page, messages } = await runSketch(
    context,
    server,
    [p5Versions['2.x'], src],
    `async function setup() {
      window.result = await loadWarpModel('${triangle}').then((model) => model.vertices.length, ({ message }) => message)
      window.done = true
    }`,
  )
  const result = await page.evaluate('result')
  const isForeign = await page.evaluate('!!window.isForeign')
  await leavePage(page)
  return { result, isForeign, messages }
}

describe('a script from a CDN', () => {
  const foreign = 'window.isForeign = true; export const loadMesh = () => {}'

  for (const src of [
    `${cdn}/npm/warpjet`,
    `${cdn}/npm/warpjet@latest`,
    `${cdn}/combine/npm/other,npm/warpjet@0.1/dist/p5.warpjet.min.js`,
  ])
    test(`${src} loads no foreign package`, async () => {
      const filesNextToIt = ['mesh.js', 'mesh.min.js'].map((name) => [
        new URL(name, src).href,
        foreign,
      ])
      const { context, requests } = await withHosts({
        ...Object.fromEntries(filesNextToIt),
        [src]: dist('p5.warpjet.min.js'),
        [companion]: dist('mesh.min.js'),
      })
      const { result, isForeign } = await loadModel(context, src)
      await context.close()
      assert.equal(isForeign, false)
      assert.equal(result, 3)
      assert.deepEqual([...new Set(requests)], [src, companion])
    })

  test('does not run a companion script that differs from the published one', async () => {
    const src = `${cdn}/npm/warpjet`
    const { context } = await withHosts({
      [src]: dist('p5.warpjet.min.js'),
      [companion]: `${dist('mesh.min.js')}\n;window.isForeign = true`,
    })
    const { result, isForeign } = await loadModel(context, src)
    await context.close()
    assert.equal(isForeign, false)
    assert.match(result, /^loadWarpModel: cannot load https:\S+mesh\.min\.js; /)
  })

  test('that has its original name loads the companion next to it', async () => {
    const folder = `${cdn}/npm/warpjet@0.1/dist`
    const { context, requests } = await withHosts({
      [`${folder}/p5.warpjet.min.js`]: dist('p5.warpjet.min.js'),
      [`${folder}/mesh.min.js`]: dist('mesh.min.js'),
    })
    const { result } = await loadModel(context, `${folder}/p5.warpjet.min.js`)
    await context.close()
    assert.equal(result, 3)
    assert.ok(requests.includes(`${folder}/mesh.min.js`))
  })
})

test('a copy with another name loads the companion of its version from the CDN', async () => {
  mkdirSync(path('/.build/script-test'), { recursive: true })
  writeFileSync(path('/.build/script-test/warp.js'), dist('p5.warpjet.min.js'))
  const { context, requests } = await withHosts({ [companion]: dist('mesh.min.js') })
  const { result } = await loadModel(context, '/.build/script-test/warp.js')
  await context.close()
  assert.equal(result, 3)
  assert.deepEqual([...new Set(requests)], [companion])
})

test('p5.warpjet.min.js evaluates a warp on the CPU', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x'], script],
    `const offset = ({ glsl, position }) => glsl.vec3(position.y(), 0, 0)
    function setup() {
      createCanvas(50, 50, WEBGL)
      const warp = createWarp(offset)
      warp()
      sphere(10)
      noLoop()
      try {
        window.result = warpjet.compileWarp(offset).evaluateAt([1, 2, 3]).position
      } catch ({ name, message }) {
        window.result = name + ': ' + message
      }
      window.done = true
    }`,
  )
  const result = await page.evaluate('window.result')
  await page.close()
  assert.deepEqual(messages, [])
  assert.deepEqual(result, [3, 2, 3])
})

describe('the order of scripts', () => {
  const setup = `function setup() {
    createCanvas(50, 50, WEBGL)
    window.kind = typeof createWarp(({ glsl }) => glsl.vec3(1, 0, 0))
    noLoop()
    window.done = true
  }`
  /** Returns a sketch that adds p5 after the page has loaded. */
  const addLater = (p5) => `${setup}
    addEventListener('load', () => setTimeout(() => {
      document.head.append(Object.assign(document.createElement('script'), { src: '${p5}' }))
    }, 50))`

  for (const [name, p5] of p5InThisRun)
    for (const file of [p5, p5.replace('.js', '.min.js')]) {
      test(`p5 ${name} may follow the script, ${file}`, async () => {
        const { page, messages } = await runSketch(browser, server, [script, file], setup)
        assert.equal(await page.evaluate('window.kind'), 'function')
        await leavePage(page)
        assert.deepEqual(messages, [])
      })

      test(`p5 ${name} may be added after the page has loaded, ${file}`, async () => {
        const { page, messages } = await runSketch(browser, server, [script], addLater(file))
        assert.equal(await page.evaluate('window.kind'), 'function')
        await leavePage(page)
        const others = messages.filter(
          (message) => !message.includes('there is no p5 on this page'),
        )
        assert.deepEqual(others, [])
      })
    }

  test('a page without p5 gets a warning', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [script],
      `addEventListener('load', () => setTimeout(() => (window.done = true), 50))`,
    )
    await leavePage(page)
    assert.equal(messages.length, 1)
    assert.match(messages[0], /^warpjet: there is no p5 on this page, which createWarp needs;/)
  })

  test('a second script preserves the first one and its additions, such as deformers', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['2.x'], script, deformers, script],
      `function setup() {
        createCanvas(50, 50, WEBGL)
        const { twist, WarpError } = warpjet
        try { twist(5) } catch (error) { window.isOurs = error instanceof WarpError }
        window.kind = typeof createWarp(twist())
        window.done = true
      }`,
    )
    assert.equal(await page.evaluate('kind'), 'function')
    assert.equal(await page.evaluate('isOurs'), true)
    await leavePage(page)
    assert.deepEqual(messages, [])
  })

  test('a second script of another version warns', async () => {
    mkdirSync(path('/.build/script-test'), { recursive: true })
    const other = dist('p5.warpjet.min.js').replaceAll(`\`${version}\``, '`9.8.7`')
    writeFileSync(path('/.build/script-test/p5.warpjet.min.js'), other)
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['2.x'], script, '/.build/script-test/p5.warpjet.min.js'],
      `window.version = warpjet.version; window.done = true`,
    )
    assert.equal(await page.evaluate('window.version'), version)
    await leavePage(page)
    assert.equal(messages.length, 1)
    assert.match(
      messages[0],
      new RegExp(`two versions, ${version} and then 9\\.8\\.7; only the first`),
    )
  })
})

describe('a page whose policy is script-src self', () => {
  /** Makes calls that need WebAssembly on a page with such a policy. Returns 'works' or the message of each call. */
  async function loadWithPolicy(policy) {
    const html = `<!doctype html>
      <meta http-equiv="Content-Security-Policy" content="script-src 'self' ${policy}">
      <script src="${p5Versions['2.x']}"></script>
      <script src="${script}"></script>`
    const { page, messages } = await openPage(browser, server.page(html))
    const results = await page.evaluate(async (model) => {
      const problem = (error) => `${error.name}: ${error.message}`
      const messageOf = async (work) =>
        Promise.resolve()
          .then(work)
          .then(() => 'works', problem)
      const { compileWarp } = await import('/dist/warpjet.min.js')
      const { loadMesh } = await import('/dist/mesh.min.js')
      const still = ({ glsl }) => glsl.vec3(0, 0, 0)
      return [
        await messageOf(() => warpjet.compileWarp(still)),
        await messageOf(() => compileWarp(still).evaluateAt([0, 0, 0])),
        await messageOf(() => loadMesh(model)),
      ]
    }, triangle)
    await leavePage(page)
    return { results, messages }
  }

  test('gets messages that say what to add to the policy', async () => {
    const { results } = await loadWithPolicy('')
    for (const result of results) {
      assert.match(result, /^WarpError: .*WebAssembly/)
      assert.match(result, /Content-Security-Policy .* header .* <meta> .*'wasm-unsafe-eval'/)
    }
  })

  test("only needs to add 'wasm-unsafe-eval'", async () => {
    const { results, messages } = await loadWithPolicy("'wasm-unsafe-eval'")
    assert.deepEqual(results, ['works', 'works', 'works'])
    assert.deepEqual(messages, [])
  })

  // Sets the policy when the wasm modules are already compiled, so that it only forbids the machine code of warps. A policy from the start
  // would also forbid the modules.
  test('if a policy is set later, the interpreter evaluates warps with the same bits as machine code', async () => {
    const { page, messages } = await openPage(browser, server.page('<!doctype html>'))
    const found = await page.evaluate(async () => {
      const { compileWarp } = await import('/dist/warpjet.min.js')
      const { Module } = WebAssembly
      const outcomes = []
      WebAssembly.Module = function (bytes) {
        outcomes.push('forbidden')
        const module = new Module(bytes)
        outcomes[outcomes.length - 1] = 'made'
        return module
      }
      const bend = ({ glsl, position, millis }) =>
        position
          .yzx()
          .mult(0.02)
          .add(millis.div(1000))
          .sin()
          .mult(glsl.vec3(8, 9, 10))
      const numbers = (size) =>
        Float32Array.from({ length: 3 * size }, (_, i) => 50 * Math.sin(i * i))
      const uniforms = { millis: 1234 }
      const bits = (warp, vertices = 1001) => {
        const mesh = { positions: numbers(vertices), normals: numbers(vertices) }
        const { positions, normals } = warp.evaluate(mesh, { uniforms })
        return [positions, normals].map((array) => String(new Uint32Array(array.buffer))).join()
      }
      const [first, second] = [compileWarp(bend), compileWarp(bend)]
      const expected = [bits(first), bits(second)]
      expected.push(bits(first))
      const point = JSON.stringify(first.evaluateAt([1, 2, 3], { uniforms }))
      const before = outcomes.splice(0)

      const policy = document.createElement('meta')
      policy.httpEquiv = 'Content-Security-Policy'
      policy.content = "script-src 'self'"
      document.head.append(policy)
      const results = [bits(second), bits(second), bits(first)]
      const points = [1, 2, 3].map(() => JSON.stringify(second.evaluateAt([1, 2, 3], { uniforms })))
      const many = bits(compileWarp(bend), 40_000).length
      return {
        before,
        after: outcomes,
        same: [...expected, ...results].map((text) => text === expected[0]),
        points: points.map((text) => text === point),
        many,
      }
    })
    await leavePage(page)
    assert.ok(found.before.length > 0 && found.before.every((outcome) => outcome === 'made'))
    assert.deepEqual(found.after, ['forbidden'], 'expected one attempt to compile')
    assert.deepEqual(found.same, [true, true, true, true, true, true])
    assert.deepEqual(found.points, [true, true, true])
    assert.ok(found.many > 40_000 * 6)
    assert.deepEqual(messages, [])
  })
})

describe('a page that was opened as a file', () => {
  /** Returns the message of loadWarpModel on such a page; 'none' if it works. */
  async function findProblem(context, src, model) {
    mkdirSync(path('/.build/script-test'), { recursive: true })
    writeFileSync(
      path('/.build/script-test/page.html'),
      `<!doctype html><meta charset="utf-8"><script src="../..${p5Versions['2.x']}"></script><script src="${src}"></script>
      <script>
        async function setup() {
          window.problem = await loadWarpModel('${model}').then(() => 'none', ({ message }) => message)
          window.done = true
        }
      </script>`,
    )
    const page = await context.newPage()
    await page.goto(pathToFileURL(path('/.build/script-test/page.html')).href)
    await page.waitForFunction(() => window.done)
    const result = await page.evaluate('window.problem')
    await page.close()
    return result
  }

  test('gets the advice to serve it', async () => {
    const { context } = await withHosts({
      [`${cdn}/npm/warpjet`]: dist('p5.warpjet.min.js'),
      [companion]: dist('mesh.min.js'),
    })
    for (const src of [`../..${script}`, `${cdn}/npm/warpjet`])
      assert.match(
        await findProblem(context, src, 'bunny.glb'),
        /^loadWarpModel: .* opened as a file may read no other file, so serve its folder/,
        src,
      )
    assert.equal(await findProblem(context, `${cdn}/npm/warpjet`, triangle), 'none')
    await context.close()
  })
})
