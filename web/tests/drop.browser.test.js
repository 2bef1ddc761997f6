// Tests the page for a visitor's own model: dropped files, warps, the exported file, and the messages for broken files.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { exportGLB, loadMesh } from '../../dist/mesh.js'
import { desktop, difference, path, patience, pixels } from '../../tests/support/browser/bench.js'
import { bytesOf, launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { disableAntialiasing } from '../../tests/support/browser/frames.js'
import { sphereMesh } from '../../tests/support/browser/mesh.js'
import { serveSite, serveSources } from '../../tests/support/browser/site.js'
import { png } from '../../tests/support/png.js'

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }
/** Starts with the time paused, so that only the test moves anything, and draws a quarter of the pixels. */
const paused = { ...desktop, deviceScaleFactor: 0.5, reducedMotion: 'reduce' }
const screenshots = path('.build/screenshots')

// A green model that is small and far from the origin, as in some files.
const sphere = sphereMesh(32, 16)
const ball = {
  positions: sphere.vertices.flatMap(([x, y, z]) => [5 + 0.01 * x, 0.02 * y, 0.01 * z - 3]),
  normals: sphere.normals.flatMap(([x, y, z]) => {
    const normal = [x, y / 2, z]
    return normal.map((value) => value / Math.hypot(...normal))
  }),
  indices: sphere.faces.flat(),
  material: { baseColor: [0.02, 0.8, 0.05, 1] },
}
const glb = Buffer.from(exportGLB(ball))

/** Returns the same model as .gltf, with its vertices in a separate file. */
function makeGltfAndBin() {
  const length = glb.readUInt32LE(12)
  const json = JSON.parse(glb.subarray(20, 20 + length).toString())
  const binary = glb.subarray(28 + length)
  json.buffers = [{ byteLength: binary.length, uri: 'parts/ball%20data.bin' }]
  return { 'ball.gltf': Buffer.from(JSON.stringify(json)), 'ball data.bin': binary }
}

let browser, server, url
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowser()
  server = await serveSources(5220)
  url = `${server.resolvedUrls.local[0]}drop/index.html`
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Waits until no work is pending. */
const waitUntilIdle = (page) =>
  page.waitForFunction(() => document.querySelector('main').ariaBusy === 'false', null, patience)

async function open(options = paused) {
  const context = await browser.newContext(options)
  await context.addInitScript(disableAntialiasing)
  const opened = await openPage(context, url)
  await waitUntilIdle(opened.page)
  return opened
}

/** Drops files onto the page with the events of a browser. */
async function drop(page, files) {
  const texts = Object.entries(files).map(([name, bytes]) => [
    name,
    Buffer.from(bytes).toString('base64'),
  ])
  const transfer = await page.evaluateHandle((texts) => {
    const transfer = new DataTransfer()
    for (const [name, text] of texts) {
      const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
      transfer.items.add(new File([bytes], name))
    }
    return transfer
  }, texts)
  for (const event of ['dragenter', 'dragover', 'drop'])
    await page.dispatchEvent('h1', event, { dataTransfer: transfer })
  await waitUntilIdle(page)
}

/** Redraws the canvas by a resize event and returns its pixels. */
async function takePicture(page) {
  await waitUntilIdle(page)
  await page.evaluate(() => {
    const again = () => (dispatchEvent(new Event('resize')), requestAnimationFrame(again))
    window.again ??= requestAnimationFrame(again)
  })
  return pixels(page)
}

const readText = (page, selector) => page.locator(selector).first().textContent()
const readProblem = (page) => readText(page, '[role=alert]')
const readNumbers = async (page, selector) =>
  (await readText(page, selector))
    .match(/[\d,]+/g)
    .map((number) => Number(number.replaceAll(',', '')))

/** Returns the fraction of greenish pixels. */
function greenShare(image) {
  let count = 0
  for (let i = 0; i < image.length; i += 4)
    if (image[i + 1] > 60 && image[i + 1] > image[i] + 25 && image[i + 1] > image[i + 2] + 25)
      count++
  return (4 * count) / image.length
}

/** Sets a range input as a visitor would. */
const slide = (page, id, value) =>
  page.locator(id).evaluate((input, value) => {
    input.value = value
    for (const type of ['input', 'change']) input.dispatchEvent(new Event(type))
  }, value)

