// Turns measurements into the records of web/bench/records.js and lines of results.csv.
import { camelCase, recordsOf } from '../../web/bench/records.js'

/** The columns of results.csv. A record has the same names in camel case. */
export const columns = (
  'date,commit,chromium,renderer,size_px,rounds,clock,row,vertices,nodes,method,h,frame_ms,frame_low_ms,frame_high_ms,' +
  'to_positions,to_warpjet,uncapped_fps,capped_fps,first_ms,first_to_positions,generation_ms,' +
  'error_degrees,error_median_degrees,js_heap_mb,wasm_heap_mb,characters,characters_to_by_hand,first_to_by_hand'
).split(',')

/** More digits than this are noise. */
const DIGITS = 5

function round(value) {
  if (typeof value !== 'number' || Number.isInteger(value)) return value
  return Number(value.toPrecision(DIGITS))
}

/** Returns the fields of a record, in the order of `columns`. */
export const fieldsOf = (record) => columns.map((name) => round(record[camelCase(name)]))

const withRates = (record, { uncapped, capped }) => ({
  ...record,
  uncappedFps: uncapped[record.method],
  cappedFps: capped[record.method],
})

/**
 * @param run { date, commit, chromium, renderer, sizePx, rounds }, which all lines have
 * @param row { name, nodes }
 * @param measured the result of measureRow in web/bench/measure.js
 * @param rates { uncapped, capped }, frames a second by method
 */
export const rowRecords = (run, row, measured, rates) =>
  recordsOf(row, measured).map((record) => withRates({ ...run, ...record }, rates))

/** @param measured the result of measureP5 in web/bench/p5.js */
export const p5Records = (run, { name, nodes }, { clock, vertices, results }, rates) =>
  results.map(({ method, frame }) => {
    const [frameMs, frameLowMs, frameHighMs] = [frame.median, frame.low, frame.high]
    const figures = { clock, row: name, vertices, nodes, method, frameMs, frameLowMs, frameHighMs }
    return withRates({ ...run, ...figures }, rates)
  })
