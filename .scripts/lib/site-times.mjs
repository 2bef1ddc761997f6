// Measures how soon the first page of the built site is interactive, loaded with an empty cache.
import { setTimeout } from 'node:timers/promises'
import { chromium } from 'playwright-core'
import { preview } from 'vite'
import { softwareFlags } from './flags.mjs'
import { median } from './median.mjs'
import { Stop } from './terminal.mjs'

const runs = 7
/** The factor by which the processor is slowed down, to that of a slow phone. */
const slowdown = 4
/** Max milliseconds until the page is interactive, and until a key pressed at that moment is answered (a good INP). */
const aims = { interactive: 1500, key: 200 }
/** The start ends before the first 5 s without a long task, as in Lighthouse's time to interactive. */
const quietTime = 5000

/** Runs in the page, before its scripts: collects paint, long tasks (over 50 ms) and the time that a key takes. */
function observePage() {
  window.seen = { paint: [], longtask: [], event: [] }
  for (const [type, entries] of Object.entries(window.seen))
    new PerformanceObserver((list) => entries.push(...list.getEntries())).observe({
      type,
      buffered: true,
      durationThreshold: 16,
    })
  document.addEventListener('DOMContentLoaded', () =>
    document.querySelector('#words').focus({ preventScroll: true }),
  )
}

async function load(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } })
  const page = await context.newPage()
  const session = await context.newCDPSession(page)
  await session.send('Emulation.setCPUThrottlingRate', { rate: slowdown })
  await page.addInitScript(observePage)
  await page.goto(url, { timeout: 120_000, waitUntil: 'commit' })
  await setTimeout(aims.interactive)
  await page.keyboard.press('b')
  await setTimeout(2 * quietTime)
  const seen = await page.evaluate(() => JSON.parse(JSON.stringify(window.seen)))
  const answer = await page.locator('.filter output').textContent()
  if (!/\d of \d/.test(answer)) throw new Stop('The first page does not answer its filter.')
  await context.close()
  const { startTime: paint } = seen.paint.find(({ name }) => name === 'first-contentful-paint')
  let interactive = paint
  for (const { startTime, duration } of seen.longtask)
    if (startTime < interactive + quietTime)
      interactive = Math.max(interactive, startTime + duration)
  return { paint, interactive, key: Math.max(0, ...seen.event.map(({ duration }) => duration)) }
}

/** Prints the times in milliseconds; throws if a median misses its aim. */
export async function checkTimes(config, executablePath) {
  const server = await preview({ ...config, preview: { port: 5520 } })
  const browser = await chromium.launch({ executablePath, args: softwareFlags })
  const times = []
  try {
    for (let i = 0; i <= runs; i++) times.push(await load(browser, server.resolvedUrls.local[0]))
  } finally {
    await browser.close()
    await server.close()
  }
  // The first run also starts the browser.
  times.shift()
  const medianOf = (name) => Math.round(median(times.map((each) => each[name])))
  const medians = Object.fromEntries(Object.keys(times[0]).map((name) => [name, medianOf(name)]))
  console.table({ median: medians, max: aims })
  const over = Object.keys(aims).filter((name) => medians[name] > aims[name])
  if (over.length) throw new Stop(`The first page misses its aim: ${over.join(', ')}.`)
}