describe('the page for your own model', () => {
  let page, messages
  before(async () => ({ page, messages } = await open()))
  after(() => page.context().close())

  test('starts with a model of the gallery', async () => {
    const image = await takePicture(page)
    assert.equal(await readText(page, '.name'), 'bunny')
    assert.ok(greenShare(image) < 0.001)
    await page.screenshot({ path: `${screenshots}/drop.png`, fullPage: true })
  })

  test('draws a model that is dropped on it', async () => {
    await drop(page, { 'ball.glb': glb })
    assert.equal(await readProblem(page), '')
    assert.equal(await readText(page, '.name'), 'ball')
    assert.deepEqual(await readNumbers(page, '.triangles'), [1024])
    const share = greenShare(await takePicture(page))
    assert.ok(share > 0.03 && share < 0.5, `${(100 * share).toFixed(1)}% are green`)
  })

  test('warps the model with different amounts, times and axes', async () => {
    await page.getByText('Waves', { exact: true }).click()
    const waves = await takePicture(page)
    assert.ok(greenShare(waves) > 0.03)
    const changes = {
      warp: () => page.getByText('Bend', { exact: true }).click(),
      amount: () => slide(page, '#amount', 0.9),
      time: () => slide(page, '#time', 2),
      side: () => page.locator('.axes').getByText('x', { exact: true }).click(),
    }
    let before = waves
    for (const [name, change] of Object.entries(changes)) {
      await change()
      const image = await takePicture(page)
      assert.ok(difference(before, image) > 0.005, name)
      assert.ok(greenShare(image) > 0.02, name)
      before = image
    }
    assert.equal(await readProblem(page), '')
  })

  test('shows normals, edges and the bounding box', async () => {
    const before = await takePicture(page)
    for (const name of ['normals', 'wireframe', 'bounding box']) {
      const box = page.getByLabel(name, { exact: true })
      await box.check()
      assert.ok(difference(before, await takePicture(page)) > 0.001, name)
      await box.uncheck()
      assert.equal(difference(before, await takePicture(page)), 0, name)
    }
  })

  test('subdivides where the warp needs it, and restores the mesh', async () => {
    const subdivision = page.getByLabel('where the warp needs it')
    await page.getByText('Waves', { exact: true }).click()
    await subdivision.check()
    await waitUntilIdle(page)
    const [before, coarse] = await readNumbers(page, '.triangles')
    assert.equal(before, 1024)
    assert.ok(coarse > 1024)
    await slide(page, '#tolerance', -3.5)
    await waitUntilIdle(page)
    assert.ok((await readNumbers(page, '.triangles'))[1] > 1.5 * coarse)
    await subdivision.uncheck()
    await waitUntilIdle(page)
    assert.deepEqual(await readNumbers(page, '.triangles'), [1024])
  })

  test('counts the vertices that are inside out', async () => {
    await page.getByText('Ripple', { exact: true }).click()
    await page.locator('.axes').getByText('y', { exact: true }).click()
    await slide(page, '#amount', 0)
    await waitUntilIdle(page)
    assert.deepEqual(await readNumbers(page, '.folded'), [0, 561])
    await page.getByText('Waves', { exact: true }).click()
    await slide(page, '#amount', 1)
    await waitUntilIdle(page)
    const [folded] = await readNumbers(page, '.folded')
    assert.ok(folded > 0 && folded < 561, `${folded} vertices are inside out`)
  })

  test('exports the warped model as a file', async () => {
    await page.getByText('Twist', { exact: true }).click()
    await slide(page, '#amount', 0.5)
    await slide(page, '#time', 0)
    await waitUntilIdle(page)
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Download' }).click(),
    ])
    assert.equal(download.suggestedFilename(), 'ball-twist.glb')
    const mesh = await loadMesh(await bytesOf(download))
    assert.equal(mesh.indices.length, 3 * 1024)
    assert.ok(Math.abs(mesh.material.baseColor[1] - 0.8) < 1e-6)
    // The page's twist: 4 · 0.5 radians per unit of 0.02, about the ball's upright axis.
    const original = await loadMesh(glb)
    for (let i = 0; i < mesh.positions.length; i += 3) {
      const [x, y, z] = original.positions.subarray(i, i + 3)
      const angle = (2 * y) / 0.02
      const expected = [
        5 + (x - 5) * Math.cos(angle) + (z + 3) * Math.sin(angle),
        y,
        -3 + (z + 3) * Math.cos(angle) - (x - 5) * Math.sin(angle),
      ]
      for (const [k, value] of expected.entries())
        assert.ok(Math.abs(mesh.positions[i + k] - value) < 2e-6, `vertex ${i / 3}`)
    }
  })

  test('explains what is wrong with a file, and keeps the model', async () => {
    const before = await takePicture(page)
    const wrong = {
      'broken.glb': glb.subarray(0, 300),
      'words.obj': Buffer.from('no model at all'),
      'cat.png': Buffer.from('picture'),
      'alone.gltf': makeGltfAndBin()['ball.gltf'],
    }
    for (const [name, bytes] of Object.entries(wrong)) {
      await drop(page, { [name]: bytes })
      const message = await readProblem(page)
      assert.match(message, /^[A-Z“][^\n]{15,300}\.$/, name)
      assert.equal(await readText(page, '.name'), 'ball')
      assert.equal(difference(before, await takePicture(page)), 0, name)
    }
    await page.screenshot({ path: `${screenshots}/drop-problem.png` })
  })

  test('accepts a .gltf with the files that it names, also from the file dialog', async () => {
    await page.getByRole('button', { name: 'box', exact: true }).click()
    await waitUntilIdle(page)
    assert.deepEqual(await readNumbers(page, '.triangles'), [12])
    const files = Object.entries(makeGltfAndBin())
    await page
      .locator('[type=file]')
      .setInputFiles(
        files.map(([name, buffer]) => ({ name, buffer, mimeType: 'application/octet-stream' })),
      )
    await page.getByText('ball', { exact: true }).waitFor(patience)
    await waitUntilIdle(page)
    assert.equal(await readProblem(page), '')
    assert.deepEqual(await readNumbers(page, '.triangles'), [1024])
    assert.ok(greenShare(await takePicture(page)) > 0.03)
  })

  test('shows what was left out of a file', async () => {
    const { 'ball.gltf': json, ...binary } = makeGltfAndBin()
    const animated = { ...JSON.parse(json), animations: [{ channels: [], samplers: [] }] }
    await drop(page, { 'ball.gltf': Buffer.from(JSON.stringify(animated)), ...binary })
    assert.match(await readText(page, '.warnings'), /animation/i)
    await drop(page, { 'ball.glb': glb })
    assert.equal(await readText(page, '.warnings'), '')
  })

  test('shows the base-color texture of a material', async () => {
    const colors = [
      [20, 200, 30],
      [255, 255, 255],
    ]
    const tile = (color) => ({
      positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
      uvs: [0, 1, 1, 1, 1, 0, 0, 0],
      indices: [0, 1, 2, 0, 2, 3],
      material: {
        baseColor: [1, 1, 1, 1],
        baseColorTexture: { bytes: png(1, 1, () => color), mimeType: 'image/png' },
      },
    })
    for (const color of colors) {
      await drop(page, { 'tile.glb': exportGLB(tile(color)) })
      const share = greenShare(await takePicture(page))
      assert.ok(color === colors[0] ? share > 0.03 : share === 0, `${color}: ${share}`)
    }
    await drop(page, { 'ball.glb': glb })
  })

  test('rotates and zooms by keys', async () => {
    const before = await takePicture(page)
    await page.locator('canvas').focus()
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '+']) await page.keyboard.press(key)
    assert.ok(greenShare(await takePicture(page)) > 1.1 * greenShare(before))
    await page.keyboard.press('0')
    assert.equal(difference(before, await takePicture(page)), 0)
  })

  test('plays on request', async () => {
    await page.getByRole('button', { name: 'Play' }).press('Enter')
    await page.waitForFunction(
      () => Number(document.querySelector('#time').value) > 0.5,
      null,
      patience,
    )
    await page.getByRole('button', { name: 'Pause' }).press('Enter')
  })

  test('logs nothing', () => assert.deepEqual(messages, []))
})

