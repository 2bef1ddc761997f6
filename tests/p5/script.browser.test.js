// Tests the single script on real pages: from another origin, with other scripts in any order, and under a content security policy.
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
const ownMesh = `${cdn}/npm/warpjet@${version}/dist/mesh.min.js`
const triangle = 'data:model/obj,v 4 0 0%0Av 6 0 0%0Av 5 1 0%0Af 1 2 3'

const { browser, server } = await openHost()

/** Returns a context in which other hosts answer only with `texts`, by address; `asked` lists the requests. */
async function withHosts(texts) {
  const context = await browser.newContext()
  const asked = []
  await context.route(/^https:/, async (route) => {
    const url = route.request().url()
    asked.push(url)
    if (texts[url] === undefined) return route.fulfill({ status: 404 })
    const headers = { 'access-control-allow-origin': '*', 'content-type': 'text/javascript' }
    return route.fulfill({ headers, body: texts[url] })
  })
  return { context, asked }
}

/** Loads a model in a sketch with this script → the number of vertices, or the message. */
async function loadedBy(context, src) {
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
      const beside = ['mesh.js', 'mesh.min.js'].map((name) => [new URL(name, src).href, foreign])
      const { context, asked } = await withHosts({
        ...Object.fromEntries(beside),
        [src]: dist('p5.warpjet.min.js'),
        [ownMesh]: dist('mesh.min.js'),
      })
      const { result, isForeign } = await loadedBy(context, src)
      await context.close()
      assert.equal(isForeign, false)
      assert.equal(result, 3)
      assert.deepEqual([...new Set(asked)], [src, ownMesh])
    })

  test('runs its companion only if it is the published one', async () => {
    const src = `${cdn}/npm/warpjet`
    const { context } = await withHosts({
      [src]: dist('p5.warpjet.min.js'),
      [ownMesh]: `${dist('mesh.min.js')}\n;window.isForeign = true`,
    })
    const { result, isForeign } = await loadedBy(context, src)
    await context.close()
    assert.equal(isForeign, false)
    assert.match(result, /^loadWarpModel: cannot load https:\S+mesh\.min\.js; /)
  })

  test('under its own name, uses the file next to it', async () => {
    const folder = `${cdn}/npm/warpjet@0.1/dist`
    const { context, asked } = await withHosts({
      [`${folder}/p5.warpjet.min.js`]: dist('p5.warpjet.min.js'),
      [`${folder}/mesh.min.js`]: dist('mesh.min.js'),
    })
    const { result } = await loadedBy(context, `${folder}/p5.warpjet.min.js`)
    await context.close()
    assert.equal(result, 3)
    assert.ok(asked.includes(`${folder}/mesh.min.js`))
  })
})

test('a copy under another name loads the companion of its version', async () => {
  mkdirSync(path('/.build/script-test'), { recursive: true })
  writeFileSync(path('/.build/script-test/warp.js'), dist('p5.warpjet.min.js'))
  const { context, asked } = await withHosts({ [ownMesh]: dist('mesh.min.js') })
  const { result } = await loadedBy(context, '/.build/script-test/warp.js')
  await context.close()
  assert.equal(result, 3)
  assert.deepEqual([...new Set(asked)], [ownMesh])
})

describe('the scripts with and without CPU evaluation', () => {
  /** Draws with createWarp, and returns the result of evaluateAt for the same offset. */
  async function evaluateWith(src) {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['2.x'], src],
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
    return result
  }

  test('warpjet.min.js evaluates a warp on the CPU', async () => {
    assert.deepEqual(await evaluateWith(script), [3, 2, 3])
  })
})

