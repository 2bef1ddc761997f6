// Turns measurements into the records of web/bench/records.js, and appends them as lines to a CSV file (RFC 4180).
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { camelCase, recordsOf } from '../../../web/bench/records.js'
import { Stop } from '../../lib/terminal.mjs'

/** The columns of results.csv. A record has the same names in camel case. */
export const columns = (
  'date,commit,chromium,renderer,size_px,rounds,clock,row,vertices,nodes,method,h,frame_ms,frame_low_ms,frame_high_ms,' +
  'to_positions,to_warpjet,uncapped_fps,capped_fps,first_ms,first_to_positions,generation_ms,' +
  'error_degrees,error_median_degrees,js_heap_mb,wasm_heap_mb,characters,characters_to_by_hand,first_to_by_hand'
).split(',')

/** Rounds to 5 digits: more are noise. */
const round = (value) =>
  typeof value !== 'number' || Number.isInteger(value) ? value : Number(value.toPrecision(5))

const field = (value) => {
  const text = String(value ?? '')
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** Returns one line, without a line break. Undefined and null become empty fields. */
export const csvLine = (record) =>
  columns.map((name) => field(round(record[camelCase(name)]))).join(',')

const contentOf = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : '')

/** Throws if `file` has other columns or cannot be written: called first, so that no long measurement is lost. */
export function checkColumns(file) {
  try {
    mkdirSync(dirname(file), { recursive: true })
    appendFileSync(file, '')
  } catch {
    throw new Stop(`${file} cannot be written: name another file with --out.`)
  }
  const [header] = contentOf(file).split(/\r?\n/, 1)
  if (header && header !== columns.join(','))
    throw new Stop(`${file} has other columns than the benchmark: name another file with --out.`)
}

/** Appends records. A new file starts with the header. */
export function appendRecords(file, records) {
  const before = contentOf(file)
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
 * @param row { name, nodes }
 * @param measured the result of measureRow in web/bench/measure.js
 * @param rates { uncapped, capped }, each of which maps a method → frames per second
 */
export const rowRecords = (run, row, measured, rates) =>
  recordsOf(row, measured).map((record) => withRates({ ...run, ...record }, rates))

/** @param measured the result of measureP5 in web/bench/p5.js */
export const p5Records = (run, { name, nodes }, { clock, vertices, results }, rates) =>
  results.map(({ method, toNoWarp, frame }) => {
    const { median: frameMs, low: frameLowMs, high: frameHighMs } = frame
    const figures = { vertices, nodes, method, frameMs, frameLowMs, frameHighMs, toNoWarp }
    return withRates({ ...run, clock, row: name, ...figures }, rates)
  })
