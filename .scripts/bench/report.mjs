// What the terminal shows of the measurements: a table for each row, and how they stand to what is aimed at.
import { degrees, plain, whole } from '../../web/bench/figures.js'
import { paint } from '../lib/terminal.mjs'
import { aims } from './aims.mjs'
import { alike, fixed, table } from './table.mjs'

const indented = (lines) => lines.map((line) => line && `  ${line}`).join('\n')

/** What the columns mean, once for all tables. */
export const legend = indented(
  [
    ['frame', 'milliseconds until the GPU is done: the median, and the middle half of all frames'],
    [
      '×',
      'as a multiple of positions only, which leaves normals alone, or of warpjet: the median of',
    ],
    ['', 'the quotients within each round, which may differ from that of the milliseconds'],
    [
      'fps',
      'frames a second in the page, with what the browser itself does for each: without a limit,',
    ],
    [
      '',
      'where that share can be large if there is no GPU, and with vsync, as a display would show',
    ],
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
  figures(['fps', 'uncapped'], 'uncappedFps', fixed(1)),
  figures(['fps', 'vsync'], 'cappedFps', fixed(1)),
]

const rowColumns = (records) => [
  methodColumn,
  ...frameColumns(records),
  figures(['×', 'positions'], 'toPositions', fixed(3)),
  figures(['×', 'warpjet'], 'toWarpjet', fixed(3)),
  ...rateColumns,
  figures(['first', 'ms'], 'firstMs', alike(records.map(({ firstMs }) => firstMs))),
  figures(['×', 'positions'], 'firstToPositions', fixed(2)),
  figures(['×', 'by hand'], 'firstToByHand', fixed(2)),
  figures(['text', 'characters'], 'characters', whole),
  figures(['×', 'by hand'], 'charactersToByHand', fixed(2)),
  figures(['generate', 'ms'], 'generationMs', plain),
  figures(['error', '°'], 'errorDegrees', degrees),
  figures(['', 'h'], 'h', plain),
]

const facts = ({ vertices, nodes, clock }) => [
  `${vertices.toLocaleString('en')} vertices`,
  `${nodes.toLocaleString('en')} nodes`,
  `clock: ${clock}`,
]

/** Chromium alone tells how much JavaScript holds. */
function peakMemory({ jsHeapMb, wasmHeapMb }) {
  const parts = Object.entries({ JavaScript: jsHeapMb, WebAssembly: wasmHeapMb })
    .filter(([, value]) => Number.isFinite(value))
    .map(([name, value]) => `${fixed(1)(value)} MB of ${name}`)
  return `peak heap: ${parts.join(', ')}`
}

/** The records of a row as text. */
export function rowText(records) {
  const line = [...facts(records[0]), peakMemory(records[0])].join(' · ')
  return indented([line, '', ...table(rowColumns(records), records, ours)])
}

/** The records of p5's sketches as text. @param toNoWarp by method, what its frame is to the same sketch's without the warp */
export function p5Text(records, toNoWarp) {
  const columns = [
    methodColumn,
    ...frameColumns(records),
    { head: ['×', 'no warp'], text: ({ method }) => fixed(3)(toNoWarp[method]) },
    ...rateColumns,
  ]
  const line = [`${records[0].row} in a sketch`, ...facts(records[0])].join(' · ')
  return indented([line, '', ...table(columns, records, ours)])
}

const aimColumns = aims.map(({ of, to, isMet, ratio }) => ({
  head: [of, to],
  ratio,
  isMet,
  text({ records }) {
    const value = ratio(records)
    return value && `${fixed(3)(value)} ${isMet(value) ? '✓' : '✗'}`
  },
}))

function aimStyle({ records }, { ratio, isMet }) {
  const value = ratio?.(records)
  return value && (isMet(value) ? 'green' : 'red')
}

/** How each row of `records` stands to the aims; undefined where none of them has any. */
export function aimsText(records) {
  const judged = records.filter(({ toWarpjet }) => toWarpjet !== undefined)
  const rows = [...new Set(judged.map(({ row }) => row))].map((name) => ({
    name,
    records: judged.filter(({ row }) => row === name),
  }))
  const nameColumn = { head: ['', ''], left: true, text: ({ name }) => name }
  return rows.length ? indented(table([nameColumn, ...aimColumns], rows, aimStyle)) : undefined
}
