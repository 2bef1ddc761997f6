// Tests sketches with operators, which the second script translates: they draw the same picture as with methods, and errors name the lines
// of the sketch.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowser, leavePage, openPage } from '../support/browser/browser.js'
import { litPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { drawScenes, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const scripts = ['/dist/p5.warpjet.min.js', '/dist/warpjet.operators.min.js']

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

for (const [version, p5] of p5InThisRun) {
  test(`p5 ${version}: a warp with operators looks like one with methods`, async () => {
    const images = await drawScenes(browser, server, [p5, ...scripts], {
      setup: `
        const far = 0.3
        warps.written = createWarp(({ position, uniforms }) => {
          let x = far * sin(position.y * 4)
          if (position.z < 0) x *= 0.5
          return [x + uniforms.more, constrain(position.x, -0.2, 0.2), 0]
        }, { scope: { far }, uniforms: { more: 0.1 } })
        warps.called = createWarp(({ glsl, position }) => {
          const x = glsl.mult(0.3, position.y().mult(4).sin())
          return glsl.vec3(position.z().lt(0).ifElse(x.mult(0.5), x).add(0.1), position.x().clamp(-0.2, 0.2), 0)
        })`,
      scenes: {
        written: `lights(); noStroke(); warps.written(); fill('coral'); sphere(60)`,
        called: `lights(); noStroke(); warps.called(); fill('coral'); sphere(60)`,
      },
    })
    assert.ok(litPixels(images.called).length > 5000)
    assert.deepEqual(images.written, images.called)
  })

  test(`p5 ${version}: an error names the line of the sketch`, async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5, ...scripts],
      `function setup() {
        createCanvas(100, 100, WEBGL)
        noLoop()
        const hidden = 3
        try {
          createWarp(({ position, glsl }) => {
            const y = position.y * 2
            return glsl.vec3(y.sine(), 0, 0)
          })
        } catch ({ message }) { window.firstMessage = message }
        try { createWarp(({ position }) => position * hidden) } catch ({ message }) { window.secondMessage = message }
        done = true
      }`,
    )
    const [first, second, source] = await page.evaluate(
      '[firstMessage, secondMessage, document.documentElement.outerHTML]',
    )
    await leavePage(page)
    assert.deepEqual(messages, [])
    const lines = source.split('\n')
    const lineOf = (text) => lines.findIndex((line) => line.includes(text)) + 1
    const lineInMessage = (message) => +/, line (\d+)\)$/.exec(message)[1]
    assert.match(first, /^sine: an expression has no such method; did you mean sin\?/)
    assert.equal(
      lineInMessage(first) - lineInMessage(second),
      lineOf('y.sine()') - lineOf('position * hidden'),
    )
    assert.match(
      second,
      /cannot access "hidden" of the enclosing scope; .*\{ scope: \{ hidden \} \}/,
    )
  })
}

for (const [version, p5] of p5InThisRun) {
  test(`p5 ${version}: variables around a function are found in the file of the sketch`, async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5, ...scripts, '/tests/operators/sketches/external.js'],
      '',
    )
    const [shadowed, free, bound] = await page.evaluate('outcomes')
    await leavePage(page)
    assert.deepEqual(messages, [])
    assert.match(
      shadowed,
      /cannot access "height" of the enclosing scope, where it is a local variable, not the global one; add the option \{ scope/,
    )
    assert.equal(free, 'function')
    assert.match(
      bound,
      /cannot access "width" of the enclosing scope, where it is a local variable, not the global one/,
    )
  })

  test(`p5 ${version}: the variables of a module are not globals of the page`, async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5, ...scripts],
      `const amount = 0.3
      const makeWave = (height) => createWarp(({ position }) => position * height)
      const double = (x) => x * 2
      const attempt = (work) => {
        try { work(); return 'done' } catch ({ message }) { return message }
      }
      window.setup = function () {
        createCanvas(60, 60, WEBGL)
        noLoop()
        window.outcomes = [
          attempt(() => createWarp(({ position }) => position * amount)),
          attempt(() => makeWave(0.2)),
          attempt(() => createWarp(({ position }) => [double(position.x), 0, 0])),
          attempt(() => createWarp(({ position }) => position * amount, { scope: { amount } })),
        ]
        window.done = true
      }`,
      'module',
    )
    const [first, second, third, fourth] = await page.evaluate('outcomes')
    await leavePage(page)
    assert.deepEqual(messages, [])
    assert.match(first, /cannot access "amount" of the enclosing scope; .* scope: \{ amount \}/)
    assert.match(
      second,
      /cannot access "height" of the enclosing scope, where it is a local variable, not the global one/,
    )
    assert.deepEqual([third, fourth], ['done', 'done'])
  })

  test(`p5 ${version}: on a page that forbids new Function, functions without operators work, and others throw a message`, async () => {
    const { page, messages } = await openPage(
      browser,
      server.page(`<!doctype html>
<meta http-equiv="Content-Security-Policy" content="script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'">
${[p5, ...scripts].map((src) => `<script src="${src}"></script>`).join('')}
<script>
function setup() {
  createCanvas(60, 60, WEBGL)
  noLoop()
  const factor = 2
  createWarp(({ position }) => {
    let sum
    for (let i = 1; i < 3; i++) sum = sum ? sum.add(position.mult(i * factor)) : position
    return sum
  })
  try { createWarp(({ position }) => position * 2) } catch ({ message }) { window.errorMessage = message }
  window.done = true
}
</script>`),
    )
    await page.waitForFunction(() => window.done)
    const errorMessage = await page.evaluate('errorMessage')
    await leavePage(page)
    assert.deepEqual(
      messages.filter((message) => !/Content Security Policy/.test(message)),
      [],
    )
    assert.match(
      errorMessage,
      /^createWarp: operators are translated in the function's source code, which this page's Content-Security-Policy forbids\. Allow 'unsafe-eval'/,
    )
  })
}
