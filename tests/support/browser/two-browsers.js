// Drives Chromium and Firefox through Puppeteer's API, since Playwright can only drive its own build of Firefox.
import { spawn } from 'node:child_process'
import puppeteer from 'puppeteer-core'
import { findBrowser, findFirefox } from '../../../.scripts/lib/find-browser.mjs'
import { testFlags } from '../../../.scripts/lib/flags.mjs'

const options = { headless: true, protocolTimeout: 300_000 }

const launchChromium = async () =>
  puppeteer.launch({
    ...options,
    executablePath: process.env.WARPJET_CHROMIUM ?? (await findBrowser()),
    args: testFlags,
  })

/** Starts a virtual display. Returns { name, stop() }. */
async function startDisplay() {
  const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x1024x24'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  })
  const name = await new Promise((resolve, reject) => {
    server.on('error', reject)
    server.on('close', () => reject(new Error('Xvfb ended before it had a display')))
    server.stdio[3].on('data', (number) => resolve(`:${String(number).trim()}`))
  })
  return { name, stop: () => server.kill() }
}

/** Starts Firefox: on Linux with a virtual display, without which it has no WebGL. */
export async function launchFirefox() {
  const display = process.platform === 'linux' ? await startDisplay() : undefined
  const browser = await puppeteer.launch({
    ...options,
    browser: 'firefox',
    headless: !display,
    executablePath: await findFirefox(),
    env: { ...process.env, ...(display && { DISPLAY: display.name }) },
    extraPrefsFirefox: { 'webgl.force-enabled': true },
  })
  browser.once('disconnected', () => display?.stop())
  return browser
}

export const browsers = { Chromium: launchChromium, Firefox: launchFirefox }
