// A headless Chromium that draws WebGL without a GPU, and pages that record their console messages.
import { chromium } from 'playwright-core'
import { findBrowser } from '../../../.scripts/lib/find-browser.mjs'
import { softwareFlags, testFlags } from '../../../.scripts/lib/flags.mjs'
import { borrow } from './borrow.js'

/**
 * Returns a browser: one that `borrow` returns or, with `moreFlags`, which are added to the command line, a new one. Starts the Chromium
 * that WARPJET_CHROMIUM names, or that is found on this machine.
 */
export const launchBrowser = async (moreFlags = []) =>
  (moreFlags.length ? null : await borrow()) ?? launch([...testFlags, ...moreFlags])

const launch = async (args) =>
  chromium.launch({ executablePath: process.env.WARPJET_CHROMIUM ?? (await findBrowser()), args })

/** Starts a browser whose WebGPU can draw on canvases, which fails with the default compositing. */
export const launchBrowserWithWebGPU = () =>
  launch([...softwareFlags, ...webgpuFlags, '--use-vulkan=swiftshader'])

/** Flags for WebGPU without a GPU, on pages of `servePages`. */
export const webgpuFlags = [
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-features=Vulkan',
]

/** Tests for the driver's warning that a page reads its canvas, as every page does that is composited on the CPU. */
const isDriverWarning = (text) => /GL Driver Message .*: GPU stall due to ReadPixels/.test(text)

/** Maps a page to its console messages, and to the context that opened it. */
const opened = new WeakMap()
/** Maps a context to its page that is free for reuse. */
const unused = new WeakMap()

/** Opens `url`. Returns { page, messages }; `messages` collects console lines and uncaught errors, in order. */
export async function openPage(browser, url) {
  const page = unused.get(browser) ?? (await newPage(browser))
  unused.delete(browser)
  const messages = []
  opened.set(page, { browser, messages })
  // A server may first generate a model, while other tests keep the machine busy.
  await page.goto(url, { timeout: 180_000 })
  return { page, messages }
}

async function newPage(browser) {
  const page = await browser.newPage()
  const record = (text) => isDriverWarning(text) || opened.get(page).messages.push(text)
  page.on('console', (message) => record(message.text()))
  page.on('pageerror', (error) => record(`uncaught: ${error.message}`))
  return page
}

/**
 * Keeps a page of `servePages` for the next `openPage`. A new page, or one that was at about:blank in between, would run in a new process,
 * which compiles all of p5 again.
 */
export async function leavePage(page) {
  const { browser } = opened.get(page)
  await page.mouse.move(0, 0)
  await page.goto(new URL('/', page.url()).href)
  unused.set(browser, page)
}

/**
 * Returns the content of the file that the page has saved. Streams it, since a browser shared by several test files has no download path.
 */
export async function bytesOf(download) {
  const chunks = []
  for await (const chunk of await download.createReadStream()) chunks.push(chunk)
  return Buffer.concat(chunks)
}
