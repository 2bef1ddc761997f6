// Tests hosts and languages that playground.browser.test.js does not test: WebGPU, offsets in GLSL, and downloaded pages of each host.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { loadMesh } from '../../dist/mesh.js'
import { compileWarp } from '../../dist/warpjet.js'
import { difference, path } from '../../tests/support/browser/bench.js'
import { launchBrowserWithWebGPU } from '../../tests/support/browser/browser.js'
import { keepFrames } from '../../tests/support/browser/frames.js'
import {
  ball,
  canvasPixels,
  downloadFromMenu,
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
  ;({ page, messages, context, close } = await openPlayground(
    5253,
    await launchBrowserWithWebGPU(),
  ))
})
after(() => close())

const host = () => page.getByLabel('Runs in')
const mistake = () => page.locator('.mistake').textContent()
/** Selects a host, and waits until the sketch has run on it. */
const runOn = async (name) => {
  await host().selectOption(name)
  await waitUntilSettled(page)
  assert.equal(await mistake(), '')
}

/** Opens the downloaded page from disk and returns the picture that it draws. */
async function drawFromDisk(name, isReady) {
  const other = await openFromDisk(page, `${folder}/${name}.html`, isReady)
  const picture = await canvasPixels(other.page)
  const version = await other.page.evaluate(
    () => window.p5?.VERSION ?? window.p5?.prototype.VERSION,
  )
  assert.deepEqual(other.messages, [])
  await other.page.close()
  return { picture, version }
}

const cosine = 'glsl.vec3(position.y().mult(3).cos().mult(0.4), 0, 0)'

test('draws the same on WebGPU as in WebGL, and reports mistakes there, too', async () => {
  await write(page, stillSketch('#ff8040', cosine))
  const before = await canvasPixels(page)
  await runOn('p5-webgpu')
  assert.match(await editorText(page), /await createCanvas\(120, 90, WEBGPU\)/)
  const frame = await visibleFrame(page)
  assert.ok(await frame.evaluate('p5.instance._renderer.device instanceof GPUDevice'))
  assert.ok(difference(before, await canvasPixels(page)) < 0.03)
  await page.getByRole('tab', { name: 'WGSL' }).click()
  assert.match(await page.locator('#panel').textContent(), /var offset: vec3f/)
  await page.locator('.cm-content').focus()
  await write(page, (await editorText(page)).replace('position.y()', 'position.w()'))
  assert.match(await mistake(), /^Line 5 /)
  await write(page, stillSketch('#ff8040', cosine))
  await runOn('p5')
  assert.equal(difference(before, await canvasPixels(page)), 0)
})

/** The offset `cosine` in GLSL, as a template literal. */
const glslLiteral = `\`
  vec3 offset(vec3 position) {
    return vec3(cos(position.y * 3.0) * 0.4, 0.0, 0.0);
  }\``

