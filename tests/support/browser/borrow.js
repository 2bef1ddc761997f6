// Borrows one of the browsers that `npm test` has started for all test files, for one file at a time.
import { rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { chromium } from 'playwright-core'
import { browsersVariable } from '../../../.scripts/lib/browsers.mjs'

/** Returns a browser; null if there are none, or all are in use. Its `close()` closes its pages, and lets another file borrow it. */
export async function borrow() {
  const { taken, addresses } = JSON.parse(process.env[browsersVariable] ?? '{ "addresses": [] }')
  for (const [i, address] of addresses.entries()) {
    const mark = join(taken, `${i}`)
    if (!take(mark)) continue
    const browser = await chromium.connect(address).catch(() => null)
    // The mark remains, so that no other file tries to borrow a browser that crashed.
    if (!browser) continue
    browser.on('disconnected', () => rmSync(mark, { force: true }))
    return browser
  }
  return null
}

/** Takes a browser by creating a file exclusively, in which only one process succeeds. */
function take(mark) {
  try {
    writeFileSync(mark, '', { flag: 'wx' })
    return true
  } catch {
    return false
  }
}
