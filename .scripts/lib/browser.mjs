// Finds Chromium and Firefox: CHROME_PATH and FIREFOX_PATH, the system's, or those that playwright-core has fetched.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { path } from './files.mjs'
import { Stop } from './terminal.mjs'
import { isProgram, onPath } from './which.mjs'

/** Debian's headless shell is first: it draws the same in three quarters of the time, and is smaller. */
const names = [
  'chromium-headless-shell',
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
]
const applications = [
  '/snap/bin/chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
]

const firefoxNames = ['firefox-esr', 'firefox']
const firefoxApplications = ['/Applications/Firefox.app/Contents/MacOS/firefox']

export const isUbuntu = () =>
  existsSync('/etc/os-release') && /^ID=ubuntu$/m.test(readFileSync('/etc/os-release', 'utf8'))

/** Ubuntu's package `chromium-browser` is a script that only asks for the snap. */
function isStub(file) {
  if (existsSync('/snap/bin/chromium') || statSync(file).size > 20_000) return false
  return /snap install chromium/.test(readFileSync(file, 'utf8'))
}

/** Ubuntu's package `firefox` is a script that starts the snap, whose Firefox cannot use a profile in /tmp. */
const startsSnap = (file) =>
  isUbuntu() && statSync(file).size < 20_000 && /\bsnap\b/.test(readFileSync(file, 'utf8'))

/** Returns the program that an environment variable names, or `undefined`. */
function programFrom(variable) {
  const chosen = process.env[variable]
  if (chosen && !isProgram(chosen)) throw new Stop(`${variable} names no program: ${chosen}`)
  return chosen
}

export async function findBrowser() {
  const found = [...names.map((name) => onPath(name)), ...applications]
  return (
    programFrom('CHROME_PATH') ??
    found.find((file) => file && isProgram(file) && !isStub(file)) ??
    (await fetchedBrowser('chromium'))
  )
}

export async function findFirefox() {
  const found = [...firefoxNames.map((name) => onPath(name)), ...firefoxApplications]
  return (
    programFrom('FIREFOX_PATH') ??
    found.find((file) => file && isProgram(file) && !startsSnap(file)) ??
    (await fetchedBrowser('firefox'))
  )
}

async function fetchedBrowser(name) {
  if (!existsSync(path('node_modules/playwright-core'))) return null
  const { [name]: browser } = await import('playwright-core')
  return isProgram(browser.executablePath()) ? browser.executablePath() : null
}
