// Tests the benchmark without a browser: its command line, statistics, lines of results.csv and tables.
import assert from 'node:assert/strict'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, describe, test } from 'node:test'
import { readOptions } from '../../.scripts/bench/frames/options.mjs'
import {
  appendRecords,
  checkColumns,
  columns,
  csvLine,
  p5Records,
  rowRecords,
} from '../../.scripts/bench/frames/records.mjs'
import { createGoalsTable, rowTables } from '../../.scripts/bench/frames/report.mjs'
import { medianRatio, quantile, shuffle, summarize } from '../../web/bench/statistics.js'

describe('statistics', () => {
  test('summarize returns the median and the quartiles', () => {
    assert.deepEqual(summarize([9, 1, 5, 3, 7]), { median: 5, low: 3, high: 7 })
    assert.deepEqual(summarize([4]), { median: 4, low: 4, high: 4 })
  })

  test('quantile ignores values that could not be measured', () => {
    assert.equal(quantile([NaN, 3, Infinity, 1, 2]), 2)
    assert.equal(quantile([1, 2, 4, 8]), 3)
    assert.equal(quantile([1, 2, 4, 8], 0.25), 1.75)
    assert.equal(quantile([NaN]), NaN)
  })

  test('medianRatio is not affected by a round that was slow for all methods', () => {
    assert.equal(medianRatio([2, 20, 2.2], [1, 10, 1]), 2)
    assert.equal(medianRatio([1, 2], undefined), NaN)
  })

  test('shuffle returns a new list with the same elements', () => {
    const list = [1, 2, 3, 4]
    assert.deepEqual(shuffle(list).sort(), list)
    assert.notEqual(shuffle(list), list)
  })
})

describe('the command line', () => {
  const rows = ['14,000 × 150', '14,000 × 1,500', 'airplane twist', 'wobble']
  const readArguments = (...args) => readOptions(args, [...rows, 'p5'])

  test('selects every row by default, p5 last', () => {
    assert.deepEqual(readArguments().rows, [...rows, 'p5'])
    assert.equal(readArguments().settings.rounds, 11)
    assert.match(readArguments().file, /web\/bench\/results\.csv$/)
  })

  test('finds a row by its name, also with x for ×, without spaces and commas, and in lower case', () => {
    assert.deepEqual(readArguments('--row', '14,000 × 150').rows, ['14,000 × 150'])
    assert.deepEqual(readArguments('--row', '14000x150').rows, ['14,000 × 150'])
    assert.deepEqual(readArguments('--row', 'P5', '--row', 'Airplane Twist').rows, [
      'airplane twist',
      'p5',
    ])
  })

  test('selects a few rows with --quick, unless others are named', () => {
    assert.deepEqual(readArguments('--quick').rows, [
      '14,000 × 150',
      'airplane twist',
      'wobble',
      'p5',
    ])
    assert.deepEqual(readArguments('--quick', '--row', 'wobble').rows, ['wobble'])
    assert.equal(readArguments('--quick').file, undefined)
    assert.equal(readArguments('--quick', '--rounds', '2').settings.rounds, 2)
  })

  const rejected = {
    'an unknown row': [
      ['--row', 'cube'],
      "Expected the name of a row, got 'cube': choose from 14,000 × 150; 14,000 × 1,500; airplane twist; wobble; p5.",
    ],
    'zero rounds': [
      ['--rounds', '0'],
      'Expected --rounds to be a whole number of at least 1, got 0.',
    ],
    'a fractional number of rounds': [
      ['--rounds', '2.5'],
      'Expected --rounds to be a whole number of at least 1, got 2.5.',
    ],
  }
  for (const [name, [args, message]] of Object.entries(rejected))
    test(`rejects ${name}`, () => assert.throws(() => readArguments(...args), { message }))
})

const run = {
  date: '2026-01-02T03:04:05Z',
  commit: 'abc',
  chromium: '1.2',
  renderer: 'A (B, C)',
  sizePx: 300,
  rounds: 3,
}
const result = (method, toWarpjet, more) => ({
  method,
  frame: { median: 12.3456789, low: 12, high: 13 },
  toPositions: 1.02,
  toWarpjet,
  first: { median: 60, low: 50, high: 70 },
  firstToPositions: 1.5,
  firstToByHand: 1.1,
  characters: 1234,
  charactersToByHand: 1.25,
  generation: null,
  error: { largest: 0.0001234567, median: 0.00005 },
  ...more,
})
const measured = {
  clock: 'timer query',
  vertices: 14042,
  memory: { heap: 2 ** 21, wasm: 2 ** 20 },
  results: [
    result('warpjet', 1, { generation: 0.25 }),
    result('forward differences', 0.8, { error: { largest: 2, median: 1, h: 0.1 } }),
    result('by hand', 1),
  ],
}
const rates = {
  uncapped: { warpjet: 80.5, 'by hand': 81, 'p5 2.3.4, no warp': 5 },
  capped: { warpjet: 60, 'by hand': 60, 'p5 2.3.4, no warp': 4 },
}
const rowOf3000Nodes = { name: '14,000 × 3,000', nodes: 3000 }