test('reads an offset in GLSL, shows its code, and marks a mistake in it', async () => {
  await write(page, stillSketch('#ff8040', cosine))
  const before = await canvasPixels(page)
  const sketch = stillSketch('#ff8040').replace(
    /createWarp\(.*\)$/m,
    `createWarp(warpjet.glslOffset(${glslLiteral}))`,
  )
  await write(page, sketch)
  assert.notEqual(await mistake(), '')
  await page.getByLabel('Shader text').check()
  await waitUntilSettled(page)
  assert.equal(await mistake(), '')
  assert.ok(difference(before, await canvasPixels(page)) < 0.001)
  await page.getByRole('tab', { name: 'GLSL 3.00' }).click()
  assert.match(await page.locator('#panel').textContent(), /cos\(/)
  assert.match(await page.locator('#panel').textContent(), /sin\(/)
  await write(page, sketch.replace('position.y * 3.0', 'positoin.y * 3.0'))
  assert.match(await mistake(), /positoin/)
  assert.equal(difference(before, await canvasPixels(page)) < 0.001, true)
  await page.getByLabel('Shader text').uncheck()
})

test('downloads a page with p5 1.11 that opens from a disk', async () => {
  await write(page, stillSketch('#40ff40', cosine))
  await runOn('p5-1')
  const before = await canvasPixels(page)
  const { picture, version } = await drawFromDisk('p5-1', () => window.frameCount > 1)
  assert.match(version, /^1\.11/)
  assert.equal(difference(before, picture), 0)
})

const openTab = (name) => page.getByRole('tab', { name }).click()
/** Waits for marked statements and returns them. */
const markedStatements = async () => {
  await page.locator('.panel .lit').first().waitFor()
  return (await page.locator('.panel .lit').allTextContents()).join('')
}
const readFigures = async () => {
  await page.locator('#panel .read-outs').waitFor()
  return page.locator('#panel .read-outs dd').allTextContents()
}

test('shows the code of a three.js warp in each language, with statements and lines marked, its costs and its checks', async () => {
  await runOn('three')
  await write(page, ball)
  assert.equal(await mistake(), '')
  await page.locator('.cm-line', { hasText: 'cos()' }).click()
  for (const language of ['GLSL 3.00', 'GLSL 1.00', 'WGSL']) {
    await openTab(language)
    const statements = await markedStatements()
    assert.ok(/cos\(/.test(statements) && /sin\(/.test(statements), statements)
  }
  await page.locator('.panel [data-from]', { hasText: 'cos(' }).first().hover()
  assert.match(await page.locator('.cm-lit').textContent(), /^warp\(mesh/)
  await openTab('Costs')
  const { stats } = compileWarp(
    ({ glsl, position }) => glsl.vec3(position.y().mult(3).cos().mult(0.4), 0, 0),
    { surfaceVariation: true },
  )
  const row = await page.locator('#panel tbody td').allTextContents()
  const { nodes, operations, temporaries } = stats
  assert.deepEqual(row.slice(0, 4), ['warp', ...[nodes, operations, temporaries].map(String)])
  await openTab('Checks')
  const [worst, , insideOut] = await readFigures()
  assert.ok(parseFloat(worst) < 0.5, worst)
  assert.match(insideOut, /^0 of 4,608 points$/)
  await openTab('GLSL 3.00')
})

/** Returns the colour of the middle of the picture. */
const middleColor = async () => {
  const at = 4 * (120 * 45 + 60)
  return [...(await canvasPixels(page)).subarray(at, at + 3)]
}

/** Waits until the middle of the picture has a colour, since the picture follows its slider with a delay. */
async function waitForColor(expected, tolerance = 0) {
  let color
  for (let i = 0; i < 100; i++) {
    color = await middleColor()
    if (color.every((part, k) => Math.abs(part - expected[k]) <= tolerance)) return
    await page.waitForTimeout(100)
  }
  assert.deepEqual(color, expected)
}

/** A coloured ball whose size, position and colour depend on uniforms. */
const uniformBall = ball
  .replace('new THREE.MeshNormalMaterial()', "new THREE.MeshBasicMaterial({ color: '#ff8040' })")
  .replace(
    /^warp\(.*$/m,
    `const center = new THREE.Vector3(0, 0.25, 0)
const aside = new THREE.Vector2(0, 0)
const tint = new THREE.Color('#ff0000')
const warped = warp(
  mesh,
  ({ glsl, position, uniforms: { more, center, aside } }) =>
    position.mult(more).add(center).add(glsl.vec3(aside, 0)),
  { uniforms: { more: 0, center, aside, tint } },
)
renderer.setAnimationLoop(() => {
  mesh.material.color.copy(warped.uniforms.tint.value)
  renderer.render(scene, camera)
})`,
  )
  .replace(/^renderer.setAnimationLoop.*render.*$/m, '')

test('shows normals of three.js as colours, and its uniforms as sliders and fields', async () => {
  await write(page, uniformBall)
  assert.equal(await mistake(), '')
  await waitForColor([255, 0, 0])
  const labels = await page.locator('.sliders label').allTextContents()
  assert.deepEqual(labels, [
    'more',
    ...['center.x', 'center.y', 'center.z'],
    ...['aside.x', 'aside.y'],
    'tint',
  ])
  await page.getByLabel('tint').fill('#00ff00')
  await waitForColor([0, 255, 0])
  // Move one slider to the left end and one to the right, so that the ball no longer covers the middle.
  await page.getByLabel('center.x').press('Home')
  await page.getByLabel('center.y').press('End')
  await waitForColor([21, 24, 35])
  await page.getByLabel('Normals as colours').check()
  await write(page, uniformBall.replace('more: 0', 'more: 0.1'))
  assert.equal(await mistake(), '')
  await page.screenshot({ path: `${folder}/playground-three.png` })
  // A moved slider keeps its value.
  const mesh = await loadMesh(
    readFileSync(await (await downloadFromMenu(page, 'Warped shape')).path()),
  )
  const box = [0, 1, 2].map((axis) => mesh.positions.filter((_, i) => i % 3 === axis))
  const ends = box.flatMap((all) => [Math.min(...all), Math.max(...all)])
  for (const [i, end] of [-2.1, 0.1, -0.1, 2.1, -1.1, 1.1].entries())
    assert.ok(Math.abs(ends[i] - end) < 1e-2, `${ends}`)
  await page.getByLabel('center.x').fill('0')
  await page.getByLabel('center.y').fill('0')
  await waitForColor([128, 128, 255], 9)
  await page.getByLabel('Normals as colours').uncheck()
})

test('explains a mistake with operators in three.js, without the box to tick, which three.js does not have', async () => {
  await runOn('three')
  await write(page, ball.replace('position.y().mult(3)', '(position * 3)'))
  assert.match(await mistake(), /do not work on expressions/)
  assert.doesNotMatch(await mistake(), /tick/)
})

test('downloads a page with three.js, its addons and warpjet that opens from a disk', async () => {
  await runOn('three')
  await write(page, ball)
  assert.equal(await mistake(), '')
  const before = await canvasPixels(page)
  await context.addInitScript(keepFrames)
  const { picture } = await drawFromDisk('three', () =>
    document.querySelector('canvas[data-engine]'),
  )
  assert.ok(difference(before, Buffer.alloc(before.length)) > 0.5)
  assert.equal(difference(before, picture), 0)
})

test('logs nothing', () => assert.deepEqual(messages, []))
