// Tests the page of the benchmark's results, for given records: its plots and its table.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { placeBeside, spread } from '../../web/bench/labels.js'
import { methods } from '../../web/bench/methods.js'
import { deviceOf, parseRecords, runsOf } from '../../web/bench/records.js'
import { costAgainstNodes, costAgainstVertices, errorAgainstCost } from '../../web/bench/series.js'
import { cells, desktop, path, phone, timeoutOptions } from '../support/browser/bench.js'
import { launchBrowser, openPage } from '../support/browser/browser.js'
import { serveSources } from '../support/browser/site.js'

const names = methods.map(({ name }) => name)

const header =
  'date,commit,chromium,renderer,clock,row,vertices,nodes,method,h,frame_ms,frame_low_ms,frame_high_ms,to_positions,to_warpjet,uncapped_fps,capped_fps,first_ms,first_to_positions,generation_ms,error_degrees,error_median_degrees,js_heap_mb,wasm_heap_mb'

const software =
  '"ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)"'
const graphicsCard = '"ANGLE (NVIDIA, Vulkan 1.3.277 (NVIDIA H200 (0x00002335)), NVIDIA-550.54.15)"'

const olderLines = [
  `2026-03-01T10:00:00Z,aaa,139.0,${graphicsCard},timer query,"14,000 × 1,500",14042,1500,warpjet,,0.5,0.4,0.6,1.1,1,2000,60,30,1.2,4,0.0001,0.00005,80,2`,
]

const runFields = `2026-03-02T10:00:00Z,bbb,140.1,${software}`
const rowsOfRun = [
  '"14,000 × 150",14042,150',
  '"14,000 × 3,000",14042,3000',
  '"500,000 × 150",499849,150',
]
/**
 * Figures of each method, as close to each other as measured ones: method, h, frame, quartiles, ratios to positions and to warpjet, …,
 * errors.
 */
const figures = [
  'no warp,,7,6,8,0.7,0.5,143,60,20,0.5,,80,5',
  'positions only,,10,9,11,1,0.7,100,60,40,1,0.2,80,5',
  'warpjet,,10.4,10,11,1.04,1,96,60,45,1.1,0.3,0.0001,0.00005',
  'central differences,0.1,22,20,23,2.2,2.1,45,45,60,1.5,0.2,0.02,0.01',
  'forward differences,0.01,18,17,19,1.8,1.7,55,55,50,1.3,0.2,0.05,0.02',
  'dFdx,,10.1,9,11,1.01,0.98,99,60,40,1,0.2,70,4',
  'by hand,,10.3,10,11,1.03,0.99,97,60,45,1.1,,0,0',
]
const newerLines = [
  ...rowsOfRun.flatMap((row) =>
    figures.map((line) => `${runFields},timer query,${row},${line},90,2`),
  ),
  `${runFields},readback fence,"14,000 × 150",14042,150,"p5 1.11.13, no warp",,25,,,,,,,,,,,,,`,
  `${runFields},readback fence,"14,000 × 150",14042,150,"p5 1.11.13, warpjet",,30,,,,,,,,,,,,,`,
].map((line) =>
  // Removes a figure, as if it could not be measured.
  line.includes('500,000 × 150",499849,150,forward')
    ? line.replace(',18,17,19,1.8,', ',,,,,')
    : line,
)

describe('records of results.csv', () => {
  test('contain numbers, strings with commas and quotes, and undefined for empty fields', () => {
    const csv = 'date,row,method,frame_ms,h\r\n2026,"14,000 × 150","so-called ""p5""",1.5e-3,\r\n'
    assert.deepEqual(parseRecords(csv), [
      {
        date: '2026',
        row: '14,000 × 150',
        method: 'so-called "p5"',
        frameMs: 0.0015,
        h: undefined,
      },
    ])
  })

  test('are empty if the file has no lines', () => {
    assert.deepEqual(parseRecords(''), [])
    assert.deepEqual(parseRecords('date,row\n'), [])
  })

  test('are grouped into runs, the newest first', () => {
    const runs = runsOf([{ date: '2026-01' }, { date: '2026-03' }, { date: '2026-01' }])
    assert.deepEqual(
      runs.map(({ date, records }) => [date, records.length]),
      [
        ['2026-03', 1],
        ['2026-01', 2],
      ],
    )
  })

  for (const [renderer, device] of [
    [
      'ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 (0x00002504) Direct3D11 vs_5_0 ps_5_0, D3D11)',
      'NVIDIA GeForce RTX 3060',
    ],
    ['ANGLE (NVIDIA, Vulkan 1.3.277 (NVIDIA H200 (0x00002335)), NVIDIA-550.54.15)', 'NVIDIA H200'],
    ['ANGLE (Apple, ANGLE Metal Renderer: Apple M1, Unspecified Version)', 'Apple M1'],
    ['Mali-G78', 'Mali-G78'],
  ])
    test(`name the device ${device}`, () => assert.equal(deviceOf(renderer), device))
})