describe('the order of scripts', () => {
  const setup = `function setup() {
    createCanvas(50, 50, WEBGL)
    window.kind = typeof createWarp(({ glsl }) => glsl.vec3(1, 0, 0))
    noLoop()
    window.done = true
  }`
  /** Adds p5 to a page that has loaded. */
  const later = (p5) => `${setup}
    addEventListener('load', () => setTimeout(() => {
      document.head.append(Object.assign(document.createElement('script'), { src: '${p5}' }))
    }, 50))`

  for (const [name, p5] of p5InThisRun)
    for (const file of [p5, p5.replace('.js', '.min.js')]) {
      test(`p5 ${name} may be included after ${file}`, async () => {
        const { page, messages } = await runSketch(browser, server, [script, file], setup)
        assert.equal(await page.evaluate('window.kind'), 'function')
        await leavePage(page)
        assert.deepEqual(messages, [])
      })

      test(`p5 ${name} may be added after the page has loaded with ${file}`, async () => {
        const { page, messages } = await runSketch(browser, server, [script], later(file))
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
  /** Returns the messages of calls that need WebAssembly, under such a policy. */
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

  test('says what to add to the policy', async () => {
    const { results } = await loadWithPolicy('')
    for (const result of results) {
      assert.match(result, /^WarpError: .*WebAssembly/)
      assert.match(result, /Content-Security-Policy .* header .* <meta> .*'wasm-unsafe-eval'/)
    }
  })

  test("needs no more than 'wasm-unsafe-eval'", async () => {
    const { results, messages } = await loadWithPolicy("'wasm-unsafe-eval'")
    assert.deepEqual(results, ['works', 'works', 'works'])
    assert.deepEqual(messages, [])
  })

  // Sets the policy on a page whose compiler is already running, so that only machine code is forbidden; a policy from the start
  // would forbid both.
  test('a policy set after the start: the interpreter takes over, with the same bits as machine code', async () => {
    const { page, messages } = await openPage(browser, server.page('<!doctype html>'))
    const found = await page.evaluate(async () => {
      const { compileWarp } = await import('/dist/warpjet.min.js')
      const { Module } = WebAssembly
      const messageOf = []
      WebAssembly.Module = function (bytes) {
        messageOf.push('forbidden')
        const module = new Module(bytes)
        messageOf[messageOf.length - 1] = 'made'
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
      const [free, later] = [compileWarp(bend), compileWarp(bend)]
      const expected = [bits(free), bits(later)]
      expected.push(bits(free))
      const point = JSON.stringify(free.evaluateAt([1, 2, 3], { uniforms }))
      const before = messageOf.splice(0)

      const policy = document.createElement('meta')
      policy.httpEquiv = 'Content-Security-Policy'
      policy.content = "script-src 'self'"
      document.head.append(policy)
      const results = [bits(later), bits(later), bits(free)]
      const points = [1, 2, 3].map(() => JSON.stringify(later.evaluateAt([1, 2, 3], { uniforms })))
      const many = bits(compileWarp(bend), 40_000).length
      return {
        before,
        after: messageOf,
        same: [...expected, ...results].map((text) => text === expected[0]),
        points: points.map((text) => text === point),
        many,
      }
    })
    await leavePage(page)
    assert.ok(found.before.length > 0 && found.before.every((outcome) => outcome === 'made'))
    assert.deepEqual(found.after, ['forbidden'], 'it is tried once')
    assert.deepEqual(found.same, [true, true, true, true, true, true])
    assert.deepEqual(found.points, [true, true, true])
    assert.ok(found.many > 40_000 * 6)
    assert.deepEqual(messages, [])
  })
})

describe('a page that was opened as a file', () => {
  /** Returns the message of loadWarpModel on such a page. */
  async function problem(context, src, model) {
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
      [ownMesh]: dist('mesh.min.js'),
    })
    for (const src of [`../..${script}`, `${cdn}/npm/warpjet`])
      assert.match(
        await problem(context, src, 'bunny.glb'),
        /^loadWarpModel: .* opened as a file may read no other file, so serve its folder/,
        src,
      )
    assert.equal(await problem(context, `${cdn}/npm/warpjet`, triangle), 'none')
    await context.close()
  })
})
