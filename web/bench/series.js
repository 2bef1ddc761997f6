/** Extracts the points of the plots from the records of one run. A point that lacks one of its figures is left out. */
import { MIN_ERROR } from './figures.js'
import { methodNames } from './method-notes.js'

const parseCount = (text) => Number(text.replaceAll(',', ''))

/** Parses the name of a row such as '14,000 × 150'. Returns { vertices, nodes }; undefined for other rows. */
function gridOf(row) {
  const [, vertices, nodes] = /^([\d,]+) × ([\d,]+)$/.exec(row) ?? []
  return vertices && { vertices: parseCount(vertices), nodes: parseCount(nodes) }
}

const isDrawable = ({ x, y }) => Number.isFinite(x) && Number.isFinite(y)

/** Leaves out p5's own records, which the plots do not show. */
const groupByMethod = (records, point) =>
  methodNames.flatMap((method) =>
    records
      .filter((record) => record.method === method)
      .map((record) => ({ method, ...point(record) }))
      .filter(isDrawable)
      .sort((a, b) => a.x - b.x),
  )

const costPoints = (records, x) =>
  groupByMethod(records, (record) => ({
    x: record[x],
    y: record.frameMs,
    low: record.frameLowMs,
    high: record.frameHighMs,
  }))

/** The rows of 14,000 vertices → [{ method, x: nodes, y: milliseconds, low, high }], grouped by method. */
export const costAgainstNodes = (records) =>
  costPoints(
    records.filter(({ row }) => gridOf(row)?.vertices === 14_000),
    'nodes',
  )

/** The rows of 150 nodes → [{ method, x: vertices, y: milliseconds, low, high }], grouped by method. */
export const costAgainstVertices = (records) =>
  costPoints(
    records.filter(({ row }) => gridOf(row)?.nodes === 150),
    'vertices',
  )

/**
 * One row → [{ method, x, y, error }]: `x` is the frame time relative to positions only, `error` the largest error in degrees,
 * and `y` that error clamped to the start of the logarithmic scale.
 */
export const errorAgainstCost = (records, row) =>
  groupByMethod(
    records.filter((record) => record.row === row),
    ({ toPositions, errorDegrees }) => ({
      x: toPositions,
      y: Math.max(MIN_ERROR, errorDegrees),
      error: errorDegrees,
    }),
  )

export const rowsOf = (records) => [...new Set(records.map(({ row }) => row))]
