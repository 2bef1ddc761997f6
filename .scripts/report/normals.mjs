// Measures normals at vertices and at pixels, for web/docs/normals.md:
// - the angles to the exact normals on p5's sphere;
// - how much pictures of coarse spheres in p5 differ from a picture of a sphere of two million triangles;
// - the same difference for the coarsest sphere with the option `detail` and curved triangles.
// Also draws the two pictures of the slider in web/docs/normals.md.
import assert from 'node:assert/strict'
import { writeFileSync } from 'node:fs'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { readPixels } from '../../tests/support/browser/pixels.js'
import { servePages } from '../../tests/support/browser/server.js'
import { path } from '../lib/files.mjs'
import { say } from '../lib/terminal.mjs'
import { markdownTable } from '../reference/parts.mjs'
import { measureAngles } from './normals/angles.mjs'

const size = 600

/** Maps a name → source of an offset function for a sphere of radius 1. */
const warps = {
  fbm: '({ glsl, position }) => position.mult(glsl.fbm(position.mult(2)).mult(0.3))',
  simplex: '({ glsl, position }) => position.mult(glsl.simplex(position.mult(2)).mult(0.2))',
  wobble: `({ glsl, position }) => glsl.vec3(
    position.y().mult(3).add(2).sin().mult(0.08),
    position.z().mult(2.5).add(1.3).sin().mult(0.08).add(position.x().mult(-4).add(1).sin().mult(0.04)),
    position.x().mult(2).add(1.7).sin().mult(0.08))`,
}

/** The rotations of the sphere about x and y, in radians. */
const views = [
  [0.5, 0.4],
  [-0.4, 2.2],
]

/** [columns, rows] of spheres with 2,000 triangles, and with 4, 16 and 64 times as many. */
const coarse = [40, 25]
const meshes = [coarse, [80, 50], [160, 100], [320, 200]]
/** Two million triangles. */
const reference = [1600, 625]

const formatTriangleCount = ([columns, rows]) => (2 * columns * rows).toLocaleString('en-US')

/** The outline consists of the pixels within this distance of the edge of the sphere, in pixels along x and y. */
const margin = 2

const html = `<!doctype html><meta charset="utf-8"><body>
<script src="/node_modules/p5/lib/p5.min.js"></script><script src="/dist/p5.warpjet.min.js"></script>
<script>
const warps = {}
let scene = () => {}
function setup() {
  pixelDensity(1)
  createCanvas(${size}, ${size}, WEBGL)
  setAttributes({ antialias: false })
  noLoop()
  window.done = true
}
function draw() {
  clear()
  scene()
}
// Counts the triangles of the largest draw.
let triangles = 0
const drawElements = WebGL2RenderingContext.prototype.drawElements
WebGL2RenderingContext.prototype.drawElements = function (mode, count, ...others) {
  triangles = Math.max(triangles, count / 3)
  return drawElements.call(this, mode, count, ...others)
}
function drawSphere(offset, options, [columns, rows], [aboutX, aboutY]) {
  push()
  noStroke()
  lights()
  fill(220, 120, 80)
  specularMaterial(255)
  shininess(30)
  const warp = (warps[offset + JSON.stringify(options)] ??= createWarp((0, eval)(offset), options))
  warp()
  rotateX(aboutX)
  rotateY(aboutY)
  sphere(200, columns, rows)
  pop()
}
/** Draws a warped sphere in a picture of its own, and returns the number of its triangles. */
async function drawPicture(...args) {
  scene = () => drawSphere(...args)
  triangles = 0
  await redraw()
  return triangles
}
/** Returns a picture of two spheres as WebP, in base64. */
async function drawPair([left, right], ...args) {
  resizeCanvas(2 * width, height)
  setAttributes({ antialias: true })
  for (const each in warps) delete warps[each]
  scene = () => {
    background('#151823')
    for (const [offset, x] of [[left, -1], [right, 1]]) {
      push()
      translate((x * width) / 4.2, 0)
      drawSphere(offset, ...args)
      pop()
    }
  }
  await redraw()
  const dataUrl = document.querySelector('canvas').toDataURL('image/webp', 0.85)
  resizeCanvas(width / 2, height)
  setAttributes({ antialias: false })
  for (const each in warps) delete warps[each]
  return dataUrl.split(',')[1]
}
</script>`

