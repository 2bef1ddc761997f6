// One row measured in the browsers' pages. See web/bench/driven.js for what these can do.
import { workloads } from '../../web/bench/workloads.js'
import { p5Records, rowRecords } from './records.mjs'
import { p5Text, rowText } from './report.mjs'

/**
 * What the pages are asked, for the tables that are worth reading: `size` of the canvas, in pixels; `duration` of measuring a frame
 * rate, in milliseconds; the rest as in web/bench/measure.js.
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

/** For finding out whether all of it works. */
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

/** Frames a second in each browser. */
async function bothRates({ uncapped, capped }, begin, ask, question) {
  begin('frames a second, uncapped')
  const rates = { uncapped: await uncapped.evaluate(ask, question) }
  begin('frames a second with vsync')
  return { ...rates, capped: await capped.evaluate(ask, question) }
}

/**
 * Every method in the row of that name → { records, text }.
 * @param browsers what openBrowsers returns
 * @param run { date, commit, chromium, renderer }, which all records of a run have
 * @param begin is told the name of each stage
 */
export async function measureRow(browsers, run, name, settings, begin) {
  begin('frame times')
  // Or this row's peak would have the rubbish of the row before.
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

/** The sketches on p5 → the same. */
export async function measureP5(browsers, run, settings, begin) {
  begin('frame times')
  const ask = (settings) => window.bench.measureP5(settings)
  // A sketch has no methods to tell apart by percents, and each of its rounds takes long: p5 is loaded anew.
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
