// The tables for the terminal: two for each row, and one that compares all rows with the aims.
import { formatInteger } from '../../../web/bench/figures.js'

/** Explains the columns, once for all tables. */
export const legend = `
ms            milliseconds of a frame until the GPU is done: the median, and the middle half of all frames
×             as a multiple of another method: the median of the quotients within each round
fps           frames per second in the page, with its own work: without a limit, and with vsync
first         milliseconds from source text to the first frame
characters    those that the method itself writes, without the shader around them
generate      milliseconds to write the source text
error         the largest angle in degrees to the exact normal, of 2,000 vertices, or pixels for dFdx
h             the step with the smallest error, in units of the mesh`

/** The columns of a row's tables. Each maps a heading → the figure of a record. */
const tables = [
  {
    ms: 'frameMs',
    from: 'frameLowMs',
    to: 'frameHighMs',
    '× positions': 'toPositions',
    '× warpjet': 'toWarpjet',
    '× no warp': 'toNoWarp',
    fps: 'uncappedFps',
    'fps, vsync': 'cappedFps',
  },
  {
    first: 'firstMs',
    'first × positions': 'firstToPositions',
    'first × by hand': 'firstToByHand',
    characters: 'characters',
    'characters × by hand': 'charactersToByHand',
    generate: 'generationMs',
    error: 'errorDegrees',
    h: 'h',
  },
]

/** Returns the tables of a row's records, or of p5's sketches, which have only frames. */
export const rowTables = (records) =>
  tables
    .map((columns) =>
      Object.fromEntries(records.map((record) => [record.method, cellsOf(record, columns)])),
    )
    .filter((table) => Object.keys(table[records[0].method]).length)

const cellsOf = (record, columns) =>
  Object.fromEntries(
    Object.entries(columns)
      .filter(([, figure]) => record[figure] !== undefined)
      .map(([heading, figure]) => [heading, Number(record[figure].toPrecision(4))]),
  )

/** Describes what all records of a row have in common. */
export function describeRow([{ vertices, nodes, clock, jsHeapMb, wasmHeapMb }]) {
  const heap = jsHeapMb
    ? ` · peak heap: ${formatInteger(jsHeapMb)} MB of JavaScript, ${formatInteger(wasmHeapMb)} of WebAssembly`
    : ''
  return `${formatInteger(vertices)} vertices · ${formatInteger(nodes)} nodes · clock: ${clock}${heap}`
}

const findMethod = (records, name) => records.find(({ method }) => method === name) ?? {}
const ours = (records) => findMethod(records, 'warpjet')
/** Returns warpjet's frame time divided by another method's. */
const frameRatio = (records, name) => 1 / findMethod(records, name).toWarpjet

/**
 * The performance aims of warpjet: each figure of warpjet should be at most `max`. Missing an aim is not a failure. `ratio(records)` takes
 * the records of one row and returns undefined or NaN if the aim does not apply.
 */
export const aims = {
  'frame × by hand': { max: 1.03, ratio: (row) => frameRatio(row, 'by hand') },
  'frame × forward': { max: 1, ratio: (row) => frameRatio(row, 'forward differences') },
  'frame × positions': {
    max: 1.5,
    ratio: (row) => (row[0].nodes === 3000 ? ours(row).toPositions : undefined),
  },
  'first × positions': { max: 2, ratio: (row) => ours(row).firstToPositions },
  'first × by hand': { max: 1.15, ratio: (row) => ours(row).firstToByHand },
  'characters × by hand': { max: 1.3, ratio: (row) => ours(row).charactersToByHand },
}

function compareWithAims(records) {
  const cells = Object.entries(aims).map(([name, { max, ratio }]) => {
    const value = ratio(records)
    return [`${name} ≤ ${max}`, value ? `${value.toFixed(3)} ${value <= max ? '✓' : '✗'}` : '–']
  })
  return Object.fromEntries(cells)
}

/** Returns a table that compares each row with the aims. The rows of p5 have none. */
export function aimsTable(records) {
  const rows = new Map()
  for (const record of records.filter(({ toWarpjet }) => toWarpjet))
    rows.set(record.row, [...(rows.get(record.row) ?? []), record])
  return Object.fromEntries([...rows].map(([name, row]) => [name, compareWithAims(row)]))
}
