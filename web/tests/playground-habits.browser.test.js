// Tests what users do in the playground besides writing a warp: choosing an example, printing, rotating the shape, reloading, dropping
// files, searching.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { difference, path, pixels } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import {
  canvasPixels,
  cursorLine,
  editorText,
  openFromDisk,
  openPlayground,
  stillSketch,
  visibleFrame,
  waitUntilSettled,
  write,
} from '../../tests/support/browser/playground.js'

const folder = path('.build/downloads')

let page, messages, context, close
before(async () => {
  mkdirSync(folder, { recursive: true })
  ;({ page, messages, context, close } = await openPlayground(5254, await launchBrowser()))
})
after(() => close())

const mistake = () => page.locator('.mistake').textContent()
const slider = (name) => page.getByLabel(name, { exact: true })

const setup = (more) => stillSketch('#ff8040').replace('noStroke()', `noStroke(); ${more}`)

test('chooses an example with the scripts that it needs, and undo restores the previous sketch', async () => {
  await write(page, stillSketch('#ff8040'))
  await page.getByLabel('Example').selectOption('deformer-bend')
  await page.waitForFunction(() => document.querySelector('[name=deformers]').checked)
  await waitUntilSettled(page)
  assert.equal(await mistake(), '')
  assert.match(await editorText(page), /warpjet\.bend/)
  await page.locator('.cm-content').focus()
  await page.keyboard.press('Control+z')
  await waitUntilSettled(page)
  assert.equal(await editorText(page), stillSketch('#ff8040'))
  assert.equal(await page.getByLabel('Deformers').isChecked(), false)
})

test('lists and counts the lines that a sketch prints, and clears them with the sketch', async () => {
  const tab = page.getByRole('tab', { name: 'Console' })
  await write(page, setup("print('so', 7); console.warn('beware')"))
  assert.equal(await tab.textContent(), 'Console (2)')
  await tab.click()
  const lines = page.locator('.printed li')
  assert.deepEqual(await lines.allTextContents(), ['so 7', 'beware'])
  assert.equal(await lines.nth(1).getAttribute('class'), 'warn')
  // Plain logs also go to the browser's own console.
  assert.deepEqual(messages.splice(0), ['so 7'])
  await write(page, stillSketch('#ff8040'))
  assert.equal(await tab.textContent(), 'Console')
  assert.equal(await lines.count(), 0)
  await page.getByRole('tab', { name: 'GLSL 3.00' }).click()
})

test('rotates the shape with the pointer if the sketch allows that', async () => {
  const bent = stillSketch('#ff8040', 'glsl.vec3(position.y(), 0, 0)')
  await write(page, bent.replace('warp()\n', 'orbitControl(); lights(); warp()\n'))
  const before = await canvasPixels(page)
  const { x, y, width, height } = await page.locator('.stage iframe').boundingBox()
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  await page.mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 6 })
  const isTurned = async () => difference(before, await canvasPixels(page)) > 0.02
  // p5 rotates by the movement of the pressed pointer from one frame to the next.
  for (let i = 0; i < 40 && !(await isTurned()); i++) await page.waitForTimeout(100)
  await page.mouse.up()
  assert.ok(await isTurned())
})

test('keeps the sketch and its sliders across a reload', async () => {
  const uniforms = "{ far: 0.5, up: [0, 0.2], tint: color('#ff8040') }"
  const offset = 'glsl.vec3(uniforms.far.sub(uniforms.tint.x()).div(4), uniforms.up.y(), 0)'
  const sketch = stillSketch('#80ff00', offset, `, { uniforms: ${uniforms} }`)
  await write(page, sketch)
  assert.equal(await mistake(), '')
  const moves = [
    () => slider('far').press('End'),
    () => slider('up.y').press('End'),
    () => slider('tint').fill('#008040'),
  ]
  for (const move of moves) {
    const address = page.url()
    const before = await canvasPixels(page)
    await move()
    await page.waitForFunction((before) => location.href !== before, address)
    for (let i = 0; i < 50 && !difference(before, await canvasPixels(page)); i++)
      await page.waitForTimeout(100)
    const change = difference(before, await canvasPixels(page))
    assert.ok(change > 0.005, `${move}: ${change}`)
  }
  const before = await canvasPixels(page)
  await page.reload()
  await waitUntilSettled(page)
  assert.equal(await editorText(page), sketch)
  assert.equal(Number(await slider('far').inputValue()), 2)
  assert.equal(Number(await slider('up.y').inputValue()), 0.8)
  assert.equal(await slider('tint').inputValue(), '#008040')
  assert.equal(difference(before, await canvasPixels(page)), 0)
})

