// node tests/firefox/site.mjs [words of paths]: opens every page of the built site in Firefox, on a desktop and on a phone, and prints what
// any of them prints, what does not fit, and what stays undrawn. By hand, after `npm run site`.
import { mkdirSync } from 'node:fs'
import { preview } from 'vite'
import { path, walk } from '../../.scripts/lib/files.mjs'
import { launchFirefox } from '../support/browser/two-browsers.js'

const folder = '.build/site'
const screenshots = path('.build/screenshots/firefox')
const sizes = { desktop: { width: 1280, height: 900 }, phone: { width: 360, height: 740 } }
const patience = 60_000

/** In the page, when it has come to rest → what is wrong with it. */
async function look() {
  const until = performance.now() + 60_000
  const wait = async (ready) => {
    while (!ready() && performance.now() < until) await new Promise((go) => setTimeout(go, 100))
    return ready()
  }
  const wrong = []
  const find = (selector) => document.querySelector(selector)
  if (find('.hero') && !(await wait(() => find('.hero canvas')))) wrong.push('The hero is still')
  if (find('main[data-name]') && !(await wait(() => find('iframe.shown'))))
    wrong.push(`The example is not drawn: ${find('.rate').textContent}`)
  if (find('.playground') && !(await wait(() => find('main').ariaBusy === 'false')))
    wrong.push('The playground is busy')
  if (find('.playground .mistake')?.textContent) wrong.push(find('.mistake').textContent)
  // What a page was loading when it is left, Firefox calls an error.
  const loaded = () => performance.getEntriesByType('resource').length
  for (let before = -1; before !== loaded();) {
    before = loaded()
    await new Promise((go) => setTimeout(go, 400))
  }
  const { scrollWidth } = document.documentElement
  if (scrollWidth > innerWidth) wrong.push(`It is ${scrollWidth} wide`)
  return wrong
}

/** What a driver without a GPU says of itself. */
const isOfDriver = (text) => /WebGL warning|WEBGL_debug_renderer_info|GPU stall/.test(text)

const wanted = process.argv.slice(2)
const pages = walk(folder, /\.html$/)
  .map((file) => file.slice(folder.length + 1))
  .filter((file) => !/^(?:examples|bench\/(?:driven|p5-sketch))/.test(file))
  .filter((file) => !wanted.length || wanted.some((word) => file.includes(word)))
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
  if (!isOfDriver(message.text())) messages.push(`${message.type()}: ${message.text()}`)
})
page.on('pageerror', ({ message }) => messages.push(`uncaught: ${message}`))
const wrong = []
for (const [size, viewport] of Object.entries(sizes)) {
  await page.setViewport(viewport)
  for (const file of pages) {
    messages = []
    const late = new Promise((give) => setTimeout(give, 2 * patience, ['It hangs']))
    const seen = async () => {
      await page.goto(url + file, { timeout: 2 * patience })
      return page.evaluate(look)
    }
    const found = [...(await Promise.race([seen(), late])), ...messages]
    for (const each of found) wrong.push(`${size}, ${file}: ${each}`)
    console.log(`${size} ${file} ${found.length ? found.join(' | ') : 'is well'}`)
    if (/^index|playground|units|gallery\/(?:lotus|three-sea)/.test(file)) {
      const name = `${size}-${file.replaceAll('/', '-')}.png`
      await page.screenshot({ path: `${screenshots}/${name}` })
    }
  }
}
await firefox.close()
await server.close()
console.log(
  wrong.length ? `\n${wrong.join('\n')}` : `\nNothing is wrong with ${pages.length} pages.`,
)
process.exit(wrong.length ? 1 : 0)
