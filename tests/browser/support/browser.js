// A headless Chromium that draws WebGL without a GPU, and pages that remember whatever they printed.
import { chromium } from 'playwright-core'

const flags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
]

/** The Chromium that WARPJET_CHROMIUM names, or Debian's. `moreFlags` are added to its command line. */
export const launchBrowser = (moreFlags = []) =>
  chromium.launch({
    executablePath: process.env.WARPJET_CHROMIUM ?? '/usr/bin/chromium',
    args: [...flags, ...moreFlags],
  })

/** Opens `url` → { page, messages }; `messages` collects console lines and uncaught errors, in order. */
export async function openPage(browser, url) {
  const page = await browser.newPage()
  const messages = []
  page.on('console', (message) => messages.push(message.text()))
  page.on('pageerror', (error) => messages.push(`uncaught: ${error.message}`))
  await page.goto(url)
  return { page, messages }
}
