// Turns measurements into the records of web/bench/records.js, and appends these records as lines to a CSV file (RFC 4180).
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { camelCase, recordsOf } from '../../../web/bench/records.js'
import { Stop } from '../../lib/terminal.mjs'

/** The columns of results.csv. The keys of a record are the same names in camel case. */
export const columns = (
  'date,commit,chromium,renderer,size_px,rounds,clock,row,vertices,nodes,method,h,frame_ms,frame_low_ms,frame_high_ms,' +
  'to_positions,to_warpjet,uncapped_fps,capped_fps,first_ms,first_to_positions,generation_ms,' +
  'error_degrees,error_median_degrees,js_heap_mb,wasm_heap_mb,characters,characters_to_by_hand,first_to_by_hand'
).split(',')

/** Rounds numbers to 5 digits, since further digits are noise. */
const roundFigure = (value) =>
  typeof value !== 'number' || Number.isInteger(value) ? value : Number(value.toPrecision(5))

/** Writes a field, in quotes if it contains a comma, a quote or a line break. */
const quoteField = (value) => {
  const text = String(value ?? '')
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** Returns the line of a record, without a line break. Undefined and null become empty fields. */
export const csvLine = (record) =>
  columns.map((name) => quoteField(roundFigure(record[camelCase(name)]))).join(',')

const readIfExists = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : '')

/**
 * Throws if `file` has different columns or cannot be written; creates it and its folder if they do not exist. Called before the
 * measurements, so that none is lost.
 */
export function checkColumns(file) {
  try {
    mkdirSync(dirname(file), { recursive: true })
    appendFileSync(file, '')
  } catch {
    throw new Stop(`${file} cannot be written: name another file with --out.`)
  }
  const [header] = readIfExists(file).split(/\r?\n/, 1)
  if (header && header !== columns.join(','))
    throw new Stop(
      `${file} has different columns from the benchmark's: name another file with --out.`,
    )
}

/** Appends records. An empty file first gets the header. */
export function appendRecords(file, records) {
  const before = readIfExists(file)
  const lines = [...(before ? [] : [columns.join(',')]), ...records.map(csvLine)]
  const lineEnd = before && !before.endsWith('\n') ? '\n' : ''
  appendFileSync(file, `${lineEnd}${lines.join('\n')}\n`)
}

const withRates = (record, { uncapped, capped }) => ({
  ...record,
  uncappedFps: uncapped[record.method],
  cappedFps: capped[record.method],
})

/**
 * @param run { date, commit, chromium, renderer, sizePx, rounds }: the fields that all lines share
 * @param row { name, nodes }: the workload
 * @param measured the result of measureRow in web/bench/measure.js
 * @param rates { uncapped, capped }, each of which maps a method → frames per second
 */
export const rowRecords = (run, row, measured, rates) =>
  recordsOf(row, measured).map((record) => withRates({ ...run, ...record }, rates))

/** The third parameter is the result of measureP5 in web/bench/p5.js. `toNoWarp` is only printed: the file has no column for it. */
export const p5Records = (run, { name, nodes }, { clock, vertices, results }, rates) =>
  results.map(({ method, toNoWarp, frame }) => {
    const { median: frameMs, low: frameLowMs, high: frameHighMs } = frame
    const figures = { vertices, nodes, method, frameMs, frameLowMs, frameHighMs, toNoWarp }
    return withRates({ ...run, clock, row: name, ...figures }, rates)
  })
