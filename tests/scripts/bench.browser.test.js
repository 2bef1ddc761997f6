// Tests `npm run bench -- --quick` as a whole: it runs, and its figures are plausible. Does not test how long anything takes.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, describe, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { parseRecords } from '../../web/bench/records.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const folder = mkdtempSync(join(tmpdir(), 'warpjet-'))
after(() => rmSync(folder, { recursive: true }))

/** Runs the benchmark; returns its exit code and its output as { code, text }. */
function bench(...args) {
  const child = spawn(process.execPath, ['.scripts/bench.mjs', ...args], {
    cwd: root,
    stdio: ['ignore', 'pipe', 'pipe'],
  })
  let text = ''
  for (const stream of [child.stdout, child.stderr])
    stream.setEncoding('utf8').on('data', (part) => (text += part))
  return new Promise((ended) => child.on('close', (code) => ended({ code, text })))
}

const rows = ['14,000 × 150', 'airplane twist', 'wobble']
const differences = ['central differences', 'forward differences']
const unwarped = ['no warp', 'by hand']
const methods = ['no warp', 'positions only', 'warpjet', ...differences, 'dFdx', 'by hand']
const sketches = ['p5 1.11.13', 'p5 2.3.4'].flatMap((p5) => [`${p5}, no warp`, `${p5}, warpjet`])

const commonFigures = [
  'sizePx',
  'rounds',
  'vertices',
  'nodes',
  'frameMs',
  'frameLowMs',
  'frameHighMs',
]
const rateFigures = ['uncappedFps', 'cappedFps']
const methodFigures = [
  ...['toPositions', 'toWarpjet', 'firstMs', 'firstToPositions', 'firstToByHand'],
  ...['characters', 'charactersToByHand'],
  ...['errorDegrees', 'errorMedianDegrees', 'jsHeapMb', 'wasmHeapMb'],
]

/** Returns the names of the figures that a record should have. */
function expectedFigures({ method }) {
  if (sketches.includes(method)) return [...commonFigures, ...rateFigures]
  return [
    ...commonFigures,
    ...rateFigures,
    ...methodFigures,
    ...(unwarped.includes(method) ? [] : ['generationMs']),
    ...(differences.includes(method) ? ['h'] : []),
  ]
}

describe('npm run bench -- --quick', () => {
  const file = join(folder, 'results.csv')
  let code, text, records
  before(async () => {
    ;({ code, text } = await bench('--quick', '--out', file))
    records = existsSync(file) ? parseRecords(readFileSync(file, 'utf8')) : []
  })

  test('exits with 0', () => assert.equal(code, 0, text))

  test('measures every method in every row, and the sketches on p5', () => {
    const expected = rows.flatMap((row) => methods.map((method) => `${row}: ${method}`))
    expected.push(...sketches.map((method) => `${rows[0]}: ${method}`))
    assert.deepEqual(
      records.map(({ row, method }) => `${row}: ${method}`),
      expected,
    )
  })

  test('has exactly the figures that each method can have', () => {
    for (const record of records) {
      const numbers = Object.entries(record).filter(([, value]) => typeof value === 'number')
      const names = numbers.map(([name]) => name)
      const about = `${record.row}, ${record.method}`
      assert.deepEqual(names.sort(), expectedFigures(record).sort(), about)
      for (const [name, value] of numbers)
        assert.ok(Number.isFinite(value) && value > 0, `${about}: ${name} is ${value}`)
    }
  })

  test('has medians between the quartiles', () => {
    for (const { row, method, frameLowMs, frameMs, frameHighMs } of records)
      assert.ok(frameLowMs <= frameMs && frameMs <= frameHighMs, `${row}, ${method}`)
  })

  test('has the ratio 1 where a method is compared with itself', () => {
    for (const { method, toPositions, toWarpjet, firstToPositions } of records) {
      if (method === 'positions only') assert.deepEqual([toPositions, firstToPositions], [1, 1])
      if (method === 'warpjet') assert.equal(toWarpjet, 1)
    }
  })

  test('measures a small error of the normals of warpjet, and a large one of unchanged normals', () => {
    for (const row of rows) {
      const errorOf = (name) =>
        records.find((record) => record.row === row && record.method === name).errorDegrees
      assert.ok(errorOf('warpjet') < 0.05, `${row}: ${errorOf('warpjet')}°`)
      assert.ok(errorOf('no warp') > 1, `${row}: ${errorOf('no warp')}°`)
    }
  })

  test('records the date, commit, browser and device in all lines', () => {
    const sources = new Set(
      records.map(({ date, commit, chromium, renderer }) =>
        JSON.stringify([date, commit, chromium, renderer]),
      ),
    )
    assert.equal(sources.size, 1)
    const [{ date, commit, chromium, renderer }] = records
    assert.match(date, /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$/)
    assert.match(commit ?? '', /^([0-9a-f]{7,}(-dirty)?)?$/)
    assert.match(chromium, /^\d+(\.\d+)+$/)
    assert.ok(renderer)
    for (const { clock } of records) assert.match(clock, /^(timer query|readback fence)$/)
  })

  test('prints tables for each row, and one for the goals', () => {
    for (const name of [...rows, 'p5', 'Goals'])
      assert.match(text, new RegExp(`^▸ ${name}`, 'm'), text)
    for (const method of [...methods, ...sketches])
      assert.match(text, new RegExp(`^│ +${method} +│ +[\\d.]+ `, 'm'), text)
    for (const row of rows)
      assert.match(text, new RegExp(`^│ +${row} +│ +'[\\d.]+ [✓✗]'`, 'm'), text)
  })
})

test('prints its usage and the rows with --help', async () => {
  const { code, text } = await bench('--help')
  assert.equal(code, 0)
  assert.match(text, /^Usage: npm run bench -- \[options\]/)
  for (const row of [...rows, '2,000,000 × 150', 'p5']) assert.ok(text.includes(row), row)
})

test('rejects unknown options and rows with one message', async () => {
  const unknown = await bench('--fast')
  assert.deepEqual(unknown, {
    code: 1,
    text: "✗ Unknown option '--fast'. --help lists the options.\n",
  })
  const { code, text } = await bench('--row', 'cube')
  assert.equal(code, 1)
  assert.match(
    text,
    /^✗ Expected the name of a row, got 'cube': choose from 14,000 × 150; .*; p5\.\n$/,
  )
})
