// The tables for the terminal: one for each row, and one that compares all rows with the aims.
import { degrees, plain, whole } from '../../web/bench/figures.js'
import { paint } from '../lib/terminal.mjs'
import { aims } from './aims.mjs'
import { alike, withDecimals, table } from './table.mjs'

const indent = (lines) => lines.map((line) => line && `  ${line}`).join('\n')

/** Explains the columns, once for all tables. */
export const legend = indent(
  [
    ['frame', 'milliseconds until the GPU is done: the median, and the middle half of all frames'],
    [
      '×',
      'as a multiple of positions only, which leaves normals alone, or of warpjet: the median of',
    ],
    ['', 'the quotients within each round, which may differ from that of the milliseconds'],
    [
      'fps',
      'frames a second in the page, including the browser’s own work per frame: without a limit,',
    ],
    ['', 'where that work can dominate if there is no GPU, and with vsync, as on a display'],
    ['first', 'milliseconds from source text to the first frame'],
    ['text', 'characters that the method itself writes, without the shader around them'],
    ['generate', 'milliseconds to write the source text'],
    [
      'error',
      'the largest angle to the exact warped normal, of up to 2,000 vertices, or pixels for dFdx;',
    ],
    ['', 'h, in units of the mesh, is the step that makes it least'],
  ].map(([word, meaning]) => `${word.padEnd(8)}  ${paint('dim', meaning)}`),
)

/** A column of the figures `record[name]`, written by `format`. */
const figures = (head, name, format) => ({
  head,
  text: (record) => (record[name] === undefined ? undefined : format(record[name])),
})

const methodColumn = { head: ['', ''], left: true, text: ({ method }) => method }

const ours = ({ method }) => (/\bwarpjet$/.test(method) ? 'bold' : undefined)

function frameColumns(records) {
  const format = alike(records.map(({ frameMs }) => frameMs))
  return [
    figures(['frame', 'ms'], 'frameMs', format),
    {
      head: ['middle half', 'ms'],
      text: ({ frameLowMs, frameHighMs }) => `${format(frameLowMs)} … ${format(frameHighMs)}`,
    },
  ]
}

const rateColumns = [
  figures(['fps', 'uncapped'], 'uncappedFps', withDecimals(1)),
  figures(['fps', 'vsync'], 'cappedFps', withDecimals(1)),
]

const rowColumns = (records) => [
  methodColumn,
  ...frameColumns(records),
  figures(['×', 'positions'], 'toPositions', withDecimals(3)),
  figures(['×', 'warpjet'], 'toWarpjet', withDecimals(3)),
  ...rateColumns,
  figures(['first', 'ms'], 'firstMs', alike(records.map(({ firstMs }) => firstMs))),
  figures(['×', 'positions'], 'firstToPositions', withDecimals(2)),
  figures(['×', 'by hand'], 'firstToByHand', withDecimals(2)),
  figures(['text', 'characters'], 'characters', whole),
  figures(['×', 'by hand'], 'charactersToByHand', withDecimals(2)),
  figures(['generate', 'ms'], 'generationMs', plain),
  figures(['error', '°'], 'errorDegrees', degrees),
  figures(['', 'h'], 'h', plain),
]

const facts = ({ vertices, nodes, clock }) => [
  `${vertices.toLocaleString('en')} vertices`,
  `${nodes.toLocaleString('en')} nodes`,
  `clock: ${clock}`,
]

/** Only Chromium reports the size of the JavaScript heap. */
function peakMemory({ jsHeapMb, wasmHeapMb }) {
  const parts = Object.entries({ JavaScript: jsHeapMb, WebAssembly: wasmHeapMb })
    .filter(([, value]) => Number.isFinite(value))
    .map(([name, value]) => `${withDecimals(1)(value)} MB of ${name}`)
  return `peak heap: ${parts.join(', ')}`
}

/** Formats the records of a row. */
export function rowText(records) {
  const line = [...facts(records[0]), peakMemory(records[0])].join(' · ')
  return indent([line, '', ...table(rowColumns(records), records, ours)])
}

/** Formats the records of p5's sketches. @param toNoWarp maps each method → its frame time divided by that of the same sketch without the warp */
export function p5Text(records, toNoWarp) {
  const columns = [
    methodColumn,
    ...frameColumns(records),
    { head: ['×', 'no warp'], text: ({ method }) => withDecimals(3)(toNoWarp[method]) },
    ...rateColumns,
  ]
  const line = [`${records[0].row} in a sketch`, ...facts(records[0])].join(' · ')
  return indent([line, '', ...table(columns, records, ours)])
}

const aimColumns = aims.map(({ of, to, isMet, ratio }) => ({
  head: [of, to],
  ratio,
  isMet,
  text({ records }) {
    const value = ratio(records)
    return value && `${withDecimals(3)(value)} ${isMet(value) ? '✓' : '✗'}`
  },
}))

function aimStyle({ records }, { ratio, isMet }) {
  const value = ratio?.(records)
  return value && (isMet(value) ? 'green' : 'red')
}

/** Returns a table that compares each row with the aims; `undefined` if no row has any. */
export function aimsText(records) {
  const judged = records.filter(({ toWarpjet }) => toWarpjet !== undefined)
  const rows = [...new Set(judged.map(({ row }) => row))].map((name) => ({
    name,
    records: judged.filter(({ row }) => row === name),
  }))
  const nameColumn = { head: ['', ''], left: true, text: ({ name }) => name }
  return rows.length ? indent(table([nameColumn, ...aimColumns], rows, aimStyle)) : undefined
}
