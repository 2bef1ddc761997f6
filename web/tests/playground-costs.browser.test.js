// Compares the playground's tabs of costs and checks with known figures.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { launchBrowser } from '../../tests/support/browser/browser.js'
import { openPlayground, stillSketch, write } from '../../tests/support/browser/playground.js'

let page, messages, close
before(async () => ({ page, messages, close } = await openPlayground(5252, await launchBrowser())))
after(() => close())

const openTab = (name) => page.getByRole('tab', { name }).click()
/** Reads terms and figures of the open tab, once the sketch's frame has computed them. */
const readFigures = async () => {
  await page.locator('#panel .read-outs').first().waitFor()
  await page.locator('#panel [aria-busy="true"]').waitFor({ state: 'detached' })
  return page
    .locator('#panel .read-outs > div')
    .evaluateAll((rows) =>
      Object.fromEntries(
        rows.map((row) => ['dt', 'dd'].map((kind) => row.querySelector(kind).textContent)),
      ),
    )
}

test('shows the cost of a warp: operations, characters, the first picture and a frame', async () => {
  await write(page, stillSketch('#ff0000', 'glsl.vec3(position.y().mult(3).sin(), 0, 0)'))
  await openTab('Costs')
  const { stats } = compileWarp(({ glsl, position }) => glsl.vec3(position.y().mult(3).sin(), 0, 0))
  const row = await page.locator('#panel tbody td').allTextContents()
  await openTab('GLSL 3.00')
  // The first line names the function that made the code.
  const shown = (await page.locator('#panel').textContent()).replace(/^.*\n/, '').trimEnd()
  await openTab('Costs')
  const { nodes, operations, temporaries } = stats
  assert.deepEqual(row.slice(0, 4), ['createWarp', ...[nodes, operations, temporaries].map(String)])
  assert.ok(Math.abs(Number(row[4]) - shown.length) <= 2, `${row[4]}, not ${shown.length}`)
  await page.waitForFunction(() => /\d ms/.test(document.querySelector('#panel .rate').textContent))
  const { 'First picture': first, 'A frame': frame } = await readFigures()
  assert.match(first, /^[\d,]+ ms$/)
  assert.match(frame, /^[\d.,]+ ms \([\d,]+ a second\)$/)
})

/** Counts the violet (inside out) and red (wrong) pixels of the map. */
const countMapPixels = async () => {
  await page.locator('#panel .map').waitFor()
  return page.locator('#panel .map').evaluate((canvas) => {
    const { width, height } = canvas
    const { data } = canvas.getContext('2d').getImageData(0, 0, width, height)
    const counts = { all: width * height, violet: 0, red: 0 }
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 2] > 200) counts.violet++
      else if (data[i] > 150) counts.red++
    }
    return counts
  })
}

test('finds the normals of a warp correct, compared with finite differences', async () => {
  await write(page, stillSketch('#ff0000', 'glsl.vec3(position.y().mult(3).sin().mult(0.3), 0, 0)'))
  await openTab('Checks')
  const figures = await readFigures()
  assert.ok(parseFloat(figures['Max error of a normal']) < 0.5, JSON.stringify(figures))
  const { all, violet, red } = await countMapPixels()
  assert.equal(figures['Turned inside out'], `0 of ${all.toLocaleString('en')} points`)
  assert.deepEqual([violet, red], [0, 0])
})

test('finds the points that are inside out: all of a mirrored sphere, half of a sphere that is folded in the middle', async () => {
  await write(page, stillSketch('#ff0000', 'glsl.vec3(position.x().mult(-2), 0, 0)'))
  const mirrored = await countMapPixels()
  assert.equal(mirrored.violet, mirrored.all)
  // x becomes x², which decreases where x is negative: that half of the sphere is folded over the other one.
  await write(
    page,
    stillSketch('#ff0000', 'glsl.vec3(position.x().mult(position.x()).sub(position.x()), 0, 0)'),
  )
  const folded = await countMapPixels()
  assert.equal(folded.violet, folded.all / 2)
})

test('reports normals that ignore the rotation of the surface as wrong', async () => {
  const along = 'normal.mult(normal.y().mult(9).sin().mult(0.2))'
  const sketch = (more) =>
    stillSketch('#ff0000', along, more).replace('position, uniforms', 'normal, position, uniforms')
  await write(page, sketch(''))
  const right = parseFloat((await readFigures())['Max error of a normal'])
  await write(page, sketch(', { surfaceVariation: false }'))
  const wrong = parseFloat((await readFigures())['Max error of a normal'])
  assert.ok(right < 0.5 && wrong > 20, `${right}°, ${wrong}°`)
  const { all, red } = await countMapPixels()
  assert.ok(red > all / 2)
})

test('explains how to check a warp whose uniform is set only when the sketch draws', async () => {
  const far = "glsl.vec3(glsl.param('far'), 0, 0)"
  const sketch = stillSketch('#ff0000', far, ", { defs: 'uniform float far;' }")
  await write(page, sketch.replace('warp()', 'warp({ far: 0.5 })'))
  await openTab('Checks')
  assert.equal(await page.locator('.mistake').textContent(), '')
  assert.match(await page.locator('#panel .check').textContent(), /“far”.*uniforms: \{ far: 1 \}/)
})

test('logs nothing', () => assert.deepEqual(messages, []))
