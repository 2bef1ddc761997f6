// The command line of `npm run bench`. A row of the benchmark is a workload: a mesh with an offset function, on which all methods are
// measured.
import { resolve } from 'node:path'
import { workloads } from '../../../web/bench/workloads.js'
import { path } from '../../lib/files.mjs'
import { parseOptions } from '../../lib/options.mjs'
import { Stop } from '../../lib/terminal.mjs'

/** The name of the row that measures p5 sketches with and without a warp, instead of methods. */
export const P5 = 'p5'

const allRows = [...workloads.map(({ name }) => name), P5]
const quickRows = ['14,000 × 150', 'airplane twist', 'wobble', P5]

/**
 * The settings of a run with reliable figures. `size` is that of the canvas in pixels, `duration` the milliseconds for which a frame rate
 * is measured; web/bench/measure.js describes the rest.
 */
const thorough = {
  ...{ size: 1200, rounds: 11, frames: 15, duration: 1000 },
  ...{ turn: 250, runs: 50, samples: 2000 },
}

/** The settings of `--quick`, which only checks that the benchmark works. */
const quick = { size: 150, rounds: 3, frames: 2, turn: 30, runs: 5, samples: 100, duration: 100 }

export const helpText = `Usage: npm run bench -- [options]

Draws warped meshes in headless Chromium in several ways: warpjet, finite differences, dFdx, derivatives by hand, on this machine's
GPU if it has one. Prints the time of a frame and the error of the normals, and appends all of it to web/bench/results.csv. Without a
GPU, on two cores, it takes about a quarter of an hour, in which the machine should do nothing else.

  --quick         a minute, to see that all of it works: a small picture, few rows and rounds; appends nothing without --out
  --row <name>    only this row; can be repeated. 14000x150 means 14,000 × 150
  --rounds <n>    how many times each method is measured
  --out <file>    the CSV file to append to
  --software      draw without the GPU
  --help          this text

Rows, vertices × nodes or by name:
${allRows.map((name) => `  ${name}`).join('\n')}

CHROME_PATH names the Chromium to use.`

const options = {
  quick: { type: 'boolean', default: false },
  row: { type: 'string', multiple: true },
  out: { type: 'string' },
  software: { type: 'boolean', default: false },
  help: { type: 'boolean', default: false },
}

/** Normalizes a name for comparison: '14,000 × 150' is '14000x150'. */
const normalize = (name) => name.toLowerCase().replaceAll('×', 'x').replace(/[\s,]/g, '')

function findRow(nameFromUser, rows) {
  const found = rows.find((name) => normalize(name) === normalize(nameFromUser))
  if (found) return found
  throw new Stop(
    `Expected the name of a row, got '${nameFromUser}': choose from ${rows.join('; ')}.`,
  )
}

/**
 * @returns { rows, settings, file, software, help }, where `rows` are names in the benchmark's order and `file` is the CSV file to append to
 * (undefined if there is none)
 */
export function readOptions(args, all = allRows) {
  const {
    row: namesFromUser,
    rounds,
    out,
    quick: isQuick,
    ...values
  } = parseOptions(args, { rounds: undefined }, options)
  const chosen = namesFromUser?.map((name) => findRow(name, all)) ?? (isQuick ? quickRows : all)
  const settings = { millis: 1200, ...(isQuick ? quick : thorough) }
  if (rounds) settings.rounds = rounds
  const defaultFile = isQuick ? undefined : path('web/bench/results.csv')
  return {
    ...values,
    rows: all.filter((name) => chosen.includes(name)),
    settings,
    file: out ? resolve(out) : defaultFile,
  }
}
