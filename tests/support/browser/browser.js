// A headless Chromium that draws WebGL without a GPU, and pages that remember whatever they printed.
import { chromium } from 'playwright-core'
import { findBrowser } from '../../../.scripts/lib/browser.mjs'
import { softwareFlags, testFlags } from '../../../.scripts/lib/flags.mjs'
import { borrow } from './borrow.js'

/** The Chromium that WARPJET_CHROMIUM names, or the one that is found. `moreFlags` are added to its command line. */
export const launchBrowser = async (moreFlags = []) =>
  (moreFlags.length ? null : await borrow()) ?? launch([...testFlags, ...moreFlags])

const launch = async (args) =>
  chromium.launch({ executablePath: process.env.WARPJET_CHROMIUM ?? (await findBrowser()), args })

/** One whose WebGPU draws on canvases: that is lost where pages are put together otherwise. */
export const launchBrowserWithWebGPU = () =>
  launch([...softwareFlags, ...webgpuFlags, '--use-vulkan=swiftshader'])

/** For WebGPU without a GPU, on pages of `servePages`. */
export const webgpuFlags = [
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-features=Vulkan',
]

/** What the driver says of a page that is put together on the CPU, and so reads its canvas. */
const isOfDriver = (text) => /GL Driver Message .*: GPU stall due to ReadPixels/.test(text)

/** Of each page what it has printed, and who opened it. */
const opened = new WeakMap()
/** Pages that were left, by who opened them. */
const left = new WeakMap()

/** Opens `url` → { page, messages }; `messages` collects console lines and uncaught errors, in order. */
export async function openPage(browser, url) {
  const page = left.get(browser) ?? (await newPage(browser))
  left.delete(browser)
  const messages = []
  opened.set(page, { browser, messages })
  // A server may make a model first, while other tests keep the machine busy.
  await page.goto(url, { timeout: 180_000 })
  return { page, messages }
}

async function newPage(browser) {
  const page = await browser.newPage()
  const print = (text) => isOfDriver(text) || opened.get(page).messages.push(text)
  page.on('console', (message) => print(message.text()))
  page.on('pageerror', (error) => print(`uncaught: ${error.message}`))
  return page
}

/**
 * Leaves a page of `servePages` to the next that `openPage` opens: a new one is a new process, which compiles all of p5 anew.
 * So would be one that was at about:blank meanwhile.
 */
export async function leavePage(page) {
  const { browser } = opened.get(page)
  await page.mouse.move(0, 0)
  await page.goto(new URL('/', page.url()).href)
  left.set(browser, page)
}

/** What the page gave to be saved. The browser may be one that other files of tests use, and then tells no path. */
export async function bytesOf(download) {
  const chunks = []
  for await (const chunk of await download.createReadStream()) chunks.push(chunk)
  return Buffer.concat(chunks)
}
