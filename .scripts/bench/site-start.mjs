// How soon the built site's first page answers, on a Chromium that is slowed four times: a cold load from a local server.
import { chromium } from 'playwright-core'
import { preview } from 'vite'
import { findBrowser } from '../lib/browser.mjs'
import { path } from '../lib/files.mjs'
import { softwareFlags } from '../lib/flags.mjs'
import { median } from '../lib/median.mjs'
import { say } from '../lib/terminal.mjs'

const RUNS = 7
const SLOWDOWN = 4
/** Milliseconds; what one may wait for before the page answers. */
const aim = 1500
const patience = { timeout: 120_000 }

/** In the page, before its scripts: when filter and search begin to listen, and when the warp is drawn; tasks that keep others waiting. */
function watch() {
  const times = (window.times = { busy: 0 })
  const { addEventListener } = EventTarget.prototype
  EventTarget.prototype.addEventListener = function (kind, ...rest) {
    addEventListener.call(this, kind, ...rest)
    if (kind !== 'input') return
    if (this.className === 'filter') times.filter ??= performance.now()
    if (this.id === 'search') times.search ??= performance.now()
  }
  const { drawElements } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.drawElements = function (...given) {
    drawElements.apply(this, given)
    times.warp ??= performance.now()
  }
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries())
      times.busy = Math.max(times.busy, startTime + duration)
  }).observe({ type: 'longtask', buffered: true })
  new PerformanceObserver((list) => {
    for (const { name, startTime } of list.getEntries())
      if (name === 'first-contentful-paint') times.paint = startTime
  }).observe({ type: 'paint', buffered: true })
}

/** Milliseconds from words in a field until they are answered. */
async function answered(page, field, words, answer) {
  return page.evaluate(
    ([field, words, answer]) =>
      new Promise((resolve) => {
        const input = document.querySelector(field)
        input.focus()
        const began = performance.now()
        input.value = words
        input.dispatchEvent(new Event('input', { bubbles: true }))
        const look = () =>
          document.querySelector(answer)?.textContent.trim()
            ? resolve(performance.now() - began)
            : requestAnimationFrame(look)
        look()
      }),
    [field, words, answer],
  )
}

async function load(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } })
  try {
    const page = await context.newPage()
    const session = await context.newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: SLOWDOWN })
    await page.addInitScript(watch)
    await page.goto(url, patience)
    await page.waitForFunction(() => window.times.warp && window.times.paint, null, patience)
    await page.waitForTimeout(1500)
    const times = await page.evaluate(() => window.times)
    const filtered = await answered(page, '#words', 'bunny', '.filter output')
    const found = await answered(page, '#search', 'noise', '#found a')
    return { ...times, filtered, found }
  } finally {
    await context.close()
  }
}

const rows = {
  'first paint': ({ paint }) => paint,
  'the filter listens': ({ filter }) => filter,
  'the search listens': ({ search }) => search,
  'the warp is drawn': ({ warp }) => warp,
  'the last task of more than 50 ms ends': ({ busy }) => busy,
  'the filter has answered, from its first word': ({ filtered }) => filtered,
  'the search has answered, from its first word': ({ found }) => found,
}

/** Prints the medians for the site in `folder`, in milliseconds from the beginning of the load. */
export async function measureSite(folder) {
  const server = await preview({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    preview: { port: 5520 },
    build: { outDir: path(folder) },
  })
  const browser = await chromium.launch({
    executablePath: process.env.WARPJET_CHROMIUM ?? (await findBrowser()),
    args: softwareFlags,
  })
  try {
    const [url] = server.resolvedUrls.local
    const runs = []
    for (let i = 0; i <= RUNS; i++) runs.push(await load(browser, url))
    // The first one starts the browser, too.
    runs.shift()
    say(
      `\nThe first page, ${SLOWDOWN} times slowed, medians of ${RUNS} loads (the most), in milliseconds; ${aim} are aimed at:`,
    )
    for (const [title, of] of Object.entries(rows)) {
      const times = runs.map(of)
      say(
        `${title.padEnd(46)} ${median(times).toFixed().padStart(5)} (${Math.max(...times).toFixed()})`,
      )
    }
  } finally {
    await browser.close()
    await server.close()
  }
}
