// One of the browsers that `npm test` started for all files of tests, for one file at a time.
import { rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { chromium } from 'playwright-core'
import { variable } from '../../../.scripts/lib/browsers.mjs'

/** Null where there are none, or all are taken. `close()` gives it back, without its pages. */
export async function borrow() {
  const { taken, addresses } = JSON.parse(process.env[variable] ?? '{ "addresses": [] }')
  for (const [i, address] of addresses.entries()) {
    const mark = join(taken, `${i}`)
    if (!take(mark)) continue
    const browser = await chromium.connect(address).catch(() => null)
    // One that broke stays taken.
    if (!browser) continue
    browser.on('disconnected', () => rmSync(mark, { force: true }))
    return browser
  }
  return null
}

/** The file system lets only one process make a file that must be new. */
function take(mark) {
  try {
    writeFileSync(mark, '', { flag: 'wx' })
    return true
  } catch {
    return false
  }
}
