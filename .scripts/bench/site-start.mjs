// How soon the built site's first page can be used, on a Chromium that is slowed four times: a cold load from a local server.
import { loadavg } from 'node:os'
import { setTimeout } from 'node:timers/promises'
import { chromium } from 'playwright-core'
import { preview } from 'vite'
import { findBrowser } from '../lib/browser.mjs'
import { path } from '../lib/files.mjs'
import { softwareFlags } from '../lib/flags.mjs'
import { median } from '../lib/median.mjs'
import { Stop, good, say } from '../lib/terminal.mjs'
import { answered, watch } from './site-watch.mjs'

const RUNS = 7
const SLOWDOWN = 4
/** Milliseconds: until the page is interactive, and until a key that is pressed just then is answered, which INP calls good. */
const aims = { interactive: 1500, key: 200 }
/** Milliseconds without a long task that end the start of a page, as in Lighthouse's time to interactive; and when we stop waiting. */
const [quiet, longest] = [5000, 20_000]
const patience = { timeout: 120_000 }

/** Of what the page has seen: when it shows something and listens, and from when on no long task comes for a while. */
function interactiveOf({ paint, filter, search, tasks }) {
  let end = Math.max(paint, filter, search)
  for (const task of tasks) {
    if (task.start > end + quiet) break
    end = Math.max(end, task.end)
  }
  return end
}

/** A task that a key led to keeps nobody waiting but by what the key's own row says. */
const ofPage = ({ tasks, pressed, key }) =>
  tasks.filter(({ start }) => start < pressed || start > pressed + key)

async function load(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } })
  try {
    const page = await context.newPage()
    const session = await context.newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: SLOWDOWN })
    await page.addInitScript(watch)
    await page.goto(url, { ...patience, waitUntil: 'commit' })
    const began = await page.evaluate(() => performance.timeOrigin)
    const until = (moment) => setTimeout(Math.max(0, began + moment - Date.now()))
    await until(aims.interactive)
    // The page has the focus in the filter's field; nothing is asked of it first, since it would have to be free for that.
    await page.keyboard.press('b')
    await page.waitForFunction(() => window.seen.key && window.seen.warp, null, patience)
    const look = () => page.evaluate(() => window.seen)
    let seen = await look()
    for (let end = 0; end < longest && Date.now() < began + end + quiet; seen = await look()) {
      end = interactiveOf({ ...seen, tasks: ofPage(seen) })
      await until(Math.min(end + quiet, longest) + 50)
    }
    const words = await page.locator('.filter output').textContent()
    if (!/\d of \d/.test(words)) throw new Stop('The first page does not answer its filter.')
    const tasks = ofPage(seen)
    const found = await page.evaluate(answered, ['#search', 'noise', '#found a'])
    return { ...seen, tasks, found, interactive: interactiveOf({ ...seen, tasks }) }
  } finally {
    await context.close()
  }
}

const rows = {
  'first paint': 'paint',
  'the filter listens': 'filter',
  'the search listens': 'search',
  'interactive: it listens, and long tasks are over': 'interactive',
  'the warp is drawn for the first time': 'warp',
  'a key, pressed at 1500, is answered after': 'key',
  'the search has answered, from its first word, after': 'found',
}

/** What of which run still kept others waiting, and whose it was. */
const missed = (runs) =>
  runs.flatMap(({ tasks, interactive }, run) =>
    tasks
      .filter(({ end }) => end > aims.interactive && end <= interactive)
      .map(
        ({ start, end, whose }) =>
          `load ${run + 1}: from ${start.toFixed()} for ${(end - start).toFixed()} ms, ${whose}`,
      ),
  )

/** Prints, in milliseconds, what the site in `folder` takes from the beginning of a load; throws where an aim is missed. */
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
      `\nThe first page, ${SLOWDOWN} times slowed, without a GPU, in milliseconds: of ${RUNS} loads the median, the best and the worst.`,
    )
    say(`The machine's load was ${loadavg()[0].toFixed(1)}; what else runs on it slows the page.`)
    for (const [title, row] of Object.entries(rows)) {
      const times = runs.map((run) => run[row])
      const [middle, best, worst] = [median(times), Math.min(...times), Math.max(...times)]
      const aim = aims[row] ? `  ${middle <= aims[row] ? '✓' : '✗'} at most ${aims[row]}` : ''
      const figures = [middle, best, worst].map((time) => time.toFixed().padStart(6)).join('')
      say(`${title.padEnd(52)}${figures}${aim}`)
    }
    for (const line of missed(runs)) say(line)
    const over = Object.keys(aims).filter((row) => median(runs.map((run) => run[row])) > aims[row])
    if (over.length) throw new Stop(`The first page misses its aim: ${over.join(', ')}.`)
    good('The first page is interactive in time.')
  } finally {
    await browser.close()
    await server.close()
  }
}