describe('points of the plots', () => {
  const record = { row: '14,000 × 150', vertices: 14042, nodes: 150, method: 'warpjet', frameMs: 3 }

  test('are sorted, and include only existing figures of the rows that belong to the plot', () => {
    const records = [
      { ...record, row: '14,000 × 3,000', nodes: 3000, frameMs: 9 },
      record,
      { ...record, row: '14,000 × 1,500', nodes: 1500, frameMs: undefined },
      { ...record, row: '2,000,000 × 150', vertices: 1999396, frameMs: 40, frameLowMs: 39 },
      { ...record, row: 'wobble', nodes: 75 },
      { ...record, method: 'p5 2.3.4, warpjet' },
    ]
    const point = { method: 'warpjet', low: undefined, high: undefined }
    assert.deepEqual(costAgainstNodes(records), [
      { ...point, x: 150, y: 3 },
      { ...point, x: 3000, y: 9 },
    ])
    assert.deepEqual(costAgainstVertices(records), [
      { ...point, x: 14042, y: 3 },
      { ...point, x: 1999396, y: 40, low: 39 },
    ])
  })

  test('include an error of 0 at the end of the scale, and omit NaN', () => {
    const records = [
      { ...record, method: 'by hand', toPositions: 1.1, errorDegrees: 0 },
      { ...record, method: 'warpjet', toPositions: 1.2, errorDegrees: 0.5 },
      { ...record, method: 'dFdx', toPositions: 1, errorDegrees: NaN },
      { ...record, method: 'no warp', toPositions: undefined, errorDegrees: 3 },
    ]
    assert.deepEqual(errorAgainstCost(records, record.row), [
      { method: 'warpjet', x: 1.2, y: 0.5, error: 0.5 },
      { method: 'by hand', x: 1.1, y: 1e-5, error: 0 },
    ])
  })
})

describe('labels of the plots', () => {
  test('are moved apart no more than necessary, and keep their order', () => {
    assert.deepEqual(spread([10, 50, 52], 16, [0, 100]), [10, 43, 59])
    assert.deepEqual(spread([52, 10, 50], 16, [0, 100]), [59, 10, 43])
    assert.deepEqual(spread([98, 99], 16, [0, 100]), [84, 100])
    assert.deepEqual(spread([1, 2, 3], 16, [0, 100]), [0, 16, 32])
  })

  test('do not overlap if their dots coincide', () => {
    const size = { width: 60, height: 16 }
    const frame = { left: 0, right: 300, top: 0, bottom: 200 }
    const [first, second] = placeBeside(Array(2).fill({ x: 150, y: 100, ...size }), frame)
    assert.deepEqual(first, { x: 191, y: 100, isFar: false })
    assert.deepEqual(second, { x: 109, y: 100, isFar: false })
    const [atEdge] = placeBeside([{ x: 290, y: 100, ...size }], frame)
    assert.deepEqual(atEdge, { x: 249, y: 100, isFar: false })
  })
})