test('fits a phone, on which a finger rotates the model', async () => {
  const { page, messages } = await open({ ...phone, reducedMotion: 'reduce' })
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390)
  const small = await page.$$eval(
    '.button, .warps label, [type=range]',
    (controls) => controls.filter((control) => control.getBoundingClientRect().height < 32).length,
  )
  assert.equal(small, 0)
  await drop(page, { 'ball.glb': glb })
  await page.getByText('Wobble', { exact: true }).tap()
  const before = await takePicture(page)
  assert.ok(greenShare(before) > 0.03)

  const session = await page.context().newCDPSession(page)
  const { x, y, width, height } = await page.locator('canvas').boundingBox()
  const touch = (type, dx) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: x + width / 2 + dx, y: y + height / 2 }],
    })
  await touch('touchStart', 0)
  for (const dx of [20, 40, 60]) await touch('touchMove', dx)
  await touch('touchEnd')
  assert.ok(difference(before, await takePicture(page)) > 0.005)
  await page.screenshot({ path: `${screenshots}/drop-phone.png`, fullPage: true })
  await page.context().close()
  assert.deepEqual(messages, [])
})

test('the built page works, and the gallery links to it', async () => {
  const built = await serveSite(5320)
  try {
    const context = await browser.newContext(paused)
    const { page, messages } = await openPage(context, built.resolvedUrls.local[0])
    await page.getByRole('link', { name: 'Your model', exact: true }).first().click()
    await waitUntilIdle(page)
    await drop(page, { 'ball.glb': glb })
    assert.ok(greenShare(await takePicture(page)) > 0.03)
    await context.close()
    assert.deepEqual(messages, [])
  } finally {
    await built.close()
  }
})
