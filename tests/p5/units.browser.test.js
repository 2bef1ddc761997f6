// The docs page about units has a table and pictures of `position`: compares them with the vertices of each shape and the matrices that p5
// passes to the GPU.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { path } from '../../.scripts/lib/files.mjs'
import { leavePage } from '../support/browser/browser.js'
import { openHost, p5Versions, runSketch } from '../support/browser/sketch.js'
import { eye, shapes } from '../support/units.js'

/** Code that records the vertices and matrices of each draw call. Runs in the page, before p5. */
const recording = `
const drawn = [], contents = new Map(), gl = WebGL2RenderingContext.prototype
const { bufferData, drawArrays, drawElements } = gl
gl.bufferData = function (target, data, ...rest) {
  if (target === this.ARRAY_BUFFER && ArrayBuffer.isView(data))
    contents.set(this.getParameter(this.ARRAY_BUFFER_BINDING), [...data])
  return bufferData.call(this, target, data, ...rest)
}
function record(gl) {
  const program = gl.getParameter(gl.CURRENT_PROGRAM)
  const location = gl.getAttribLocation(program, 'aPosition')
  const buffer = gl.getVertexAttrib(location, gl.VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)
  const [view, modelView] = ['uViewMatrix', 'uModelViewMatrix'].map((name) =>
    [...gl.getUniform(program, gl.getUniformLocation(program, name))])
  drawn.push({ numbers: contents.get(buffer), view, modelView })
}
gl.drawArrays = function (...args) { record(this); return drawArrays.apply(this, args) }
gl.drawElements = function (...args) { record(this); return drawElements.apply(this, args) }
`

/** Shapes of the table that have no picture. */
const others = [
  'warpBox(100, 200, 50, 3)',
  'ellipsoid(50, 80, 100)',
  'cone(50, 200)',
  'ellipse(0, 0, 90, 60)',
  'translate(150, -50); rotateZ(0.35); box(100)',
]
const calls = [...shapes.map(({ call }) => call), ...others]

const transform = (m, [x, y, z]) =>
  [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i])
const bounds = (points) =>
  [0, 1, 2].map((i) => {
    const coordinates = points.map((point) => point[i])
    return [Math.min(...coordinates), Math.max(...coordinates)]
  })

/**
 * Returns the ranges of a draw call's vertices in each space. The camera looks along -z, so that camera space is world space, translated.
 */
function rangesInSpaces({ numbers, view, modelView }) {
  assert.deepEqual(view, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -eye, 1])
  const local = Array.from({ length: numbers.length / 3 }, (_, i) =>
    numbers.slice(3 * i, 3 * i + 3),
  )
  const camera = local.map((point) => transform(modelView, point))
  const world = camera.map(([x, y, z]) => [x, y, z + eye])
  return { local: bounds(local), world: bounds(world), camera: bounds(camera) }
}

/** Asserts that ranges agree within 1.2%: round shapes are polygons, which do not quite reach the ideal extent. */
function assertAbout(actual, expected, what) {
  for (const [i, range] of expected.entries())
    for (const [k, x] of range.entries()) {
      const bound = 0.012 * (range[1] - range[0])
      const message = `${what}: expected ${'xyz'[i]} in ${range}, got ${actual[i]}`
      assert.ok(Math.abs(actual[i][k] - x) <= bound + 1e-4, message)
    }
}

/** Parses a cell of the table, such as `x and y from 0 to 1, z is 0`; `undefined` if it has no numbers. */
function parseCell(text) {
  const ranges = [[], [], []]
  for (const [, letters, low, high, only] of text.matchAll(
    /([xyz](?:(?:, | and )[xyz])*) (?:from (\S+) to ([-\d.]+)|is (\d))/g,
  ))
    for (const letter of letters.match(/[xyz]/g))
      ranges['xyz'.indexOf(letter)] = only ? [0, 0] : [Number(low), Number(high)]
  return ranges.every(({ length }) => length) ? ranges : undefined
}

/** The rows of the table: [functions, position in local space]. */
const rows = readFileSync(path('web/docs/units.md'), 'utf8')
  .split('\n')
  .filter((line) => line.startsWith('| `'))
  .map((line) => line.split('|').slice(1, 3))
/** Maps the name of a function → its ranges in the table. */
const table = new Map(
  rows.flatMap(([names, local]) =>
    [...names.matchAll(/`(\w+)\(/g)].map(([, name]) => [name, parseCell(local)]),
  ),
)

const { browser, server } = await openHost()

test('the table has numbers for eleven functions', () =>
  assert.equal([...table.values()].filter(Boolean).length, 11))

for (const [version, p5] of Object.entries(p5Versions))
  test(`position has the documented range in p5 ${version}`, async () => {
    const scripts = [p5.replace(/js$/, 'min.js'), '/dist/p5.warpjet.min.js']
    const code = `${recording}
function setup() { createCanvas(640, 480, WEBGL); noStroke(); noLoop() }
function draw() {
  lights()
  ${calls.map((call) => `push(); ${call}; pop()`).join('\n  ')}
  window.done = true
}`
    const { page, messages } = await runSketch(browser, server, scripts, code)
    const drawn = await page.evaluate('drawn')
    await leavePage(page)
    assert.deepEqual(messages, [])
    assert.equal(drawn.length, calls.length)
    const found = new Map(calls.map((call, i) => [call, rangesInSpaces(drawn[i])]))
    for (const { call, local, world } of shapes) {
      assertAbout(found.get(call).local, local, `${call} in local space`)
      assertAbout(found.get(call).world, world, `${call} in world space`)
    }
    for (const [call, { local }] of found) {
      const documented = table.get(/^\w+/.exec(call)[0])
      if (documented) assertAbout(local, documented, `${call} in the table`)
    }
    // Checks the box in the picture units-spaces.svg.
    const { local, world, camera } = found.get(others.at(-1))
    assertAbout(local, Array(3).fill([-0.5, 0.5]), 'the box in local space')
    const middle = (ranges) => ranges.map(([low, high]) => (low + high) / 2)
    for (const [ranges, z] of [
      [world, 0],
      [camera, -eye],
    ])
      // prettier-ignore
      for (const [i, x] of middle(ranges).entries())
        assert.ok(Math.abs(x - [150, -50, z][i]) < 1e-3, `${ranges}`)
  })

test('the pictures of the docs show these shapes with their numbers', () => {
  const pictures = ['units-1.svg', 'units-2.svg', 'units-spaces.svg']
  const text = pictures.map((file) => readFileSync(path(`web/docs/${file}`), 'utf8')).join('')
  for (const { call, title = call } of shapes) assert.ok(text.includes(`>${title}</text>`), title)
  for (const label of ['>±0.5<', '>±300<', '>−800±25<', '(150, −50, 0)', '(150, −50, −800)'])
    assert.ok(text.includes(label), label)
})
