// npm run pictures [-- NAME …]: draws all pictures of the site, or only those named:
// - a poster of each example, web/posters/*.webp, which the gallery shows before any script runs;
// - the warp of the first page (`hero`);
// - the pictures of web/docs/composition.md (`composition.png`) and web/docs/detail.md (`detail.webp`).
// A simulated clock decides which moment of a sketch is drawn, so that a slow machine draws the same picture.
import { writeFileSync } from 'node:fs'
import { chromium } from 'playwright-core'
import { createServer } from 'vite'
import { sections } from '../web/catalogue.js'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { findBrowser } from './lib/find-browser.mjs'
import { softwareFlags } from './lib/flags.mjs'
import { Stop, good, main } from './lib/terminal.mjs'
import { drawDetail } from './pictures/detail.mjs'

const [width, height] = [480, 360]
/** Small enough that the whole gallery loads fewer bytes than one photograph. */
const maxBytes = 20_000
/** Maps a sketch → the time in milliseconds at which it is most characteristic. Default: 1500. */
const moments = {
  'deformer-genie': 3600,
  'deformer-melt': 500,
  'deformer-spherify': 200,
  'deformer-taper': 4700,
  'deformer-twist': 3000,
  genie: 250,
}
const waitOptions = { timeout: 240_000 }

/**
 * Runs in the page: replaces its clock. The new one advances by 17 ms per frame; only the frame after the sketch's first one advances it by
 * `moment`. Before its first frame, the sketch may load a model for any time.
 */
function simulateClock(moment) {
  let now = 0
  performance.now = () => (now += 0.01)
  const { requestAnimationFrame } = window
  window.requestAnimationFrame = (draw) =>
    requestAnimationFrame(() => {
      const hasBegun = (window.frameCount ?? 1) >= 1
      now += hasBegun && now < moment ? moment : 17
      draw(now)
    })
  // Keeps the drawing until the screenshot.
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
  }
}

/** Runs in the page: returns the picture as WebP in base64, in the best quality that fits `maxBytes`. */
async function packPicture({ png, width, height, maxBytes }) {
  const image = new Image()
  image.src = `data:image/png;base64,${png}`
  await image.decode()
  const canvas = Object.assign(document.createElement('canvas'), { width, height })
  const context = canvas.getContext('2d')
  context.imageSmoothingQuality = 'high'
  context.drawImage(image, 0, 0, width, height)
  for (let quality = 0.86; quality > 0.1; quality -= 0.06) {
    const dataUrl = canvas.toDataURL('image/webp', quality)
    // Base64 has 4 characters per 3 bytes.
    if (dataUrl.length * 0.75 < maxBytes) return dataUrl.split(',')[1]
  }
}

const pack = async (page, png, size) =>
  Buffer.from(await page.evaluate(packPicture, { png, ...size }), 'base64')

async function drawPoster(page, url, name) {
  await page.addInitScript(simulateClock, moments[name] ?? 1500)
  await page.goto(`${url}examples/${name}/gallery.html`, waitOptions)
  await page.waitForFunction(() => window.frameCount >= 3, null, waitOptions)
  // Hides the panels of the sketch.
  await page.addStyleTag({
    content: '.lil-gui, body > div[style*="z-index"] { display: none !important }',
  })
  const png = await page.screenshot({ timeout: 120_000 })
  return pack(page, png.toString('base64'), { width, height, maxBytes })
}

/** Draws the first page's own warp at rest, on a transparent background. */
async function drawHero(page, url) {
  await page.addInitScript(simulateClock, 0)
  await page.goto(url, waitOptions)
  await page.waitForSelector('.hero canvas', waitOptions)
  await page.waitForTimeout(500)
  const png = await page.evaluate(
    () => document.querySelector('.hero canvas').toDataURL('image/png').split(',')[1],
  )
  return pack(page, png, { width: 640, height: 640, maxBytes: 30_000 })
}

/** Draws examples/composition at the time 0, at which its warps swing out furthest. */
async function drawComposition(page, url) {
  await page.goto(`${url}examples/composition/index.html`, waitOptions)
  await page.waitForFunction(() => window.frameCount >= 1, null, waitOptions)
  await page.evaluate(async () => {
    window.noLoop()
    window.p5.instance.millis = () => 0
    await window.redraw()
  })
  return page.screenshot()
}

const sketchSize = { width: 640, height: 480 }

/** Maps a name → the file, the options of the page, and the function that draws the picture on this page. */
const pictures = {
  hero: {
    file: 'web/site/hero.webp',
    options: { viewport: { width: 1280, height: 900 }, reducedMotion: 'reduce' },
    draw: drawHero,
  },
  'composition.png': {
    file: 'web/docs/composition.png',
    options: { viewport: sketchSize, deviceScaleFactor: 1.25 },
    draw: drawComposition,
  },
  'detail.webp': { file: 'web/docs/detail.webp', draw: drawDetail },
}
for (const { name } of sections.flatMap(({ examples }) => examples))
  pictures[name] = {
    file: `web/posters/${name}.webp`,
    options: { viewport: name.startsWith('three-') ? { width, height } : sketchSize },
    draw: drawPoster,
  }

await main(async () => {
  const wanted = process.argv.slice(2)
  const unknown = wanted.find((name) => !(name in pictures))
  if (unknown)
    throw new Stop(`Expected one of ${Object.keys(pictures).join(', ')}, got ${unknown}.`)
  await build()
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    server: { port: 5510, watch: null },
  })
  await server.listen()
  const executablePath = await findBrowser()
  const browser = await chromium.launch({ executablePath, args: softwareFlags })
  try {
    for (const name of wanted.length ? wanted : Object.keys(pictures)) {
      const { file, options, draw } = pictures[name]
      const page = await browser.newPage(options)
      writeFileSync(path(file), await draw(page, server.resolvedUrls.local[0], name))
      await page.close()
      good(file)
    }
  } finally {
    await browser.close()
    await server.close()
  }
})