describe('results.csv', () => {
  const folder = mkdtempSync(join(tmpdir(), 'warpjet-'))
  const file = join(folder, 'deep', 'table.csv')
  const head = columns.join(',')
  after(() => rmSync(folder, { recursive: true }))

  test('quotes only fields with commas, quotes or line breaks', () => {
    const record = { date: 'a b', commit: 'x, y', chromium: 'a "b"', renderer: 'c\nd', sizePx: 1.5 }
    assert.match(csvLine({ ...record, row: null }), /^a b,"x, y","a ""b""","c\nd",1\.5,,,,,/)
  })

  test('begins with a header, and new lines are appended', () => {
    checkColumns(file)
    appendRecords(file, [{ method: 'a' }])
    appendRecords(file, [{ method: 'b' }, { method: 'c' }])
    const lines = readFileSync(file, 'utf8').split('\n')
    assert.equal(lines[0], head)
    assert.deepEqual(
      lines.map((line) => line.replaceAll(',', '')),
      [head.replaceAll(',', ''), 'a', 'b', 'c', ''],
    )
  })

  test('gets a missing line break at its end before lines are appended', () => {
    const other = join(folder, 'other.csv')
    writeFileSync(other, 'a\n1')
    appendRecords(other, [{ date: 2 }])
    assert.match(readFileSync(other, 'utf8'), /^a\n1\n2,+\n$/)
  })

  test('is rejected if it has different columns', () => {
    const other = join(folder, 'columns.csv')
    writeFileSync(other, 'a,c\n')
    assert.throws(() => checkColumns(other), {
      message: `${other} has different columns from the benchmark's: name another file with --out.`,
    })
  })

  test('is rejected if it cannot be written', () => {
    assert.throws(() => checkColumns(folder), {
      message: `${folder} cannot be written: name another file with --out.`,
    })
  })

  test('has a line for each method of a row', () => {
    const [line, ...others] = rowRecords(run, rowOf3000Nodes, measured, rates).map(csvLine)
    assert.equal(others.length, 2)
    assert.equal(
      columns.join(','),
      'date,commit,chromium,renderer,size_px,rounds,clock,row,vertices,nodes,method,h,frame_ms,frame_low_ms,frame_high_ms,to_positions,to_warpjet,uncapped_fps,capped_fps,first_ms,first_to_positions,generation_ms,error_degrees,error_median_degrees,js_heap_mb,wasm_heap_mb,characters,characters_to_by_hand,first_to_by_hand',
    )
    assert.equal(
      line,
      '2026-01-02T03:04:05Z,abc,1.2,"A (B, C)",300,3,timer query,"14,000 × 3,000",14042,3000,warpjet,,12.346,12,13,1.02,1,80.5,60,60,1.5,0.25,0.00012346,0.00005,2,1,1234,1.25,1.1',
    )
  })

  test('has a line for each p5 sketch, with the figures that exist', () => {
    const results = [{ method: 'p5 2.3.4, no warp', frame: { median: 100, low: 90, high: 110 } }]
    const p5 = { clock: 'readback fence', vertices: 14042, results }
    assert.deepEqual(p5Records(run, rowOf3000Nodes, p5, rates).map(csvLine), [
      '2026-01-02T03:04:05Z,abc,1.2,"A (B, C)",300,3,readback fence,"14,000 × 3,000",14042,3000,"p5 2.3.4, no warp",,100,90,110,,,5,4,,,,,,,,,,',
    ])
  })
})

describe('the tables of a row', () => {
  test('have the figures that exist, with four digits', () => {
    const [frames, others] = rowTables(rowRecords(run, rowOf3000Nodes, measured, rates))
    assert.deepEqual(frames['by hand'], {
      ...{ ms: 12.35, from: 12, to: 13, '× positions': 1.02, '× warpjet': 1 },
      ...{ fps: 81, 'fps, vsync': 60 },
    })
    assert.equal(others['forward differences'].h, 0.1)
    assert.equal('h' in others.warpjet, false)
  })

  test('are only one if only frames were measured', () => {
    const p5 = { method: 'p5 2.3.4, no warp', frameMs: 100, toNoWarp: 1 }
    assert.deepEqual(rowTables([p5]), [{ [p5.method]: { ms: 100, '× no warp': 1 } }])
  })
})

describe('the goals', () => {
  const compare = (row, results = measured.results) =>
    createGoalsTable(rowRecords(run, row, { ...measured, results }, rates))[row.name]

  test('are ratios of warpjet to the other methods', () => {
    assert.deepEqual(compare(rowOf3000Nodes), {
      'frame × by hand ≤ 1.03': '1.000 ✓',
      'frame × forward ≤ 1': '1.250 ✗',
      'frame × positions ≤ 1.5': '1.020 ✓',
      'first × positions ≤ 2': '1.500 ✓',
      'first × by hand ≤ 1.15': '1.100 ✓',
      'characters × by hand ≤ 1.3': '1.250 ✓',
    })
  })

  test('are dashes if there is nothing to compare with', () => {
    const cells = compare({ name: 'nested', nodes: 216 }, measured.results.slice(0, 2))
    assert.equal(cells['frame × by hand ≤ 1.03'], '–')
    assert.equal(cells['frame × positions ≤ 1.5'], '–')
  })

  test('are left out if only p5 was measured', () => {
    assert.deepEqual(
      createGoalsTable([{ method: 'p5 2.3.4, no warp', row: rowOf3000Nodes.name }]),
      {},
    )
  })
})
