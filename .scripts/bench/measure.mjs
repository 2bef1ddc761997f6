// Measures one row in the browsers' pages, through the functions of web/bench/driven.js.
import { workloads } from '../../web/bench/workloads.js'
import { p5Records, rowRecords } from './records.mjs'
import { p5Text, rowText } from './report.mjs'

/**
 * The settings of a run with reliable figures. `size` is that of the canvas in pixels, `duration` the milliseconds for which a frame rate
 * is measured; web/bench/measure.js describes the rest.
 */
export const thorough = {
  size: 1200,
  rounds: 11,
  frames: 15,
  turn: 250,
  runs: 50,
  samples: 2000,
  millis: 1200,
  duration: 1000,
}

/** The settings of `--quick`, which only checks that the benchmark works. */
export const quick = {
  size: 150,
  rounds: 3,
  frames: 2,
  turn: 30,
  runs: 5,
  samples: 100,
  millis: 1200,
  duration: 100,
}

/** Measures the frame rates in each browser. */
async function bothRates({ uncapped, capped }, begin, ask, question) {
  begin('frames a second, uncapped')
  const rates = { uncapped: await uncapped.evaluate(ask, question) }
  begin('frames a second with vsync')
  return { ...rates, capped: await capped.evaluate(ask, question) }
}

/**
 * Measures every method in the row of that name → { records, text }.
 * @param browsers the result of openBrowsers
 * @param run { date, commit, chromium, renderer }, which all records of a run have
 * @param begin is called with the name of each stage
 */
export async function measureRow(browsers, run, name, settings, begin) {
  begin('frame times')
  // Otherwise this row's peak would include the garbage of the previous row.
  await browsers.uncapped.requestGC()
  const measured = await browsers.uncapped.evaluate(
    ({ name, settings }) => window.bench.measure(name, settings),
    { name, settings },
  )
  const steps = Object.fromEntries(measured.results.map(({ method, error }) => [method, error.h]))
  const rates = await bothRates(
    browsers,
    begin,
    ({ name, steps, duration }) => window.bench.frameRates(name, steps, duration),
    { name, steps, duration: settings.duration },
  )
  const row = workloads.find((workload) => workload.name === name)
  const records = rowRecords(run, row, measured, rates)
  return { records, text: rowText(records) }
}

/** Measures the p5 sketches → { records, text } */
export async function measureP5(browsers, run, settings, begin) {
  begin('frame times')
  const ask = (settings) => window.bench.measureP5(settings)
  // Half the rounds suffice: differences of a few percent do not matter here, and each round has to load p5 again, which is slow.
  const rounds = Math.ceil(settings.rounds / 2)
  const measured = await browsers.uncapped.evaluate(ask, { ...settings, rounds })
  const askRates = (settings) => window.bench.p5FrameRates(settings)
  const rates = await bothRates(browsers, begin, askRates, settings)
  const records = p5Records(run, workloads[0], measured, rates)
  const toNoWarp = Object.fromEntries(
    measured.results.map(({ method, toNoWarp }) => [method, toNoWarp]),
  )
  return { records, text: p5Text(records, toNoWarp) }
}