test('keeps a slider’s value while the sketch is edited, until the number in the sketch changes', async () => {
  const sketchWith = (number, color) =>
    stillSketch(color, 'glsl.vec3(uniforms.far, 0, 0)', `, { uniforms: { far: ${number} } }`)
  await write(page, sketchWith(0.25, '#80ff00'))
  await slider('far').press('End')
  await write(page, sketchWith(0.25, '#8000ff'))
  assert.equal(Number(await slider('far').inputValue()), 1)
  await write(page, sketchWith(0.3, '#8000ff'))
  assert.equal(Number(await slider('far').inputValue()), 0.3)
})

test('restores the sketch with the browser’s back button after following a link', async () => {
  await write(page, stillSketch('#4080ff', 'glsl.vec3(0.3, 0, 0)'))
  const before = await canvasPixels(page)
  await page.getByRole('link', { name: 'warpjet' }).click()
  await page.waitForURL(/(?:\/|index\.html)$/)
  await page.goBack()
  await waitUntilSettled(page)
  assert.equal(await editorText(page), stillSketch('#4080ff', 'glsl.vec3(0.3, 0, 0)'))
  assert.equal(difference(before, await canvasPixels(page)), 0)
  // Ignores messages of the first page, which was left before it had loaded.
  messages.length = 0
})

test('a sketch can load a dropped picture, and the saved page contains it', async () => {
  const dataTransfer = await page.evaluateHandle(async () => {
    const canvas = new OffscreenCanvas(4, 4)
    const brush = canvas.getContext('2d')
    brush.fillStyle = '#ff0000'
    brush.fillRect(0, 0, 4, 4)
    const transfer = new DataTransfer()
    transfer.items.add(new File([await canvas.convertToBlob()], 'red.png'))
    return transfer
  })
  // Keeps the brief status message for this test.
  await page.evaluate(() => {
    const { setTimeout } = window
    window.setTimeout = (work, ms) => setTimeout(work, ms >= 2000 ? 1e9 : ms)
    window.again = () => Object.assign(window, { setTimeout })
  })
  await page.dispatchEvent('body', 'drop', { dataTransfer })
  await page.evaluate(() => window.again())
  await waitUntilSettled(page)
  assert.equal(await page.locator('.state').textContent(), 'The sketch can load “red.png” now')
  const textured = setup("image = await loadImage('red.png')")
    .replace('function setup', 'let image\nasync function setup')
    .replace("fill('#ff8040')", 'texture(image)')
  await write(page, textured)
  assert.equal(await mistake(), '')
  const before = await canvasPixels(page)
  const middle = 4 * (120 * 45 + 60)
  assert.deepEqual([...before.subarray(middle, middle + 3)], [255, 0, 0])
  const other = await openFromDisk(page, `${folder}/textured.html`)
  assert.equal(difference(before, await pixels(other.page)), 0)
  assert.deepEqual(other.messages, [])
  await other.page.close()
})

/** Drops a file of that name with a corner of four triangles. */
async function dropCorner(name) {
  const dataTransfer = await page.evaluateHandle((name) => {
    const transfer = new DataTransfer()
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n'
    transfer.items.add(new File([text], name))
    return transfer
  }, name)
  await page.dispatchEvent('body', 'drop', { dataTransfer })
  await waitUntilSettled(page)
}

