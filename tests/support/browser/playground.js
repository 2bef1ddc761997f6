// Helpers for the tests of the playground.
import { pathToFileURL } from 'node:url'
import { desktop, pixels } from './bench.js'
import { openPage } from './browser.js'
import { drawLittle, framesInPlayground } from './frames.js'
import { serveSources } from './site.js'

const timeoutOptions = { timeout: 120_000 }

/** Waits until the edited sketch is shown, or an error. */
export const waitUntilSettled = (page) =>
  page.waitForFunction(
    () =>
      document.querySelector('main')?.ariaBusy === 'false' &&
      document.querySelector('.cm-content') !== null,
    null,
    timeoutOptions,
  )

/** Returns the complete text in the editor. */
export const editorText = (page) =>
  page.locator('.cm-content').evaluate((content) => content.cmTile.view.state.doc.toString())

/** Replaces the sketch, like pasting. */
export async function write(page, sketch) {
  await page.locator('.cm-content').focus()
  await page.keyboard.press('Control+a')
  await page.keyboard.insertText(sketch)
  // The editor updates its page a moment later.
  for (let i = 0; (await editorText(page)) !== sketch && i < 100; i++) await page.waitForTimeout(50)
  await waitUntilSettled(page)
}

/** Returns the line of the cursor. */
export const cursorLine = (page) => page.locator('.cm-activeLine').textContent()

/** Drags the first number with the text `number` to the right by `pixels`, in small steps. */
export async function dragNumber(page, number, pixels) {
  const numberElement = page.locator('.cm-number').getByText(number, { exact: true }).first()
  const { x, y, width, height } = await numberElement.boundingBox()
  const [from, at] = [x + width / 2, y + height / 2]
  await page.mouse.move(from, at)
  await page.mouse.down()
  for (let moved = 20; moved <= pixels; moved += 20) await page.mouse.move(from + moved, at)
  await page.mouse.up()
}

/** Returns the frame of the visible picture: a sandboxed frame inside another frame of the playground. */
export async function visibleFrame(page) {
  const host = await (await page.waitForSelector('.stage iframe', timeoutOptions)).contentFrame()
  const element = await host.waitForSelector('iframe.shown', timeoutOptions)
  return element.contentFrame()
}

const isPlayground = (page) => page.locator('.playground').count()

/** Returns the RGBA of the visible canvas. */
export const canvasPixels = async (page) =>
  pixels((await isPlayground(page)) ? await visibleFrame(page) : page)

/** Returns a sketch of a sphere of one color that `offset` moves. It is static unless the offset reads the time. */
export const stillSketch = (color, offset = 'glsl.vec3(0, 0, 0)', more = '') => `let warp
function setup() {
  createCanvas(120, 90, WEBGL)
  noStroke()
  warp = createWarp(({ glsl, position, uniforms }) => ${offset}${more})
}
function draw() {
  background('#151823')
  fill('${color}')
  warp()
  sphere(30, 24, 16)
}
`

/** A small static sketch with three.js; it has the same size as `stillSketch`. */
export const ball = `import * as THREE from 'three'
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

/** Saves by the button `title` of the menu. Returns Playwright's download. */
export async function downloadFromMenu(page, title) {
  await page.getByText('Save', { exact: true }).click()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: title }).click(),
  ])
  return download
}

/** Saves the page that opens anywhere as `file`, and opens it from the disk. Returns { page, messages }. */
export async function openFromDisk(page, file, isReady = () => window.frameCount > 1) {
  await (await downloadFromMenu(page, 'Page that opens anywhere')).saveAs(file)
  const opened = await openPage(page.context(), pathToFileURL(file).href)
  await opened.page.waitForFunction(isReady, null, timeoutOptions)
  return opened
}

/** Opens a playground with its own server, and waits until it is idle. Returns { page, messages, context, close }. */
export async function openPlayground(port, browser) {
  const server = await serveSources(port)
  const context = await browser.newContext({ ...desktop, reducedMotion: 'reduce' })
  await drawLittle(context, framesInPlayground)
  const [url] = server.resolvedUrls.local
  const { page, messages } = await openPage(context, `${url}playground/index.html`)
  await waitUntilSettled(page)
  const close = async () => {
    await context.close()
    await browser.close()
    await server.close()
  }
  return { page, messages, context, close }
}
