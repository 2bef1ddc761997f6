// Sketches with operators, by the second script: the same picture as with methods, and errors at the sketch's own lines.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowser, leavePage } from './support/browser.js'
import { litPixels } from './support/pixels.js'
import { servePages } from './support/server.js'
import { drawScenes, p5InThisRun, runSketch } from './support/sketch.js'

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
  test(`p5 ${version}: a warp with operators draws as one with methods`, async () => {
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
        } catch ({ message }) { window.saidFirst = message }
        try { createWarp(({ position }) => position * hidden) } catch ({ message }) { window.saidSecond = message }
        done = true
      }`,
    )
    const [first, second, source] = await page.evaluate(
      '[saidFirst, saidSecond, document.documentElement.outerHTML]',
    )
    await leavePage(page)
    assert.deepEqual(messages, [])
    const lines = source.split('\n')
    const lineOf = (text) => lines.findIndex((line) => line.includes(text)) + 1
    const told = (message) => +/, line (\d+)\)$/.exec(message)[1]
    assert.match(first, /^sine: an expression has no such method; did you mean sin\?/)
    assert.equal(told(first) - told(second), lineOf('y.sine()') - lineOf('position * hidden'))
    assert.match(second, /cannot see "hidden" of the sketch around it; .*\{ scope: \{ hidden \} \}/)
  })
}
