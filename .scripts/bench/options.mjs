// The command line of `npm run bench`.
import { parseArgs } from 'node:util'
import { Stop } from '../lib/terminal.mjs'

/** The row that runs p5 sketches instead of methods. */
export const P5 = 'p5'

const quickRows = ['14,000 × 150', 'airplane twist', 'wobble', P5]

export const helpText = (rows) => `Usage: npm run bench -- [options]

Draws warped meshes in headless Chromium in several ways: warpjet, finite differences,
dFdx, derivatives by hand, on this machine's GPU if it has one. Prints what a frame of each takes
and how far its normals are off, and appends all of it to web/bench/results.csv. Without a GPU, on
two cores, it takes about a quarter of an hour, in which the machine should do nothing else.

  --quick         a small picture, few rows and rounds, to see that all of it works: a minute;
                  appends nothing, unless --out names a file
  --row <name>    this row alone; can be repeated. 14000x150 will do for 14,000 × 150, and a part of
                  a name where no other has it, twist for airplane twist
  --rounds <n>    how many times each method has its turn
  --out <file>    the CSV file to append to
  --software      draw without the GPU, though there is one
  --help          this text

Rows, vertices × nodes or by name:
${[...rows, P5].map((name) => `  ${name}`).join('\n')}

CHROME_PATH names the Chromium to use.`

const options = {
  quick: { type: 'boolean', default: false },
  row: { type: 'string', multiple: true },
  rounds: { type: 'string' },
  out: { type: 'string' },
  software: { type: 'boolean', default: false },
  help: { type: 'boolean', default: false },
}

/** Normalizes a name for comparison: '14,000 × 150' is '14000x150'. */
const plain = (name) => name.toLowerCase().replaceAll('×', 'x').replace(/[\s,]/g, '')

function findRow(wanted, rows) {
  const exact = rows.filter((name) => plain(name) === plain(wanted))
  const similar = plain(wanted) ? rows.filter((name) => plain(name).includes(plain(wanted))) : []
  const found = exact.length ? exact : similar
  if (found.length === 1) return found[0]
  const problem = found.length ? 'Several rows are' : 'No row is'
  throw new Stop(
    `${problem} named '${wanted}': choose from ${(found.length ? found : rows).join('; ')}.`,
  )
}

/**
 * @param rows the names of all rows but p5's
 * @returns { quick, rows, rounds, out, software, help }, where `rows` are in the benchmark's order; `rounds` and `out` may be undefined
 */
export function readOptions(args, rows) {
  const { row: wanted, rounds, ...values } = parse(args)
  const all = [...rows, P5]
  const chosen = wanted?.map((name) => findRow(name, all)) ?? (values.quick ? quickRows : all)
  if (rounds !== undefined && !/^[1-9]\d{0,4}$/.test(rounds))
    throw new Stop(`--rounds takes a whole number from 1, not ${rounds}.`)
  return {
    ...values,
    rows: all.filter((name) => chosen.includes(name)),
    rounds: rounds && Number(rounds),
  }
}

function parse(args) {
  try {
    return parseArgs({ args, options }).values
  } catch (error) {
    // The rest of Node's message is about arguments that begin with a dash.
    throw new Stop(`${error.message.split(/\.\s/)[0]}; --help lists the options.`)
  }
}
