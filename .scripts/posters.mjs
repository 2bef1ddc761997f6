// npm run posters: draws examples as web/posters/*.webp, which the gallery shows before any script runs. Names after `--` draw
// only those. What they show is a moment of the sketch by its own clock, so that a slow machine draws the same picture.
import { mkdirSync, writeFileSync } from 'node:fs'
import { chromium } from 'playwright-core'
import { createServer } from 'vite'
import { sections } from '../web/catalogue.js'
import { build } from './build.mjs'
import { findBrowser } from './lib/browser.mjs'
import { path } from './lib/files.mjs'
import { softwareFlags } from './lib/flags.mjs'
import { Stop, good, main } from './lib/terminal.mjs'

const [width, height] = [480, 360]
/** So that the whole grid weighs less than a photograph. */
const mostBytes = 20_000
/** Milliseconds of the sketch, where it shows what it is about; a second and a half unless named. */
const moments = {
  'deformer-genie': 3600,
  'deformer-melt': 500,
  'deformer-spherify': 200,
  'deformer-taper': 4700,
  'deformer-twist': 3000,
  genie: 250,
}
const patience = { timeout: 240_000 }

/** In the page: after the sketch's first frame, before which it may load a model, it is `moment`, and then each takes a sixtieth of a second. */
function slowClock(moment) {
  let now = 0
  performance.now = () => (now += 0.01)
  const { requestAnimationFrame } = window
  window.requestAnimationFrame = (draw) =>
    requestAnimationFrame(() => {
      const hasBegun = (window.frameCount ?? 1) >= 1
      now += hasBegun && now < moment ? moment : 17
      draw(now)
    })
  // What was drawn stays until it was looked at.
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
  }
}

/** The picture as WebP, as good as fits. */
async function packed({ png, width, height, mostBytes }) {
  const image = new Image()
  image.src = `data:image/png;base64,${png}`
  await image.decode()
  const canvas = Object.assign(document.createElement('canvas'), { width, height })
  const context = canvas.getContext('2d')
  context.imageSmoothingQuality = 'high'
  context.drawImage(image, 0, 0, width, height)
  for (let quality = 0.86; quality > 0.1; quality -= 0.06) {
    const address = canvas.toDataURL('image/webp', quality)
    if (address.length * 0.75 < mostBytes) return address.split(',')[1]
  }
}

async function poster(browser, url, name) {
  const page = await browser.newPage({
    viewport: name.startsWith('three-') ? { width, height } : { width: 640, height: 480 },
  })
  try {
    await page.addInitScript(slowClock, moments[name] ?? 1500)
    await page.goto(`${url}examples/${name}/gallery.html`, patience)
    await page.waitForFunction(() => window.frameCount >= 3, null, patience)
    // A picture of the sketch, without its panels.
    await page.addStyleTag({
      content: '.lil-gui, body > div[style*="z-index"] { display: none !important }',
    })
    const png = await page.screenshot({ timeout: 120_000 })
    const size = { width, height, mostBytes }
    const bytes = await page.evaluate(packed, { png: png.toString('base64'), ...size })
    writeFileSync(path(`web/posters/${name}.webp`), Buffer.from(bytes, 'base64'))
    good(`web/posters/${name}.webp`)
  } finally {
    await page.close()
  }
}

/** The first page's own warp as it stands still, on nothing. */
async function hero(browser, url) {
  const page = await browser.newPage({
    viewport: { width: 1280, height: 900 },
    reducedMotion: 'reduce',
  })
  try {
    await page.addInitScript(slowClock, 0)
    await page.goto(url, patience)
    await page.waitForSelector('.hero canvas', patience)
    await page.waitForTimeout(500)
    const png = await page.evaluate(
      () => document.querySelector('.hero canvas').toDataURL('image/png').split(',')[1],
    )
    const bytes = await page.evaluate(packed, { png, width: 640, height: 640, mostBytes: 30_000 })
    writeFileSync(path('web/site/hero.webp'), Buffer.from(bytes, 'base64'))
    good('web/site/hero.webp')
  } finally {
    await page.close()
  }
}

await main(async () => {
  const known = ['hero', ...sections.flatMap(({ examples }) => examples.map(({ name }) => name))]
  const wanted = process.argv.slice(2)
  const unknown = wanted.find((name) => !known.includes(name))
  if (unknown) throw new Stop(`There is no example ${unknown}.`)
  await build()
  mkdirSync(path('web/posters'), { recursive: true })
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    server: { port: 5510, watch: null },
  })
  await server.listen()
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: softwareFlags,
  })
  const [url] = server.resolvedUrls.local
  try {
    for (const name of wanted.length ? wanted : known)
      await (name === 'hero' ? hero(browser, url) : poster(browser, url, name))
  } finally {
    await browser.close()
    await server.close()
  }
})
