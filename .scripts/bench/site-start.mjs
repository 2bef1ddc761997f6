// Measures how soon the first page of the built site is interactive, loaded with an empty cache in a Chromium slowed four times.
import { setTimeout } from 'node:timers/promises'
import { chromium } from 'playwright-core'
import { preview } from 'vite'
import { path } from '../lib/files.mjs'
import { softwareFlags } from '../lib/flags.mjs'
import { median } from '../lib/median.mjs'
import { Stop, good } from '../lib/terminal.mjs'

const RUNS = 7
const SLOWDOWN = 4
/** Max milliseconds until the page is interactive, and until a key pressed at that moment is answered (a good INP). */
const aims = { interactive: 1500, key: 200 }
/** The start ends before the first 5 s without a long task, as in Lighthouse's time to interactive. */
const quiet = 5000

/** Runs in the page, before its scripts: collects paint, long tasks (over 50 ms) and the time that a key takes. */
function observePage() {
  const seen = (window.seen = { paint: 0, tasks: [], key: 0 })
  const observe = (type, note, options) =>
    new PerformanceObserver((list) => list.getEntries().forEach(note)).observe({
      type,
      buffered: true,
      ...options,
    })
  observe('paint', ({ name, startTime }) => {
    if (name === 'first-contentful-paint') seen.paint = startTime
  })
  observe('longtask', ({ startTime, duration }) =>
    seen.tasks.push({ start: startTime, end: startTime + duration }),
  )
  observe('event', ({ duration }) => (seen.key = Math.max(seen.key, duration)), {
    durationThreshold: 16,
  })
  document.addEventListener('DOMContentLoaded', () =>
    document.querySelector('#words').focus({ preventScroll: true }),
  )
}

async function load(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } })
  try {
    const page = await context.newPage()
    const session = await context.newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: SLOWDOWN })
    await page.addInitScript(observePage)
    await page.goto(url, { timeout: 120_000, waitUntil: 'commit' })
    await setTimeout(aims.interactive)
    await page.keyboard.press('b')
    await setTimeout(2 * quiet)
    const { paint, tasks, key } = await page.evaluate(() => window.seen)
    const answer = await page.locator('.filter output').textContent()
    if (!/\d of \d/.test(answer)) throw new Stop('The first page does not answer its filter.')
    let interactive = paint
    for (const { start, end } of tasks)
      if (start < interactive + quiet) interactive = Math.max(interactive, end)
    return { 'first paint': paint, interactive, key }
  } finally {
    await context.close()
  }
}

/** Prints the times in milliseconds; throws if a median misses its aim. */
export async function measureSite(folder) {
  const server = await preview({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    preview: { port: 5520 },
    build: { outDir: path(folder) },
  })
  const executablePath = process.env.WARPJET_CHROMIUM
  const browser = await chromium.launch({ executablePath, args: softwareFlags })
  try {
    const runs = []
    for (let i = 0; i <= RUNS; i++) runs.push(await load(browser, server.resolvedUrls.local[0]))
    // The first run also starts the browser.
    runs.shift()
    const medians = Object.fromEntries(
      Object.keys(runs[0]).map((name) => [name, Math.round(median(runs.map((run) => run[name])))]),
    )
    console.table({ median: medians, 'at most': aims })
    const over = Object.keys(aims).filter((name) => medians[name] > aims[name])
    if (over.length) throw new Stop(`The first page misses its aim: ${over.join(', ')}.`)
    good('The first page is interactive in time.')
  } finally {
    await browser.close()
    await server.close()
  }
}
