// The tables for the terminal: one for each row, and one that compares all rows with the aims.
import { formatDegrees, formatExact, formatInteger } from '../../../web/bench/figures.js'
import { paint } from '../../lib/terminal.mjs'
import { sameDecimals, table, withDecimals } from './table.mjs'

const indent = (lines) => lines.map((line) => line && `  ${line}`).join('\n')

/** Explains the columns, once for all tables. */
export const legend = indent(
  Object.entries({
    frame: 'milliseconds until the GPU is done: the median, and the middle half of all frames',
    '×': 'as a multiple of another method: the median of the quotients within each round',
    fps: 'frames a second in the page, with its own work: without a limit, and with vsync',
    first: 'milliseconds from source text to the first frame',
    text: 'characters that the method itself writes, without the shader around them',
    generate: 'milliseconds to write the source text',
    error: 'the largest angle to the exact normal, of 2,000 vertices, or pixels for dFdx',
    h: 'the step with the smallest error, in units of the mesh',
  }).map(([word, meaning]) => `${word.padEnd(8)}  ${paint('dim', meaning)}`),
)

/** Returns a column of the figures `record[name]`, written by `format`. */
const figureColumn = (upper, lower, name, format) => ({
  head: [upper, lower],
  text: (record) => (record[name] === undefined ? undefined : format(record[name])),
})

const textColumn = (name) => ({ head: ['', ''], left: true, text: (record) => record[name] })

const formatterOf = (records, name) => sameDecimals(records.map((record) => record[name]))

const rateColumns = [
  figureColumn('fps', 'uncapped', 'uncappedFps', withDecimals(1)),
  figureColumn('fps', 'vsync', 'cappedFps', withDecimals(1)),
]

function frameColumns(records) {
  const format = formatterOf(records, 'frameMs')
  return [
    textColumn('method'),
    figureColumn('frame', 'ms', 'frameMs', format),
    {
      head: ['middle half', 'ms'],
      text: ({ frameLowMs, frameHighMs }) => `${format(frameLowMs)} … ${format(frameHighMs)}`,
    },
  ]
}

const rowColumns = (records) => [
  ...frameColumns(records),
  figureColumn('×', 'positions', 'toPositions', withDecimals(3)),
  figureColumn('×', 'warpjet', 'toWarpjet', withDecimals(3)),
  ...rateColumns,
  figureColumn('first', 'ms', 'firstMs', formatterOf(records, 'firstMs')),
  figureColumn('×', 'positions', 'firstToPositions', withDecimals(2)),
  figureColumn('×', 'by hand', 'firstToByHand', withDecimals(2)),
  figureColumn('text', 'characters', 'characters', formatInteger),
  figureColumn('×', 'by hand', 'charactersToByHand', withDecimals(2)),
  figureColumn('generate', 'ms', 'generationMs', formatExact),
  figureColumn('error', '°', 'errorDegrees', formatDegrees),
  figureColumn('', 'h', 'h', formatExact),
]

const p5Columns = (records) => [
  ...frameColumns(records),
  figureColumn('×', 'no warp', 'toNoWarp', withDecimals(3)),
  ...rateColumns,
]

const describeRow = ({ vertices, nodes, clock, jsHeapMb, wasmHeapMb }) => [
  `${formatInteger(vertices)} vertices`,
  `${formatInteger(nodes)} nodes`,
  `clock: ${clock}`,
  jsHeapMb &&
    `peak heap: ${formatInteger(jsHeapMb)} MB of JavaScript, ${formatInteger(wasmHeapMb)} of WebAssembly`,
]

/** Formats the records of a row, or of p5's sketches. */
export function rowText(records) {
  const columns = (records[0].toNoWarp ? p5Columns : rowColumns)(records)
  const style = ({ method }) => (/\bwarpjet$/.test(method) ? 'bold' : undefined)
  const line = describeRow(records[0]).filter(Boolean).join(' · ')
  return indent([line, '', ...table(columns, records, style)])
}

const findMethod = (records, name) => records.find(({ method }) => method === name) ?? {}
const ours = (records) => findMethod(records, 'warpjet')
/** Returns warpjet's frame time divided by another method's. */
const frameRatio = (records, name) => 1 / findMethod(records, name).toWarpjet

/**
 * The performance aims of warpjet: `figure`, as a multiple of that of the method `to`, should be at most `max`. Missing an aim is not a
 * failure. `ratio(records)` takes the records of one row and returns undefined or NaN if the aim does not apply.
 */
export const aims = [
  { figure: 'frame ×', to: 'by hand', max: 1.03, ratio: (row) => frameRatio(row, 'by hand') },
  {
    figure: 'frame ×',
    to: 'forward',
    max: 1,
    ratio: (row) => frameRatio(row, 'forward differences'),
  },
  {
    figure: 'frame ×',
    to: 'positions',
    max: 1.5,
    ratio: (row) => (row[0].nodes === 3000 ? ours(row).toPositions : undefined),
  },
  { figure: 'first ×', to: 'positions', max: 2, ratio: (row) => ours(row).firstToPositions },
  { figure: 'first ×', to: 'by hand', max: 1.15, ratio: (row) => ours(row).firstToByHand },
  { figure: 'characters ×', to: 'by hand', max: 1.3, ratio: (row) => ours(row).charactersToByHand },
]

const aimColumn = ({ figure, to, max, ratio }) => ({
  head: [figure, `${to} ≤ ${max}`],
  text(row) {
    const value = ratio(row)
    return value ? `${value.toFixed(3)} ${value <= max ? '✓' : '✗'}` : undefined
  },
  style: (row) => (ratio(row) <= max ? 'green' : 'red'),
})

/** Returns a table that compares each row with the aims; `undefined` if no row has any. */
export function aimsText(records) {
  const withAims = records.filter(({ toWarpjet }) => toWarpjet !== undefined)
  if (!withAims.length) return undefined
  const names = [...new Set(withAims.map(({ row }) => row))]
  const rows = names.map((name) => withAims.filter(({ row }) => row === name))
  const name = { ...textColumn('row'), text: ([{ row }]) => row }
  return indent(table([name, ...aims.map(aimColumn)], rows, (row, column) => column.style?.(row)))
}