/** Returns the indices of pixels that are inside the sphere in all pictures (`inside`) and of the other drawn ones (`outline`). */
function regionsOf(images) {
  const isCovered = (i) => images.every(({ data }) => data[4 * i + 3] > 0)
  const isDrawn = (i) => images.some(({ data }) => data[4 * i + 3] > 0)
  const isInside = (i) => {
    for (let y = -margin; y <= margin; y++)
      for (let x = -margin; x <= margin; x++) if (!isCovered(i + y * size + x)) return false
    return true
  }
  const regions = { inside: [], outline: [] }
  for (let i = 0; i < size * size; i++)
    if (isDrawn(i)) regions[isInside(i) ? 'inside' : 'outline'].push(i)
  return regions
}

/** Returns the mean difference of two pictures at these pixels, on a scale from 0 to 255. */
function meanDifference(image, other, pixels) {
  const components = pixels.flatMap((i) => [4 * i, 4 * i + 1, 4 * i + 2])
  const sum = components.reduce((total, k) => total + Math.abs(image.data[k] - other.data[k]), 0)
  return sum / components.length
}

async function measureView(page, name, view) {
  const draw = async (options, mesh) => {
    const args = [warps[name], options, mesh, view]
    const triangles = await page.evaluate((args) => drawPicture(...args), args)
    return { ...(await readPixels(page)), triangles }
  }
  const exact = await draw({ normals: 'vertex' }, reference)
  const images = { vertex: [], pixel: [] }
  for (const mesh of meshes)
    for (const normals of Object.keys(images)) images[normals].push(await draw({ normals }, mesh))
  const detail = { tolerance: 0.5, curved: true }
  const detailed = await draw({ normals: 'pixel', detail }, coarse)
  const { inside, outline } = regionsOf([exact, ...images.vertex, ...images.pixel, detailed])
  const differences = (pixels) => ({
    pairs: meshes.map((_, i) =>
      ['vertex', 'pixel'].map((normals) => meanDifference(images[normals][i], exact, pixels)),
    ),
    detailed: meanDifference(detailed, exact, pixels),
    triangles: detailed.triangles,
  })
  say(`${name}: ${inside.length} pixels inside, ${outline.length} at the outline`)
  return { inside: differences(inside), outline: differences(outline) }
}

const format = (x) => (x < 10 ? x.toFixed(2) : x.toFixed(1))

async function writePictures(page) {
  for (const normals of ['vertex', 'pixel']) {
    const args = [[warps.fbm, warps.simplex], { normals }, coarse, views[0]]
    const picture = await page.evaluate((list) => drawPair(...list), args)
    writeFileSync(path(`web/docs/normals-${normals}.webp`), Buffer.from(picture, 'base64'))
  }
}

/** Returns tables of the angles, and of the differences inside of the spheres and at their outlines. */
export async function measure() {
  const server = await servePages()
  const browser = await launchBrowser()
  const { page, messages } = await openPage(browser, server.page(html))
  await page.waitForFunction(() => window.done)
  await writePictures(page)
  const rows = { inside: [], outline: [] }
  for (const name of Object.keys(warps))
    for (const [i, view] of views.entries()) {
      const measured = await measureView(page, name, view)
      for (const region of Object.keys(rows)) {
        const { pairs, detailed, triangles } = measured[region]
        const cells = pairs.map((pair) => pair.map(format).join(' / '))
        const last = `${format(detailed)} (${triangles.toLocaleString('en-US')})`
        rows[region].push([`${name}, view ${i + 1}`, ...cells, last])
      }
    }
  await browser.close()
  await server.close()
  assert.deepEqual(messages, [])
  const head = [
    'triangles',
    ...meshes.map(formatTriangleCount),
    `${formatTriangleCount(coarse)}, \`detail\``,
  ]
  return {
    angles: measureAngles(),
    light: markdownTable(head, rows.inside, true),
    outlines: markdownTable(head, rows.outline, true),
  }
}
