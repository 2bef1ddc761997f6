// Runs the benchmark row by row, and prints the table of each row as soon as it is measured.
import { relative } from 'node:path'
import { capture } from '../lib/run.mjs'
import { Stop, good, heading, say, seconds } from '../lib/terminal.mjs'
import { openBrowsers } from './browsers.mjs'
import { appendLines } from './csv.mjs'
import { measureP5, measureRow, quick, thorough } from './measure.mjs'
import { P5 } from './options.mjs'
import { columns, fieldsOf } from './records.mjs'
import { aimsText, legend } from './report.mjs'
import { serveBench } from './server.mjs'

/** Returns the commit of the measured code; '' without git. */
async function commit() {
  const id = await capture('git', ['rev-parse', '--short', 'HEAD'])
  if (id === null) return ''
  // The results of earlier runs do not affect the measurements.
  const others = ['--untracked-files=no', '--', '.', ':!web/bench/results.csv']
  const changes = await capture('git', ['status', '--porcelain', ...others])
  return `${id.trim()}${changes ? '-dirty' : ''}`
}

/** Writes progress to stderr, so that a redirected stdout has only the tables. */
const note = (text) => process.stderr.write(`${text}\n`)

const now = () => new Date().toISOString().replace(/\.\d+Z$/, 'Z')

/** Prints what is measured, and on which browser and GPU. */
function introduce({ commit, chromium, renderer }, isSoftware, { size, rounds }, rows) {
  heading(
    `Benchmark${commit && ` of ${commit}`}: ${rows.length} ${rows.length > 1 ? 'rows' : 'row'}`,
  )
  good(`Chromium ${chromium}, ${isSoftware ? 'without a GPU' : 'on the GPU'}: ${renderer}`)
  good(`${size} × ${size} pixels, ${rounds} rounds with every method in turn`)
  say(`\n${legend}`)
}

/** Measures each of `rows`, prints its table and passes its records to `save` → all records. */
async function measureAll(browsers, run, rows, settings, save) {
  const all = []
  for (const [i, name] of rows.entries()) {
    const begin = (stage) => note(`${i + 1}/${rows.length} ${name}: ${stage}`)
    const { records, text } = await (name === P5
      ? measureP5(browsers, run, settings, begin)
      : measureRow(browsers, run, name, settings, begin))
    heading(name)
    say(text)
    save(records)
    all.push(...records)
  }
  return all
}

/**
 * Measures, prints the tables, and appends the records to `file`, if it is given.
 * @param chromium the path of the program
 * @param options { rows, quick, rounds?, software }: what readOptions returns
 */
export async function runBench(chromium, options, file) {
  const start = performance.now()
  const settings = options.quick ? { ...quick } : { ...thorough }
  settings.rounds = options.rounds ?? settings.rounds
  const server = await serveBench()
  let browsers
  let isStopped = false
  const stop = () => {
    isStopped = true
    browsers?.close()
  }
  process.once('SIGINT', stop)
  try {
    browsers = await openBrowsers({
      chromium,
      url: server.url,
      size: settings.size,
      withoutGpu: options.software,
    })
    const { version, renderer, isSoftware } = browsers
    const { size: sizePx, rounds } = settings
    const run = { date: now(), commit: await commit(), chromium: version, renderer, sizePx, rounds }
    // Row by row, so that a measurement that is stopped loses nothing.
    const keep = (records) => file && appendLines(file, columns, records.map(fieldsOf))
    introduce(run, isSoftware, settings, options.rows)
    const records = await measureAll(browsers, run, options.rows, settings, keep)

    const aims = aimsText(records)
    if (aims)
      heading(
        'What we aim at: warpjet as a multiple of other methods, in this run; with few rounds, noise decides',
      )
    if (aims) say(aims)
    say()
    if (file) good(`Appended to ${relative(process.cwd(), file)}`)
    good(`Done in ${seconds(start)}`)
  } catch (error) {
    if (!isStopped) throw error
    throw new Stop(`Stopped${file ? '; the rows that were finished are in the file' : ''}.`)
  } finally {
    process.off('SIGINT', stop)
    await browsers?.close()
    await server.close()
  }
}
