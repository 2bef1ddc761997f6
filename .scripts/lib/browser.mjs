// Where Chromium is: CHROME_PATH, the system's, or the one that playwright-core has fetched.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { path } from './files.mjs'
import { Stop } from './terminal.mjs'
import { isProgram, onPath } from './which.mjs'

/** Debian's headless shell first: it draws what Chromium draws, in three quarters of the time, and is smaller. */
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

export const isUbuntu = () =>
  existsSync('/etc/os-release') && /^ID=ubuntu$/m.test(readFileSync('/etc/os-release', 'utf8'))

/** Ubuntu's package `chromium-browser` is a script that only asks for the snap. */
function isStub(file) {
  if (existsSync('/snap/bin/chromium') || statSync(file).size > 20_000) return false
  return /snap install chromium/.test(readFileSync(file, 'utf8'))
}

export async function findBrowser() {
  const chosen = process.env.CHROME_PATH
  if (chosen && !isProgram(chosen)) throw new Stop(`CHROME_PATH names no program: ${chosen}`)
  if (chosen) return chosen
  const found = [...names.map((name) => onPath(name)), ...applications]
  return found.find((file) => file && isProgram(file) && !isStub(file)) ?? (await fetchedBrowser())
}

async function fetchedBrowser() {
  if (!existsSync(path('node_modules/playwright-core'))) return null
  const { chromium } = await import('playwright-core')
  return isProgram(chromium.executablePath()) ? chromium.executablePath() : null
}
