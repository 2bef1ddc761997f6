// The tables for the terminal: two for each workload (a row of the benchmark), and one that compares all workloads with the goals.
import { formatInteger } from '../../../web/bench/figures.js'

/** Explains the columns, once for all tables. */
export const legend = `
ms, from, to  milliseconds of a frame until the GPU is done: the median, and the range of the middle half of all frames
×             the same figure divided by that of another method: the median of the quotients within each round
fps           frames per second in the page, with its own work: without a limit, and with vsync
first         milliseconds from the source to the first frame
characters    the number of characters that the method itself writes, without the shader around them
generate      milliseconds to generate the source
error         the largest angle in degrees to the exact normal, at 2,000 vertices (for dFdx, at pixels)
h             the step with the smallest error, in units of the mesh`

/** The tables of a workload. Each maps the heading of a column → the key of a record's figure. */
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

/** Returns the tables of a workload's records. Records of p5's sketches have figures for the first table only. */
export const rowTables = (records) =>
  tables
    .map((columns) =>
      Object.fromEntries(records.map((record) => [record.method, createCells(record, columns)])),
    )
    .filter((table) => Object.keys(table[records[0].method]).length)

const createCells = (record, columns) =>
  Object.fromEntries(
    Object.entries(columns)
      .filter(([, key]) => record[key] !== undefined)
      .map(([heading, key]) => [heading, Number(record[key].toPrecision(4))]),
  )

/** Describes what all records of a workload have in common. */
export function describeRow([{ vertices, nodes, clock, jsHeapMb, wasmHeapMb }]) {
  const heap = jsHeapMb
    ? ` · peak heap: ${formatInteger(jsHeapMb)} MB of JavaScript, ${formatInteger(wasmHeapMb)} of WebAssembly`
    : ''
  return `${formatInteger(vertices)} vertices · ${formatInteger(nodes)} nodes · clock: ${clock}${heap}`
}

const findMethod = (records, name) => records.find(({ method }) => method === name) ?? {}
const findWarpjet = (records) => findMethod(records, 'warpjet')
/** Returns the frame time of warpjet divided by that of the method `name`. */
const frameRatio = (records, name) => 1 / findMethod(records, name).toWarpjet

/**
 * The performance goals of warpjet: each ratio of a figure of warpjet to that of another method should be at most `max`. Missing a goal is not
 * a failure. `ratio(records)` takes the records of a workload, and returns undefined or NaN if the goal does not apply.
 */
export const goals = {
  'frame × by hand': { max: 1.03, ratio: (records) => frameRatio(records, 'by hand') },
  'frame × forward': { max: 1, ratio: (records) => frameRatio(records, 'forward differences') },
  'frame × positions': {
    max: 1.5,
    ratio: (records) => (records[0].nodes === 3000 ? findWarpjet(records).toPositions : undefined),
  },
  'first × positions': { max: 2, ratio: (records) => findWarpjet(records).firstToPositions },
  'first × by hand': { max: 1.15, ratio: (records) => findWarpjet(records).firstToByHand },
  'characters × by hand': { max: 1.3, ratio: (records) => findWarpjet(records).charactersToByHand },
}

function compareWithGoals(records) {
  const cells = Object.entries(goals).map(([name, { max, ratio }]) => {
    const value = ratio(records)
    return [`${name} ≤ ${max}`, value ? `${value.toFixed(3)} ${value <= max ? '✓' : '✗'}` : '–']
  })
  return Object.fromEntries(cells)
}

/** Returns a table that compares each workload with the goals. The goals do not apply to p5's sketches. */
export function createGoalsTable(records) {
  const rows = new Map()
  for (const record of records.filter(({ toWarpjet }) => toWarpjet))
    rows.set(record.row, [...(rows.get(record.row) ?? []), record])
  return Object.fromEntries([...rows].map(([name, row]) => [name, compareWithGoals(row)]))
}
