// Measures the precision of the gallery's warps after a week of uptime, without and with values computed once per frame on the CPU.
import { launchBrowser } from '../../tests/support/browser/browser.js'
import { openPipeline } from '../../tests/support/browser/transform-feedback.js'
import { isMeasured, measureAfterAWeek } from '../../tests/support/browser/uptime.js'
import { warps } from '../../tests/warps/index.js'
import { markdownTable } from '../reference/parts.mjs'

const formatSize = (value) => (value === 0 ? '0' : value.toExponential(0))
const formatDegrees = (value) => (value < 0.0001 ? '0' : value.toFixed(value < 0.1 ? 4 : 1))
const formatPercent = (value) => `${(100 * value).toFixed(value < 0.1 ? 1 : 0)} %`
/** `then` has the errors after a week, `step` the error of the motion from one frame to the next, 16 ms later. */
const formatCells = ({ then, step }) => [
  formatSize(then.position),
  formatDegrees(then.angle),
  formatPercent(step),
]
const columns = ['positions', 'normals (°)', '16 ms']

export async function measure() {
  const browser = await launchBrowser()
  const gpu = await openPipeline(browser)
  const rows = []
  for (const warp of warps.filter(isMeasured)) {
    const without = await measureAfterAWeek(gpu, warp, {})
    const withPerFrame = await measureAfterAWeek(gpu, warp, { perFrame: true })
    const start = [formatSize(withPerFrame.start.position), formatDegrees(withPerFrame.start.angle)]
    rows.push([`\`${warp.name}\``, ...start, ...formatCells(without), ...formatCells(withPerFrame)])
  }
  await browser.close()
  const head = ['at start: positions', 'normals (°)', 'after a week, before: positions']
  return {
    warps: markdownTable(
      ['warp', ...head, ...columns.slice(1), 'now: positions', ...columns.slice(1)],
      rows,
      true,
    ),
  }
}
