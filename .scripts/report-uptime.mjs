// npm run report:uptime: how right the gallery's warps are after a week, with and without what is computed once a frame,
// written as the table of web/docs/uptime.md.
import { readFileSync, writeFileSync } from 'node:fs'
import { format, resolveConfig } from 'prettier'
import { launchBrowser } from '../tests/support/browser/browser.js'
import { openPipeline } from '../tests/support/browser/transform-feedback.js'
import { afterAWeek, isMeasured } from '../tests/support/browser/uptime.js'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { good, main } from './lib/terminal.mjs'

const file = path('web/docs/uptime.md')

const size = (value) => (value === 0 ? '0' : value.toExponential(0))
const degrees = (value) => (value < 0.0001 ? '0' : value.toFixed(value < 0.1 ? 4 : 1))
const share = (value) => `${(100 * value).toFixed(value < 0.1 ? 1 : 0)} %`

const cells = ({ then, step }) => [size(then.position), degrees(then.angle), share(step)]

await main(async () => {
  await build()
  const { warps } = await import('../tests/warps/index.js')
  const browser = await launchBrowser()
  const gpu = await openPipeline(browser)
  const rows = []
  for (const warp of warps.filter(isMeasured)) {
    const before = await afterAWeek(gpu, warp, {})
    const now = await afterAWeek(gpu, warp, { perFrame: true })
    const start = [size(now.start.position), degrees(now.start.angle)]
    rows.push([`\`${warp.name}\``, ...start, ...cells(before), ...cells(now)])
  }
  await browser.close()
  const [text] = /^[^]*?\n\| warp .*\n\|.*\n/.exec(readFileSync(file, 'utf8'))
  const table = rows.map((row) => `| ${row.join(' | ')} |\n`).join('')
  const options = await resolveConfig(file)
  writeFileSync(file, await format(`${text}${table}`, { ...options, filepath: file }))
  good(`${rows.length} warps are in web/docs/uptime.md`)
})
