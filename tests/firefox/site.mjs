// node tests/firefox/site.mjs [parts of paths]: opens the pages of the built site in Firefox, in the sizes of a desktop and of a phone, and
// reports console messages, pages that are too wide, and missing pictures. By default, opens all pages. Run it by hand, after `npm run
// site`.
import { mkdirSync } from 'node:fs'
import { preview } from 'vite'
import { path, walk } from '../../.scripts/lib/files.mjs'
import { launchFirefox } from '../support/browser/two-browsers.js'

const folder = '.build/site'
const screenshots = path('.build/screenshots/firefox')
const sizes = { desktop: { width: 1280, height: 900 }, phone: { width: 360, height: 740 } }
/** Half the time limit for a page, in milliseconds. */
const patience = 60_000

/** Runs in the page: waits until it has been drawn. Returns a list of its problems. */
async function findProblems() {
  const deadline = performance.now() + 60_000
  const wait = async (ready) => {
    while (!ready() && performance.now() < deadline)
      await new Promise((resolve) => setTimeout(resolve, 100))
    return ready()
  }
  const problems = []
  const find = (selector) => document.querySelector(selector)
  if (find('.hero') && !(await wait(() => find('.hero canvas'))))
    problems.push('The hero is not drawn')
  if (find('main[data-name]') && !(await wait(() => find('iframe.shown'))))
    problems.push(`The example is not drawn: ${find('.rate').textContent}`)
  if (find('.playground') && !(await wait(() => find('main').ariaBusy === 'false')))
    problems.push('The playground is busy')
  if (find('.playground .mistake')?.textContent) problems.push(find('.mistake').textContent)
  // Waits for all requests: if we left the page earlier, Firefox would report errors for interrupted ones.
  const countLoaded = () => performance.getEntriesByType('resource').length
  for (let before = -1; before !== countLoaded();) {
    before = countLoaded()
    await new Promise((resolve) => setTimeout(resolve, 400))
  }
  const { scrollWidth } = document.documentElement
  if (scrollWidth > innerWidth) problems.push(`The page is ${scrollWidth} pixels wide`)
  return problems
}

/** Tests for messages that the graphics driver prints if there is no GPU. */
const isDriverMessage = (text) => /WebGL warning|WEBGL_debug_renderer_info|GPU stall/.test(text)

const filters = process.argv.slice(2)
const pages = walk(folder, /\.html$/)
  .map((file) => file.slice(folder.length + 1))
  .filter((file) => !/^(?:examples|bench\/(?:driven|p5-sketch))/.test(file))
  .filter((file) => !filters.length || filters.some((word) => file.includes(word)))
mkdirSync(screenshots, { recursive: true })
const server = await preview({
  configFile: path('web/vite.config.js'),
  logLevel: 'warn',
  base: '/some/folder/',
  preview: { port: 5360 },
  build: { outDir: path(folder) },
})
const url = server.resolvedUrls.local[0]
const firefox = await launchFirefox()
const page = await firefox.newPage()
let messages = []
page.on('console', (message) => {
  if (!isDriverMessage(message.text())) messages.push(`${message.type()}: ${message.text()}`)
})
page.on('pageerror', ({ message }) => messages.push(`uncaught: ${message}`))
const problems = []
for (const [size, viewport] of Object.entries(sizes)) {
  await page.setViewport(viewport)
  for (const file of pages) {
    messages = []
    const timeout = new Promise((resolve) =>
      setTimeout(resolve, 2 * patience, ['The page does not respond']),
    )
    const inspect = async () => {
      await page.goto(url + file, { timeout: 2 * patience })
      return page.evaluate(findProblems)
    }
    const found = [...(await Promise.race([inspect(), timeout])), ...messages]
    for (const problem of found) problems.push(`${size}, ${file}: ${problem}`)
    console.log(`${size} ${file} ${found.length ? found.join(' | ') : 'has no problems'}`)
    if (/^index|playground|units|gallery\/(?:lotus|three-sea)/.test(file)) {
      const name = `${size}-${file.replaceAll('/', '-')}.png`
      await page.screenshot({ path: `${screenshots}/${name}` })
    }
  }
}
await firefox.close()
await server.close()
console.log(
  problems.length ? `\n${problems.join('\n')}` : `\nNo problems on ${pages.length} pages.`,
)
process.exit(problems.length ? 1 : 0)
