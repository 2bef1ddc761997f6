// The playground's hosts and languages beside those of playground.test.js: WebGPU, text in GLSL, and downloaded pages of each host.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { difference, path } from './support/bench.js'
import { launchBrowserWithWebGPU } from './support/browser.js'
import { keepFrames } from './support/frames.js'
import {
  canvasPixels,
  openFromDisk,
  openPlayground,
  settled,
  shown,
  still,
  text,
  write,
} from './support/playground.js'

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
const run = async (name) => {
  await host().selectOption(name)
  await settled(page)
  assert.equal(await mistake(), '')
}

/** Opens what is downloaded as a file → what it draws. */
async function drawnFromDisk(name, isReady) {
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

test('draws on WebGPU as in WebGL, and says mistakes there too', async () => {
  await write(page, still('#ff8040', cosine))
  const before = await canvasPixels(page)
  await run('p5-webgpu')
  assert.match(await text(page), /await createCanvas\(120, 90, WEBGPU\)/)
  const frame = await shown(page)
  assert.ok(await frame.evaluate('p5.instance._renderer.device instanceof GPUDevice'))
  assert.ok(difference(before, await canvasPixels(page)) < 0.03)
  await page.getByRole('tab', { name: 'WGSL' }).click()
  assert.match(await page.locator('#panel').textContent(), /var offset: vec3f/)
  await page.locator('.cm-content').focus()
  await write(page, (await text(page)).replace('position.y()', 'position.w()'))
  assert.match(await mistake(), /^Line 5 /)
  await write(page, still('#ff8040', cosine))
  await run('p5')
  assert.equal(difference(before, await canvasPixels(page)), 0)
})

/** The same offset as text. */
const inText = `\`
  vec3 offset(vec3 position) {
    return vec3(cos(position.y * 3.0) * 0.4, 0.0, 0.0);
  }\``

test('reads an offset in GLSL, shows its text, and marks a mistake in it', async () => {
  await write(page, still('#ff8040', cosine))
  const before = await canvasPixels(page)
  const sketch = still('#ff8040').replace(
    /createWarp\(.*\)$/m,
    `createWarp(warpjet.glslOffset(${inText}))`,
  )
  await write(page, sketch)
  assert.notEqual(await mistake(), '')
  await page.getByLabel('Shader text').check()
  await settled(page)
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
  await write(page, still('#40ff40', cosine))
  await run('p5-1')
  const before = await canvasPixels(page)
  const { picture, version } = await drawnFromDisk('p5-1', () => window.frameCount > 1)
  assert.match(version, /^1\.11/)
  assert.equal(difference(before, picture), 0)
})

/** A small sketch of three.js that stands still, of the size of its window. */
const ball = `import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true })
renderer.setSize(120, 90)
document.body.append(renderer.domElement)
const scene = new THREE.Scene()
scene.background = new THREE.Color('#151823')
const camera = new THREE.PerspectiveCamera(40, 4 / 3, 0.1, 100)
camera.position.z = 4
new OrbitControls(camera, renderer.domElement)
const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 40, 30), new THREE.MeshNormalMaterial())
scene.add(mesh)
warp(mesh, ({ glsl, position }) => glsl.vec3(position.y().mult(3).cos().mult(0.4), 0, 0))
renderer.setAnimationLoop(() => renderer.render(scene, camera))
`

test('downloads a page with three.js, its addons and warpjet that opens from a disk', async () => {
  await run('three')
  await write(page, ball)
  assert.equal(await mistake(), '')
  const before = await canvasPixels(page)
  await context.addInitScript(keepFrames)
  const { picture } = await drawnFromDisk('three', () =>
    document.querySelector('canvas[data-engine]'),
  )
  assert.ok(difference(before, Buffer.alloc(before.length)) > 0.5)
  assert.equal(difference(before, picture), 0)
})

test('has printed nothing', () => assert.deepEqual(messages, []))
