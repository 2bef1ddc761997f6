/** What the plots show, out of the records of one run. A point without both of its figures is left out. */
import { LEAST_ERROR } from './figures.js'
import { methodNames } from './method-notes.js'

const number = (text) => Number(text.replaceAll(',', ''))

/** Rows such as '14,000 × 150' → { vertices, nodes } as the name has them; undefined for other rows. */
function gridOf(row) {
  const [, vertices, nodes] = /^([\d,]+) × ([\d,]+)$/.exec(row) ?? []
  return vertices && { vertices: number(vertices), nodes: number(nodes) }
}

const isDrawable = ({ x, y }) => Number.isFinite(x) && Number.isFinite(y)

/** p5's own lines among the records have no place on the plots. */
const byMethod = (records, point) =>
  methodNames.flatMap((method) =>
    records
      .filter((record) => record.method === method)
      .map((record) => ({ method, ...point(record) }))
      .filter(isDrawable)
      .sort((a, b) => a.x - b.x),
  )

const cost = (records, x) =>
  byMethod(records, (record) => ({
    x: record[x],
    y: record.frameMs,
    low: record.frameLowMs,
    high: record.frameHighMs,
  }))

/** The rows of 14,000 vertices → [{ method, x: nodes, y: milliseconds, low, high }], method by method. */
export const costAgainstNodes = (records) =>
  cost(
    records.filter(({ row }) => gridOf(row)?.vertices === 14_000),
    'nodes',
  )

/** The rows of 150 nodes → [{ method, x: vertices, y: milliseconds, low, high }], method by method. */
export const costAgainstVertices = (records) =>
  cost(
    records.filter(({ row }) => gridOf(row)?.nodes === 150),
    'vertices',
  )

/**
 * One row → [{ method, x, y, error }]: x is the frame relative to positions only, y the largest error in degrees, no less than
 * what a logarithmic scale begins with, and `error` that error as it was.
 */
export const errorAgainstCost = (records, row) =>
  byMethod(
    records.filter((record) => record.row === row),
    ({ toPositions, errorDegrees }) => ({
      x: toPositions,
      y: Math.max(LEAST_ERROR, errorDegrees),
      error: errorDegrees,
    }),
  )

export const rowsOf = (records) => [...new Set(records.map(({ row }) => row))]
