// Each example of the gallery draws the same picture with `await createCanvas(…, WEBGPU)` as in WEBGL, without any other change.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { sections } from '../../web/catalogue.js'
import { convert } from '../../web/playground/convert.js'
import { path } from '../support/browser/bench.js'
import { launchBrowserWithWebGPU, openPage } from '../support/browser/browser.js'
import { addCookie, coarseShapes, cookie, replaceResponses } from '../support/browser/examples.js'
import { beyondEdges, litPixels, readPixels, readWebGPUPixels } from '../support/browser/pixels.js'
import { serveSources } from '../support/browser/site.js'
import { encodeImage } from '../support/png.js'

const screenshots = path('.build/screenshots/webgpu')

const examples = sections
  .flatMap((section) => section.examples.map(({ name }) => name))
  .filter((name) => !name.startsWith('three-'))

/** Hosts of the playground. Each has one page, so that it compiles p5 only once for all examples. */
const hosts = ['p5-2', 'p5-webgpu']

let browser, server, url
const pages = {}
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowserWithWebGPU()
  server = await serveSources(5260, [replaceResponses(adaptToHost)])
  url = server.resolvedUrls.local[0]
  for (const host of hosts) pages[host] = await openPageFor(host)
})
after(async () => {
  await browser.close()
  await server.close()
})

async function openPageFor(host) {
  const context = await browser.newContext({ viewport: { width: 640, height: 480 } })
  await addCookie(context, url, 'host', host)
  return openPage(context, `${url}recorder.js`)
}

/** Converts a sketch for the host that the request's cookie names, and appends p5's WebGPU renderer to p5 if the host is on WebGPU. */
function adaptToHost(request, path, content) {
  const host = cookie(request, 'host')
  if (/^\/examples\/[\w-]+\/sketch\.js$/.test(path))
    return `${convert(String(content), host)}${setUpStill}{${coarseShapes}}`
  const isP5 = host === 'p5-webgpu' && path.endsWith('/p5.min.js')
  return isP5 ? `${content}\n${webgpu}` : content
}

const webgpu = readFileSync(path('node_modules/p5/lib/p5.webgpu.min.js'), 'utf8')

/** Code that fixes the time, seeds random numbers, draws one frame, and reduces pixels. */
const setUpStill = `
{
  let seed = 1
  Math.random = () => (seed = (seed * 16807) % 2147483647) / 2147483647
  p5.prototype.millis = () => 1700
  // Removes further directional lights and highlights: on WEBGPU, p5 itself uses only the first light, and has different highlights, as
  // webgpu.browser.test.js shows without a warp.
  const { directionalLight } = p5.prototype
  let lit = -1
  p5.prototype.directionalLight = function (...light) {
    if (lit < this.frameCount) directionalLight.apply(this, light)
    lit = this.frameCount
    return this
  }
  // Removes the edges of shapes. Warps do not draw them, and p5 takes seconds to compute those of a model.
  p5.Geometry.prototype._edgesToVertices = function () { return this }
  p5.prototype.specularMaterial = p5.prototype.shininess = function () { return this }
  const original = { setup, draw }
  window.setup = async () => {
    p5.instance._glAttributes = p5.instance._webgpuAttributes = { antialias: false }
    await original.setup()
    pixelDensity(0.5)
    noLoop()
  }
  // Ignores the first frame, which p5 draws by itself.
  window.draw = () => (window.draw = original.draw)
}`

async function drawExample(name, host) {
  const { page, messages } = pages[host]
  await page.goto(`${url}examples/${name}/gallery.html`)
  await page.waitForFunction(() => window.frameCount >= 1, null, { timeout: 120_000 })
  // Fonts create canvases, too: moves that of the sketch to the front.
  await page.evaluate(() => document.body.prepend(document.getElementById('defaultCanvas0')))
  const draw = 'redraw()'
  const image =
    host === 'p5-webgpu'
      ? await readWebGPUPixels(page, draw)
      : (await page.evaluate(draw), await readPixels(page))
  writeFileSync(`${screenshots}/${name}.${host}.png`, encodeImage(image))
  assert.deepEqual(messages.splice(0), [])
  return image
}

for (const name of examples)
  test(name, async () => {
    const [webgl, webgpu] = [await drawExample(name, hosts[0]), await drawExample(name, hosts[1])]
    const lit = litPixels(webgl).length
    assert.ok(lit > 1000, `${lit} pixels are lit`)
    const beyond = beyondEdges(webgpu, webgl, 12)
    assert.ok(beyond <= 0.01 * lit, `${beyond} of ${lit} pixels differ`)
  })
