// Tests what the playground saves: a picture, a page, an npm project, a page for the p5 editor, a video and the warped shape.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { loadMesh } from '../../dist/mesh.js'
import { desktop, difference, path } from '../../tests/support/browser/bench.js'
import { bytesOf, launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { drawLittle, framesInPlayground } from '../../tests/support/browser/frames.js'
import {
  canvasPixels,
  downloadFromMenu,
  editorText,
  openFromDisk,
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
  server = await serveSources(5280)
  url = `${server.resolvedUrls.local[0]}playground/index.html`
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Returns the names in the directory of an archive, in order. */
function namesInZip(bytes) {
  const names = []
  let at = bytes.readUInt32LE(bytes.length - 6)
  while (bytes.readUInt32LE(at) === 0x02014b50) {
    const length = bytes.readUInt16LE(at + 28)
    names.push(bytes.subarray(at + 46, at + 46 + length).toString())
    at += 46 + length
  }
  return names
}

describe('saving', () => {
  let page, messages, context
  before(async () => {
    context = await browser.newContext({ ...desktop, reducedMotion: 'reduce' })
    await drawLittle(context, framesInPlayground)
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    ;({ page, messages } = await openPage(context, url))
    await waitUntilSettled(page)
    await write(page, stillSketch('#ff4000'))
  })
  after(() => context.close())

  test('saves the picture', async () => {
    const bytes = await bytesOf(await downloadFromMenu(page, 'Picture (PNG)'))
    assert.equal(bytes.subarray(1, 4).toString(), 'PNG')
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [120, 90])
  })

  test('downloads a page that opens from a disk, with its model in it', async () => {
    const sketch = `// It ends no tag: '</script>'
${stillSketch('#40ff40')
  .replace('function setup', 'let bunny\nasync function setup')
  .replace('noStroke()', "noStroke(); bunny = await loadModel('bunny.obj')")
  .replace('sphere(30, 24, 16)', 'scale(0.4); model(bunny)')}`
    await write(page, sketch)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assert.equal(await (await visibleFrame(page)).evaluate('typeof bunny'), 'object')
    const before = await canvasPixels(page)
    const other = await openFromDisk(page, `${screenshots}/warp.html`)
    assert.equal(difference(before, await canvasPixels(other.page)), 0)
    assert.deepEqual(other.messages, [])
    await other.page.close()
  })

  test('packs an npm project, with its model', async () => {
    const bytes = await bytesOf(await downloadFromMenu(page, 'npm project'))
    const names = ['package.json', 'vite.config.js', 'index.html', 'sketch.js', 'bunny.obj']
    assert.deepEqual(namesInZip(bytes), names)
    assert.ok(bytes.includes('"start": "vite"'))
    assert.ok(bytes.includes('src="/warpjet/dist/p5.warpjet.min.js"'))
    assert.ok(bytes.includes(await editorText(page)))
  })

  test('copies a page for the p5 editor, and opens the editor', async () => {
    await context.route('https://editor.p5js.org/', (route) => route.fulfill({ body: 'editor' }))
    const opened = context.waitForEvent('page')
    await page.getByText('Save', { exact: true }).click()
    await page.getByRole('button', { name: 'p5 editor' }).click()
    await page.getByText('Copied: paste').waitFor()
    const editor = await opened
    assert.equal(editor.url(), 'https://editor.p5js.org/')
    await editor.close()
    const html = await page.evaluate(() => navigator.clipboard.readText())
    assert.match(
      html,
      /<script src="https:\/\/cdn\.jsdelivr\.net\/npm\/p5@2[\d.]+\/lib\/p5\.min\.js"><\/script>/,
    )
    assert.match(html, /npm\/warpjet@[\d.]+\/dist\/p5\.warpjet\.min\.js/)
    assert.match(html, /Upload beside this page: bunny\.obj/)
  })

  test('records a video of four seconds', async () => {
    const bytes = await bytesOf(await downloadFromMenu(page, 'Film of four'))
    assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3)
    assert.ok(bytes.includes('webm') && bytes.length > 500)
  })

  test('saves the warped shape in its upright orientation and position', async () => {
    await write(page, stillSketch('#40ff40', 'glsl.vec3(position.y(), 0, 0)'))
    const mesh = await loadMesh(await bytesOf(await downloadFromMenu(page, 'Warped shape')))
    const { positions, normals } = mesh
    const max = [0, 0, 0]
    for (let i = 0; i < positions.length; i += 3) {
      for (let k = 0; k < 3; k++) max[k] = Math.max(max[k], positions[i + k])
      // A sphere of 30 pixels that is sheared by p5's y, which points down, satisfies (x + y)² + y² + z² = 30² with y upwards.
      const [x, y, z] = positions.subarray(i, i + 3)
      assert.ok(Math.abs(Math.hypot(x + y, y, z) - 30) < 1e-2, `${x} ${y} ${z}`)
      const gradient = [x + y, x + 2 * y, z]
      const cosine = gradient.reduce((sum, each, k) => sum + each * normals[i + k], 0)
      assert.ok(cosine / Math.hypot(...gradient) > 0.99999)
    }
    assert.ok(Math.abs(max[1] - 30) < 1e-3 && max[0] > 40)
  })

  test('logs no messages of its own', () => assert.deepEqual(messages, []))
})
