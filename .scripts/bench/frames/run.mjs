// Measures one workload (a row of the benchmark) after another in the browsers' pages, through the functions of web/bench/driven.js, and
// prints the tables of a workload as soon as it is measured.
import { relative } from 'node:path'
import { workloads } from '../../../web/bench/workloads.js'
import { capture } from '../../lib/run.mjs'
import { good, heading, say, seconds } from '../../lib/terminal.mjs'
import { openBrowsers } from './browsers.mjs'
import { P5 } from './options.mjs'
import { appendRecords, p5Records, rowRecords } from './records.mjs'
import { createGoalsTable, describeRow, legend, rowTables } from './report.mjs'
import { serveBench } from './server.mjs'

/** Returns the commit of the measured code; '' without git. */
async function readCommit() {
  const id = await capture('git', ['rev-parse', '--short', 'HEAD'])
  if (id === null) return ''
  // The results of earlier runs do not affect the measurements.
  const exclusions = ['--untracked-files=no', '--', '.', ':!web/bench/results.csv']
  const changes = await capture('git', ['status', '--porcelain', ...exclusions])
  return `${id.trim()}${changes ? '-dirty' : ''}`
}

/** Measures the frame rates in each browser with `measureInPage`, which runs there. */
const measureRates = async ({ uncapped, capped }, measureInPage, options) => ({
  uncapped: await uncapped.evaluate(measureInPage, options),
  capped: await capped.evaluate(measureInPage, options),
})

/** Measures every method on the workload `name`; returns the records. */
async function measureWorkload(browsers, run, name, settings) {
  // Without this, the peak heap size would include garbage of the previous workload.
  await browsers.uncapped.requestGC()
  const measured = await browsers.uncapped.evaluate(
    ({ name, settings }) => window.bench.measure(name, settings),
    { name, settings },
  )
  // Maps each method of finite differences → the step `h` with the smallest error.
  const bestSteps = Object.fromEntries(
    measured.results.map(({ method, error }) => [method, error.h]),
  )
  const rates = await measureRates(
    browsers,
    ({ name, bestSteps, duration }) => window.bench.frameRates(name, bestSteps, duration),
    { name, bestSteps, duration: settings.duration },
  )
  const workload = workloads.find((each) => each.name === name)
  return rowRecords(run, workload, measured, rates)
}

/** Measures the p5 sketches; returns their records. */
async function measureP5(browsers, run, name, settings) {
  // Half the rounds suffice: differences of a few percent do not matter here, and each round has to load p5 again, which is slow.
  const rounds = Math.ceil(settings.rounds / 2)
  const measureInPage = (settings) => window.bench.measureP5(settings)
  const measured = await browsers.uncapped.evaluate(measureInPage, { ...settings, rounds })
  const measureRatesInPage = (settings) => window.bench.p5FrameRates(settings)
  const rates = await measureRates(browsers, measureRatesInPage, settings)
  return p5Records(run, workloads[0], measured, rates)
}

/** Measures each workload, prints its tables and passes its records to `save`; returns all records. */
async function measureAll(browsers, run, { rows, settings }, save) {
  const all = []
  for (const [i, name] of rows.entries()) {
    heading(`${name} (${i + 1} of ${rows.length})`)
    const measureOne = name === P5 ? measureP5 : measureWorkload
    const records = await measureOne(browsers, run, name, settings)
    say(describeRow(records))
    for (const table of rowTables(records)) console.table(table)
    save(records)
    all.push(...records)
  }
  return all
}

/** Measures, prints the tables, and appends the records to the file, if there is one. `options` is the result of readOptions. */
export async function measure(options) {
  const start = performance.now()
  const { file, settings, software } = options
  const server = await serveBench()
  let browsers
  try {
    browsers = await openBrowsers(server.url, settings.size, software)
    const { version: chromium, renderer, isSoftware } = browsers
    const { size: sizePx, rounds } = settings
    const date = new Date().toISOString().replace(/\.\d+Z$/, 'Z')
    const commit = await readCommit()
    good(`Chromium ${chromium}, ${isSoftware ? 'without a GPU' : 'on the GPU'}: ${renderer}`)
    good(`${sizePx} × ${sizePx} pixels, ${rounds} rounds with every method in turn`)
    say(legend)
    const run = { date, commit, chromium, renderer, sizePx, rounds }
    // Saves after each workload, so that a stopped run loses only the workload in progress.
    const save = (records) => file && appendRecords(file, records)
    const goals = createGoalsTable(await measureAll(browsers, run, options, save))
    if (Object.keys(goals).length) {
      heading(
        'Goals: figures of warpjet divided by those of other methods (with few rounds, mostly noise)',
      )
      console.table(goals)
    }
    if (file) good(`Appended to ${relative(process.cwd(), file)}`)
    good(`Done in ${seconds(start)}`)
  } finally {
    await browsers?.close()
    await server.close()
  }
}
