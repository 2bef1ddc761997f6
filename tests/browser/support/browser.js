// A headless Chromium that draws WebGL without a GPU, and pages that remember whatever they printed.
import { chromium } from 'playwright-core'
import { softwareFlags } from '../../../.scripts/lib/flags.mjs'

/** The Chromium that WARPJET_CHROMIUM names, or Debian's. `moreFlags` are added to its command line. */
export const launchBrowser = (moreFlags = []) =>
  chromium.launch({
    executablePath: process.env.WARPJET_CHROMIUM ?? '/usr/bin/chromium',
    args: [...softwareFlags, ...moreFlags],
  })

/** Opens `url` → { page, messages }; `messages` collects console lines and uncaught errors, in order. */
export async function openPage(browser, url) {
  const page = await browser.newPage()
  const messages = []
  page.on('console', (message) => messages.push(message.text()))
  page.on('pageerror', (error) => messages.push(`uncaught: ${error.message}`))
  // A server may make a model first, while other tests keep the machine busy.
  await page.goto(url, { timeout: 180_000 })
  return { page, messages }
}