test('a file of any name can be dropped, used as a model, and saved', async () => {
  const host = page.getByLabel('Runs in')
  for (const name of [`Bob's cat.obj`, `a "b" \\ </script> --> 100% #1?.obj`]) {
    await host.selectOption('offset')
    await waitUntilSettled(page)
    await dropCorner(name)
    assert.equal(await mistake(), '')
    assert.equal(await page.locator('#model').inputValue(), name)
    assert.equal(await (await visibleFrame(page)).evaluate('shape.faces.length'), 4)
    await host.selectOption('p5')
    await waitUntilSettled(page)
    assert.equal(await mistake(), '')
    const other = await openFromDisk(page, `${folder}/named.html`, () => window.frameCount > 1)
    assert.equal(await other.page.evaluate('shape.faces.length'), 4)
    assert.deepEqual(other.messages, [])
    await other.page.close()
  }
})

test('saves a sketch that writes a file itself and contains a comparison that looks like a tag', async () => {
  const words =
    'const scripts = [1, 2, 3]; let a = 0; while (a<scripts.length) a++; document.title = `${a}`'
  await write(
    page,
    `${stillSketch('#ff8040')}\nfunction keyPressed() { saveCanvas('mine.png') }\n${words}\n`,
  )
  assert.equal(await mistake(), '')
  const other = await openFromDisk(page, `${folder}/writes.html`)
  assert.equal(await other.page.title(), '3')
  assert.deepEqual(other.messages, [])
  await other.page.close()
})

test('a double click selects a number, which typing replaces', async () => {
  await write(page, stillSketch('#ff8040', 'glsl.vec3(-0.125, 0, 0)'))
  await page.locator('.cm-number').getByText('0.125', { exact: true }).dblclick()
  assert.equal(await page.evaluate(() => String(getSelection())), '0.125')
  await page.keyboard.type('0.5')
  await waitUntilSettled(page)
  assert.equal(await editorText(page), stillSketch('#ff8040', 'glsl.vec3(-0.5, 0, 0)'))
})

test('the menu closes on Escape, which restores the focus, and on a click elsewhere', async () => {
  const item = page.getByRole('button', { name: 'Picture (PNG)' })
  const summary = page.getByText('Save', { exact: true })
  await summary.click()
  await item.focus()
  await page.keyboard.press('Escape')
  assert.equal(await item.isVisible(), false)
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Save')
  await summary.click()
  assert.equal(await item.isVisible(), true)
  await page.locator('.cm-content').click()
  assert.equal(await item.isVisible(), false)
})

test('finds a word in the text', async () => {
  await write(page, stillSketch('#ff8040'))
  await page.keyboard.press('Control+f')
  await page.getByRole('textbox', { name: 'Find' }).waitFor()
  await page.keyboard.type('background')
  await page.keyboard.press('Enter')
  await page.keyboard.press('Escape')
  assert.match(await cursorLine(page), /background\(/)
  assert.equal(await page.evaluate(() => String(getSelection())), 'background')
})

test('the Tab key leaves the editor', async () => {
  await page.locator('.cm-content').focus()
  await page.keyboard.press('Tab')
  assert.equal(await editorText(page), stillSketch('#ff8040'))
  assert.equal(await page.evaluate(() => Boolean(document.activeElement.closest('.editor'))), false)
})

test('reports that there is no picture to save if nothing was drawn', async () => {
  const other = await openPage(context, 'about:blank')
  const { fragmentOf } = await import('../playground/link.js')
  const wrong = { text: stillSketch('#ff8040', 'nothing'), host: 'p5', chosen: [] }
  await other.page.goto(page.url().replace(/#.*/, '') + (await fragmentOf(wrong)))
  await waitUntilSettled(other.page)
  assert.match(await other.page.locator('.mistake').textContent(), /^Line 5 .*nothing/)
  await other.page.getByText('Save', { exact: true }).click()
  await other.page.getByRole('button', { name: 'Picture (PNG)' }).click()
  await other.page.getByText('There is no picture to save yet.').waitFor()
  await other.page.close()
})

test('the playground logs no messages of its own', () => assert.deepEqual(messages, []))
