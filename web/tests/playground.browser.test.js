// Tests the playground: the picture follows the sketch, an error in the sketch keeps the last picture, and a link restores a sketch.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { exportGLB } from '../../dist/mesh.js'
import { desktop, difference, path, phone } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { drawLittle, framesInPlayground } from '../../tests/support/browser/frames.js'
import {
  canvasPixels,
  cursorLine,
  dragNumber,
  editorText,
  stillSketch,
  visibleFrame,
  waitUntilSettled,
  write,
} from '../../tests/support/browser/playground.js'
import { serveSources } from '../../tests/support/browser/site.js'

const screenshots = path('.build/screenshots')

let browser, server, url
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowser()
  server = await serveSources(5240)
  url = `${server.resolvedUrls.local[0]}playground/index.html`
})
after(async () => {
  await browser.close()
  await server.close()
})

describe('the playground', () => {
  let page, messages, context
  before(async () => {
    context = await browser.newContext({ ...desktop, reducedMotion: 'reduce' })
    await drawLittle(context, framesInPlayground)
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    ;({ page, messages } = await openPage(context, url))
    await waitUntilSettled(page)
  })
  after(() => context.close())

  test('starts with a sketch that runs, and its code in three languages', async () => {
    assert.match(await editorText(page), /createWarp/)
    assert.match(await page.locator('#panel').textContent(), /vec3 offset, warpedPosition/)
    await page.getByRole('tab', { name: 'WGSL' }).click()
    assert.match(await page.locator('#panel').textContent(), /var offset: vec3f/)
    for (const name of ['WGSL', 'GLSL 1.00'])
      await page.getByRole('tab', { name }).press('ArrowLeft')
    assert.equal(
      await page.getByRole('tab', { name: 'GLSL 3.00' }).getAttribute('aria-selected'),
      'true',
    )
    await page.screenshot({ path: `${screenshots}/playground.png` })
  })

  test('runs the typed sketch after a pause', async () => {
    await write(page, stillSketch('#ff0000'))
    const red = await canvasPixels(page)
    await write(page, stillSketch('#0000ff'))
    const blue = await canvasPixels(page)
    assert.ok(difference(red, blue) > 0.1)
    await write(page, stillSketch('#0000ff', 'glsl.vec3(1, 0, 0)'))
    assert.ok(difference(blue, await canvasPixels(page)) > 0.1)
  })

  test('keeps the last good picture after a mistake, and marks its line with a message', async () => {
    await write(page, stillSketch('#00ff00'))
    const before = await canvasPixels(page)
    const mistakes = [
      [stillSketch('#00ff00', 'glsl.vec2(0, 0)'), 5, /must return a vec3/],
      [stillSketch('#00ff00', 'position.mlt(2)'), 5, /mlt/],
      [stillSketch('#00ff00', 'position + 1'), 5, /\+/],
      [stillSketch('#00ff00').replace('noStroke()', 'noStroke('), 4, /^SyntaxError: /, 5],
      [stillSketch('#00ff00').replace('noStroke()', 'while (true) {}'), 4, /ran for five seconds/],
      [stillSketch('#00ff00').replace('warp()', 'wrap()'), 10, /^ReferenceError: wrap/],
      [
        stillSketch('#00ff00')
          .replace('function setup', 'async function setup')
          .replace('noStroke()', "await loadModel('nowhere.obj')"),
        4,
        /./,
      ],
    ]
    // [sketch, line, message, another line that a browser may name instead]. For a syntax error this is the next line, where the parser
    // stops.
    for (const [sketch, expectedLine, message, otherLine = expectedLine] of mistakes) {
      await write(page, sketch)
      const mistake = await page.locator('.mistake').textContent()
      assert.match(mistake.replace(/^Line \d+ /, ''), message)
      const line = Number(/^Line (\d+) /.exec(mistake)?.[1])
      assert.ok(line === expectedLine || line === otherLine, `${mistake}, not line ${expectedLine}`)
      assert.equal(await page.locator('.cm-lint-marker-error').count(), 1, mistake)
      assert.equal(difference(before, await canvasPixels(page)), 0)
      assert.doesNotMatch(mistake, /blob:|warps\.js/)
    }
    await page.screenshot({ path: `${screenshots}/playground-mistake.png` })
    await page.getByRole('button', { name: /^Line / }).click()
    assert.match(await cursorLine(page), /loadModel/)
    await write(page, stillSketch('#00ff00'))
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.equal(await page.locator('.cm-lint-marker-error').count(), 0)
    // The one message is p5's, about the missing model. There is no failed request, since the page requests only files of site-files.js.
    assert.equal(messages.splice(0).length, 1)
  })

  test('undoes and redoes typing', async () => {
    await write(page, stillSketch('#ffff00'))
    const yellow = await canvasPixels(page)
    await write(page, stillSketch('#ff00ff'))
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    assert.equal(await editorText(page), stillSketch('#ffff00'))
    assert.equal(difference(yellow, await canvasPixels(page)), 0)
    await page.keyboard.press('Control+y')
    await waitUntilSettled(page)
    assert.equal(await editorText(page), stillSketch('#ff00ff'))
  })

  test('restores a sketch from its link', async () => {
    const sketch = stillSketch('#ff8000', 'glsl.vec3(0, 0.5, 0) /* ≠ “ä” 🌸 */')
    await write(page, sketch)
    const before = await canvasPixels(page)
    await page.getByRole('button', { name: 'Copy link' }).click()
    await page.getByRole('button', { name: 'Copied' }).waitFor()
    const link = await page.evaluate(() => navigator.clipboard.readText())
    assert.ok(link.length < 800, `${link.length} characters`)
    const other = await openPage(context, link)
    await waitUntilSettled(other.page)
    assert.equal(await editorText(other.page), sketch)
    assert.equal(difference(before, await canvasPixels(other.page)), 0)
    assert.deepEqual(other.messages, [])
    await other.page.close()
  })

  test('changes a number by dragging it, as one step of the undo history', async () => {
    await write(page, stillSketch('#00ffff', 'glsl.vec3(0.10, 0, 0)'))
    const before = await canvasPixels(page)
    await dragNumber(page, '0.10', 160)
    await waitUntilSettled(page)
    assert.equal(await editorText(page), stillSketch('#00ffff', 'glsl.vec3(0.50, 0, 0)'))
    assert.ok(difference(before, await canvasPixels(page)) > 0.02)
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    assert.equal(await editorText(page), stillSketch('#00ffff', 'glsl.vec3(0.10, 0, 0)'))
    await page.locator('.cm-number').getByText('0.10', { exact: true }).click()
    await page.keyboard.press('Alt+ArrowDown')
    await waitUntilSettled(page)
    assert.equal(await editorText(page), stillSketch('#00ffff', 'glsl.vec3(0.09, 0, 0)'))
  })

  test('shows a slider for a uniform that is a number', async () => {
    await write(
      page,
      stillSketch('#80ff00', 'glsl.vec3(uniforms.far, 0, 0)', ', { uniforms: { far: 0.5 } }'),
    )
    const before = await canvasPixels(page)
    const slider = page.getByLabel('far', { exact: true })
    await slider.press('End')
    assert.equal(Number(await slider.inputValue()), 2)
    assert.ok(difference(before, await canvasPixels(page)) > 0.05)
  })

  test('pauses, and shows the time selected on the time bar', async () => {
    await write(
      page,
      stillSketch('#ffffff')
        .replace('glsl.vec3(0, 0, 0)', 'glsl.vec3(millis.div(1000), 0, 0)')
        .replace('uniforms', 'millis'),
    )
    const before = await canvasPixels(page)
    assert.equal(difference(before, await canvasPixels(page)), 0)
    await page.getByLabel('Time', { exact: true }).press('Home')
    assert.ok(difference(before, await canvasPixels(page)) > 0.05)
    await page.getByRole('button', { name: 'Play' }).click()
    await page.waitForFunction(
      () => parseFloat(document.querySelector('.time output').textContent) > 0.3,
    )
    await page.getByRole('button', { name: 'Stop' }).click()
  })

  test('shows normals as colours', async () => {
    await write(page, stillSketch('#ffffff'))
    await page.getByLabel('Normals as colours').check()
    await waitUntilSettled(page)
    const image = await canvasPixels(page)
    // The normal points to the camera in the middle of the sphere, and to the side at its right edge.
    const at = (x, y) => [...image.subarray(4 * (120 * y + x), 4 * (120 * y + x) + 3)]
    const [middle, right] = [at(60, 45), at(87, 45)]
    assert.ok(middle[2] > 240 && middle[0] < 40, `${middle}`)
    assert.ok(right[0] > 220 && right[2] < 128, `${right}`)
    await page.getByLabel('Normals as colours').uncheck()
    await waitUntilSettled(page)
  })

  test('names the box to tick for a missing script', async () => {
    const mistake = page.locator('.mistake')
    await write(page, stillSketch('#ff00ff').replace('warp =', 'warpjet.melt(0.5); warp ='))
    assert.match(
      await mistake.textContent(),
      /warpjet\.melt.*warpjet\.deformers\.min\.js.*Here, tick “Deformers” above\.$/,
    )
    await write(page, stillSketch('#ff00ff', "warpjet.glslOffset('')"))
    assert.match(await mistake.textContent(), /Here, tick “Shader text” above\.$/)
  })

  test('runs operators with their script, and names it if it is missing', async () => {
    await write(page, stillSketch('#ff00ff', '[position.y * 0.5, 0, 0]'))
    assert.match(await page.locator('.mistake').textContent(), /Here, tick “Operators” above\.$/)
    await page.getByLabel('Operators').check()
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.match(await page.locator('#panel').textContent(), /position\.y/)
    await page.locator('.cm-content').focus()
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    assert.equal(await page.getByLabel('Operators').isChecked(), false)
  })

  test('runs in p5 1.11 and in three.js, and undo restores the host', async () => {
    await write(page, stillSketch('#ff4000', 'glsl.vec3(0.2, 0, 0)'))
    const before = await canvasPixels(page)
    const host = page.getByLabel('Runs in')
    await host.selectOption('p5-1')
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.match(
      await (await visibleFrame(page)).evaluate('p5.VERSION || p5.prototype.VERSION'),
      /^1\.11/,
    )
    assert.ok(difference(before, await canvasPixels(page)) < 0.03)
    await host.selectOption('three')
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.match(await editorText(page), /from 'three'/)
    await page.locator('.cm-content').focus()
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    assert.equal(await host.inputValue(), 'p5-1')
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    assert.equal(await host.inputValue(), 'p5')
    assert.equal(difference(before, await canvasPixels(page)), 0)
  })

  test('marks the statements generated from the line of the cursor, and the line from which the statement under the pointer was generated', async () => {
    const lines = 'const a = position.y().mult(3).sin()\n  return glsl.vec3(a, a.mult(0.3), 0)'
    await write(page, stillSketch('#40ff40').replace('glsl.vec3(0, 0, 0)', `{\n  ${lines}\n}`))
    const markedStatements = () => page.locator('.panel .lit').allTextContents()
    for (const language of ['GLSL 3.00', 'GLSL 1.00', 'WGSL']) {
      await page.getByRole('tab', { name: language }).click()
      await page.locator('.cm-line', { hasText: 'const a =' }).click()
      await page.locator('.panel .lit').first().waitFor()
      const statements = await markedStatements()
      for (const call of [/sin\(/, /cos\(/]) assert.ok(statements.some((text) => call.test(text)))
      await page.keyboard.press('ArrowDown')
      await page.waitForFunction(
        (before) => document.querySelector('.panel .lit')?.textContent !== before,
        statements[0],
      )
      assert.ok(!(await markedStatements()).some((text) => /sin\(/.test(text)))
    }
    const statement = page.locator('.panel [data-from]', { hasText: 'sin(' })
    await statement.hover()
    assert.match(await page.locator('.cm-lit').textContent(), /const a =/)
    await statement.click()
    assert.match(await cursorLine(page), /const a =/)
    assert.equal((await markedStatements()).length > 0, true)
    await page.getByRole('tab', { name: 'GLSL 3.00' }).click()
  })

  test('applies an offset function without a sketch to a model, and restores function and model from the link', async () => {
    await page.getByLabel('Runs in').selectOption('offset')
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.doesNotMatch(await editorText(page), /createWarp/)
    assert.equal(await page.getByLabel('height', { exact: true }).count(), 1)
    const sphere = await canvasPixels(page)
    await page.locator('#model').selectOption('bunny.obj')
    await waitUntilSettled(page)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.ok(difference(sphere, await canvasPixels(page)) > 0.05)
    const link = page.url()
    await page.getByLabel('Runs in').selectOption('p5')
    await waitUntilSettled(page)
    assert.match(await editorText(page), /model\(shape\)/)
    assert.equal(await page.locator('#model').isVisible(), false)
    await page.goto(link)
    await waitUntilSettled(page)
    assert.equal(await page.locator('#model').inputValue(), 'bunny.obj')
    await write(page, 'const nothing = 0')
    assert.match(
      await page.locator('.mistake').textContent(),
      /Write a function with the name offset/,
    )
    await page.locator('.cm-content').focus()
    await page.keyboard.press('Control+z')
    await waitUntilSettled(page)
    await page.screenshot({ path: `${screenshots}/playground-offset.png` })
  })

  test('accepts a dropped model, and applies the offset to it', async () => {
    const file = await page.evaluateHandle(() => {
      const transfer = new DataTransfer()
      const corner = (x, y, z) => `v ${x} ${y} ${z}\n`
      const points = [corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)]
      const faces = 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n'
      transfer.items.add(new File([points.join('') + faces], 'corner.obj'))
      return transfer
    })
    await page.dispatchEvent('body', 'drop', { dataTransfer: file })
    await waitUntilSettled(page)
    assert.equal(await page.locator('#model').inputValue(), 'corner.obj')
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.equal(await (await visibleFrame(page)).evaluate('shape.faces.length'), 4)
    // Repeat with GLB, which has a different loader.
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]
    const bytes = exportGLB({ positions, indices: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3] })
    const glb = await page.evaluateHandle((bytes) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([Uint8Array.from(bytes)], 'corner.glb'))
      return transfer
    }, Array.from(bytes))
    await page.dispatchEvent('body', 'drop', { dataTransfer: glb })
    await waitUntilSettled(page)
    assert.equal(await page.locator('#model').inputValue(), 'corner.glb')
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.equal(await (await visibleFrame(page)).evaluate('shape.faces.length'), 4)
  })

  test('reports a damaged link, and keeps the sketch', async () => {
    const before = await editorText(page)
    await page.evaluate(() => (location.hash = '#sketch=brokenlink'))
    await page.getByText('The sketch in this link is damaged').waitFor()
    assert.equal(await editorText(page), before)
  })

  test('logs no messages of its own', () => assert.deepEqual(messages, []))
})

test('fits a phone, and opens an example of the gallery', async () => {
  const context = await browser.newContext({ ...phone, reducedMotion: 'reduce' })
  await drawLittle(context, framesInPlayground)
  const { page, messages } = await openPage(context, `${url}#example=deformer-bend`)
  await waitUntilSettled(page)
  assert.match(await editorText(page), /warpjet\.bend/)
  assert.equal(await page.getByLabel('Deformers').isChecked(), true)
  assert.equal(await page.locator('.mistake').textContent(), '')
  assert.equal(
    await page.evaluate(() => document.documentElement.scrollWidth),
    phone.viewport.width,
  )
  await page.screenshot({ path: `${screenshots}/playground-phone.png`, fullPage: true })
  await context.close()
  assert.deepEqual(messages, [])
})
