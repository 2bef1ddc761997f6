// Runs p5 sketches as pages, frame by frame.
import assert from 'node:assert/strict'
import { after } from 'node:test'
import { isRun } from '../../../.scripts/lib/tiers.mjs'
import { launchBrowser, launchBrowserWithWebGPU, leavePage, openPage } from './browser.js'
import { readPixels, readWebGPUPixels } from './pixels.js'
import { servePages } from './server.js'

/** Maps the p5 versions that the addon supports → their full files, which include p5's friendly errors. */
export const p5Versions = {
  '2.x': '/node_modules/p5/lib/p5.js',
  1.11: '/node_modules/p5-v1/lib/p5.js',
}

/** p5 2.x's WebGPU renderer, to be loaded after p5 itself. */
export const p5WebGPU = '/node_modules/p5/lib/p5.webgpu.js'

/** The versions that this run tests: [version, file]. */
export const p5InThisRun = Object.entries(p5Versions).filter(
  ([version]) => version !== '1.11' || isRun('p5 1.11'),
)

/** The hosts that this run tests: [version, renderer, scripts]. `openHosts` opens their browsers. */
export const p5HostsInThisRun = [
  ...p5InThisRun.map(([version, p5]) => [version, 'WEBGL', [p5]]),
  ...(isRun('p5 on WebGPU') ? [['2.x', 'WEBGPU', [p5Versions['2.x'], p5WebGPU]]] : []),
]

/**
 * Opens a server of pages and the browsers that `hosts` need, until the tests of the calling file have finished. Returns { server, browsers };
 * `browsers` maps a renderer to its browser.
 */
export async function openHosts(hosts) {
  const server = await servePages()
  const launch = { WEBGL: launchBrowser, WEBGPU: launchBrowserWithWebGPU }
  const renderers = [...new Set(hosts.map(([, renderer]) => renderer))]
  const launched = renderers.map(async (renderer) => [renderer, await launch[renderer]()])
  const browsers = Object.fromEntries(await Promise.all(launched))
  after(async () => {
    for (const browser of Object.values(browsers)) await browser.close()
    await server.close()
  })
  return { browsers, server }
}

/** Opens a server of pages and the browser of one renderer, until the tests of the calling file have finished. */
export async function openHost(renderer = 'WEBGL') {
  const { browsers, server } = await openHosts([['2.x', renderer]])
  return { browser: browsers[renderer], server }
}

/** Opens a page with `scripts` (addresses) and then `code`, and waits until `code` sets `window.done` or fails. Returns { page, messages }. */
export async function runSketch(browser, server, scripts, code, type = '') {
  const html = `<!doctype html>
<meta charset="utf-8">
<body style="margin: 0">
${scripts.map((src) => `<script src="${src}"></script>`).join('\n')}
<script ${type && `type="${type}"`}>
for (const event of ['error', 'unhandledrejection']) addEventListener(event, () => (window.done = true))
${code}
</script>
</body>`
  const opened = await openPage(browser, server.page(html))
  await opened.page.waitForFunction(() => window.done)
  return opened
}

/**
 * Runs a global mode sketch and draws a frame for each of `scenes`, which maps names to p5 code → maps the names to images. `setup` runs
 * after createCanvas, and may store values in the object `warps`; on p5 2.x it may await. push() and pop() surround each scene unless
 * `isPushed` is false. The mouse is at 30, 10. `renderer` is 'WEBGL' or 'WEBGPU'. Fails if the page prints anything.
 */
export async function drawScenes(
  browser,
  server,
  scripts,
  { size = 200, setup = '', scenes, isPushed = true, renderer = 'WEBGL' },
) {
  const isAsync = renderer === 'WEBGPU' || /\bawait\b/.test(setup)
  const functions = Object.entries(scenes).map(
    ([name, code]) => `${JSON.stringify(name)}: () => { ${code} }`,
  )
  const { page, messages } = await runSketch(
    browser,
    server,
    scripts,
    `const warps = {}
let scene = () => (window.done = true)
const scenes = { ${functions.join(',\n')} }
${isAsync ? 'async ' : ''}function setup() {
  pixelDensity(1)
  ${renderer === 'WEBGL' ? '' : 'await '}createCanvas(${size}, ${size}, ${renderer})
  noLoop()
  ${setup}
}
function draw() {
  background(0)
  ${isPushed ? 'push()' : ''}
  scene()
  ${isPushed ? 'pop()' : ''}
}`,
  )
  await page.mouse.move(30, 10)
  const images = {}
  for (const name of Object.keys(scenes)) {
    await page.evaluate(`scene = scenes[${JSON.stringify(name)}]`)
    if (renderer === 'WEBGPU') images[name] = await readWebGPUPixels(page, 'redraw()')
    else {
      await page.evaluate('redraw()')
      images[name] = await readPixels(page)
    }
  }
  await leavePage(page)
  assert.deepEqual(messages, [])
  return images
}