describe('the results page', () => {
  let browser, server
  before(async () => {
    browser = await launchBrowser()
    server = await serveSources(5230)
  })
  after(async () => {
    await browser.close()
    await server.close()
  })

  async function openResults(options, csv) {
    const context = await browser.newContext(options)
    await context.route('**/results.csv*', (route) =>
      route.fulfill({
        contentType: 'text/javascript',
        body: `export default ${JSON.stringify(csv)}`,
      }),
    )
    return openPage(context, `${server.resolvedUrls.local[0]}bench/results.html`)
  }
  const countDots = (page, plot) => page.locator(`.${plot} svg g[aria-label="dot"] > *`).count()

  describe('with two runs', () => {
    let page, messages
    before(async () => {
      const csv = [header, ...olderLines, ...newerLines].join('\n')
      ;({ page, messages } = await openResults(desktop, csv))
      await page.locator('.error svg').waitFor(timeoutOptions)
    })
    after(() => page.context().close())

    test('shows the newest run first, with its device and clock', async () => {
      const text = await page.locator('.run p').textContent()
      assert.match(
        text,
        /^Drawn by SwiftShader on 2 March 2026 at 10:00 UTC, in Chromium 140\.1, at /,
      )
      assert.match(
        text,
        /at commit bbb; frames timed by timer query and readback fence\. SwiftShader draws without/,
      )
      assert.deepEqual(await page.locator('option').allTextContents(), [
        '2 Mar 2026, 10:00 · bbb · SwiftShader',
        '1 Mar 2026, 10:00 · aaa · NVIDIA H200',
      ])
    })

    test('has a dot for every existing figure', async () => {
      // Seven methods, each in two rows; one of these has no frame time.
      assert.equal(await countDots(page, 'nodes'), 14)
      assert.equal(await countDots(page, 'vertices'), 13)
      assert.equal(await countDots(page, 'error'), 7)
      await page.getByRole('button', { name: '500,000 × 150' }).click()
      assert.equal(await countDots(page, 'error'), 6)
    })

    test('has a line and a label for every method', async () => {
      for (const plot of ['nodes', 'vertices']) {
        assert.equal(await page.locator(`.${plot} svg g[aria-label="line"] path`).count(), 7)
        const text = await page.locator(`.${plot} svg g[aria-label="text"] text`).allTextContents()
        assert.deepEqual(text.sort(), [...names].sort())
      }
    })

    test('labels an error of 0 as at most the smallest value of the scale', async () => {
      await page.locator('.error svg').getByText('≤ 0.00001°').waitFor()
      const bottom = await page.locator('.error svg').getByText('≤ 0.00001°').boundingBox()
      const dot = await page.locator('.error svg circle[fill="#ffdc7a"]').boundingBox()
      const middle = ({ y, height }) => y + height / 2
      assert.ok(Math.abs(middle(bottom) - middle(dot)) < 3)
    })

    test('lists all figures in the table, with dashes for missing ones', async () => {
      const lines = await cells(page.locator('.wide table'))
      assert.equal(lines.length, newerLines.length)
      assert.equal(
        lines[0].join(' '),
        'no warp 7.00 6.00 8.00 0.70 0.50 143 60.0 20.0 0.50 – 80.0 5.00 –',
      )
      assert.equal(lines[8].join(' '), 'p5 1.11.13 warpjet 30.0 – – – – – – – – – – – –')
    })

    test('states the frame time of a whole sketch with and without the warp', async () => {
      await page
        .getByText(
          'A whole p5 sketch takes 30.0 ms a frame with p5 1.11.13 (25.0 ms without the warp).',
        )
        .waitFor()
    })

    test('shows the figures of another run when it is selected', async () => {
      await page.getByLabel('Run').selectOption('2026-03-01T10:00:00Z')
      await page.locator('.run p').getByText('NVIDIA H200').waitFor()
      assert.equal(await countDots(page, 'nodes'), 1)
      await page.locator('.vertices').getByText('This run has no figures for this plot.').waitFor()
    })

    test('logs nothing', () => assert.deepEqual(messages, []))
  })

  test('fits a phone screen, and its labels do not overlap', async () => {
    const { page, messages } = await openResults(phone, [header, ...newerLines].join('\n'))
    await page.locator('.error svg').waitFor(timeoutOptions)
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360)
    for (const plot of ['nodes', 'vertices', 'error']) {
      // On a phone, names next to the lines would leave too little space for the plot, so there is a legend.
      const labels =
        plot === 'error' ? '.error svg g[aria-label="text"] text' : `.${plot} .legend li`
      const boxes = await page
        .locator(labels)
        .evaluateAll((texts) => texts.map((text) => text.getBoundingClientRect().toJSON()))
      assert.equal(boxes.length, 7)
      for (const [i, a] of boxes.entries()) {
        assert.ok(a.left >= 0 && a.right <= 360, `label ${i} of ${plot} is outside the page`)
        for (const b of boxes.slice(i + 1)) {
          // Boxes may overlap by 4 pixels: a line of text has some space above and below its letters.
          const across = Math.min(a.right, b.right) - Math.max(a.left, b.left)
          const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)
          assert.ok(across <= 0 || down <= 4, `labels overlap in ${plot}`)
        }
      }
    }
    for (const plot of ['nodes', 'vertices']) {
      const { width } = await page.locator(`.${plot} g[aria-label="line"]`).boundingBox()
      assert.ok(width > 230, `the lines of ${plot} are ${width} wide`)
    }
    mkdirSync(path('.build/screenshots'), { recursive: true })
    await page.screenshot({ path: path('.build/screenshots/results-phone.png'), fullPage: true })
    await page.context().close()
    assert.deepEqual(messages, [])
  })

  test('says that nothing has been measured, if there are no results', async () => {
    const { page, messages } = await openResults(desktop, header)
    await page.getByText('Nothing has been measured yet').waitFor(timeoutOptions)
    assert.equal(await page.locator('svg').count(), 0)
    await page.context().close()
    assert.deepEqual(messages, [])
  })
})
