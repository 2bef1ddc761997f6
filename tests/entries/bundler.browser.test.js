// Tests a project with a bundler: its code imports 'p5' and 'warpjet/p5', is built with Vite, and runs on both versions of p5.
import assert from 'node:assert/strict'
import { mkdirSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowser, leavePage, openPage } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const project = '.build/bundler'

const sketch = `
import p5 from 'p5'
import 'warpjet/p5'
import { compileWarp } from 'warpjet'
import { chain, twist } from 'warpjet/deformers'

// p5's check of variable names mistakes variables of a bundle for those of the sketch.
p5.disableFriendlyErrors = true

new p5((p) => {
  let distort
  p.setup = () => {
    p.createCanvas(60, 60, p.WEBGL)
    const sine = ({ glsl, position }) => glsl.vec3(position.y().sin().mult(0.5), 0, 0)
    distort = p.createWarp(chain(sine, twist({ length: 1 })))
  }
  p.draw = () => {
    p.background(255, 0, 0)
    distort()
    p.plane(60, 60, 10, 10)
    document.title = compileWarp(({ position }) => position).code ? 'drawn' : ''
    p.noLoop()
  }
})
`

let browser, pages
before(async () => {
  browser = await launchBrowser()
  pages = await servePages()
})
after(async () => {
  await browser.close()
  await pages.close()
})

for (const version of ['p5', 'p5-v1']) {
  test(`a Vite bundle draws a warp on ${version}`, async () => {
    mkdirSync(`${root}${project}`, { recursive: true })
    writeFileSync(`${root}${project}/${version}.js`, sketch)
    await build({
      configFile: false,
      logLevel: 'error',
      root: `${root}${project}`,
      resolve: version === 'p5' ? {} : { alias: { p5: version } },
      build: {
        outDir: `dist/${version}`,
        minify: false,
        rolldownOptions: {
          input: `${root}${project}/${version}.js`,
          output: { entryFileNames: 'sketch.js' },
        },
      },
    })
    const html = `<!doctype html><body><script type="module" src="/${project}/dist/${version}/sketch.js"></script>`
    const { page, messages } = await openPage(browser, pages.page(html))
    await page.waitForFunction(() => document.title === 'drawn')
    assert.deepEqual(messages, [])
    await leavePage(page)
  })
}
