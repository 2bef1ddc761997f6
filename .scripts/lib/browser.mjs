// Finds Chromium and Firefox: CHROME_PATH and FIREFOX_PATH, the system's, or those that playwright-core has fetched.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { path } from './files.mjs'
import { Stop } from './terminal.mjs'
import { isProgram, onPath } from './which.mjs'

export const isUbuntu = () =>
  existsSync('/etc/os-release') && /^ID=ubuntu$/m.test(readFileSync('/etc/os-release', 'utf8'))

/**
 * Returns whether the program is one of the scripts that Ubuntu's packages install: Chromium's asks to install its snap,
 * Firefox's starts its snap, which cannot use a profile in /tmp.
 */
const isStub = (file) =>
  isUbuntu() && statSync(file).size < 20_000 && /\bsnap\b/.test(readFileSync(file, 'utf8'))

async function find(variable, names, applications, playwrightName) {
  const chosen = process.env[variable]
  if (chosen && !isProgram(chosen)) throw new Stop(`${variable} names no program: ${chosen}`)
  if (chosen) return chosen
  const installed = [...names.map((name) => onPath(name)), ...applications]
  const found = installed.find((file) => file && isProgram(file) && !isStub(file))
  if (found || !existsSync(path('node_modules/playwright-core'))) return found
  const { [playwrightName]: browser } = await import('playwright-core')
  return isProgram(browser.executablePath()) ? browser.executablePath() : undefined
}

export const findBrowser = () =>
  find(
    'CHROME_PATH',
    // Debian's headless shell is first: it draws the same in three quarters of the time, and is smaller.
    'chromium-headless-shell chromium chromium-browser google-chrome google-chrome-stable'.split(
      ' ',
    ),
    [
      '/snap/bin/chromium',
      '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
      '/Applications/Chromium.app/Contents/MacOS/Chromium',
    ],
    'chromium',
  )

export const findFirefox = () =>
  find(
    'FIREFOX_PATH',
    ['firefox-esr', 'firefox'],
    ['/Applications/Firefox.app/Contents/MacOS/firefox'],
    'firefox',
  )
