// Finds Chromium and Firefox: at CHROME_PATH or FIREFOX_PATH, else installed on the system, else fetched by playwright-core.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { path } from './files.mjs'
import { Stop } from './terminal.mjs'
import { isProgram, onPath } from './which.mjs'

export const isUbuntu = () =>
  existsSync('/etc/os-release') && /^ID=ubuntu$/m.test(readFileSync('/etc/os-release', 'utf8'))

/**
 * Returns whether the program is one of the scripts that Ubuntu's packages install in place of browsers. Chromium's script asks to install
 * a snap, Firefox's starts one, and snaps cannot use a profile in /tmp.
 */
const isStub = (file) =>
  isUbuntu() && statSync(file).size < 20_000 && /\bsnap\b/.test(readFileSync(file, 'utf8'))

/** `variable` is the environment variable with the user's choice, `names` are looked up on PATH, `applications` are absolute paths. */
async function find(variable, names, applications, playwrightName) {
  const chosen = process.env[variable]
  if (chosen && !isProgram(chosen))
    throw new Stop(`Expected a program in ${variable}, got ${chosen}.`)
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
    // Debian's headless shell is first: it draws the same pictures in three quarters of the time, and is smaller.
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
