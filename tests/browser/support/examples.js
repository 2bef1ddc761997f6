// The examples without a GPU: with fewer pixels and frames, and what can be said of the picture that they draw.
import assert from 'node:assert/strict'
import { coarsenShapes } from './frames.js'

/**
 * Sketches other than `exceptions` are drawn with a sixteenth of their pixels and coarse shapes: without a GPU these are what
 * takes long, lit triangles smaller than a pixel most of all.
 */
export const lower = (context, { exceptions = [], before = '' } = {}) =>
  context.route('**/examples/*/sketch.js', async (route) => {
    const [, name] = /([\w-]+)\/sketch\.js/.exec(route.request().url())
    const response = await route.fetch()
    if (exceptions.includes(name)) return route.fulfill({ response })
    if (name.startsWith('three-'))
      return route.fulfill({
        response,
        body: (before === still ? twoFrames : '') + (await smaller(response)),
      })
    const body = `${await response.text()}
{
  const { createCanvas, pixelDensity } = p5.prototype
  p5.prototype.createCanvas = function (...size) {
    const canvas = createCanvas.apply(this, size)
    // A canvas comes with the density of the screen, whatever was asked for before.
    this.pixelDensity(1)
    ${before}
    return canvas
  }
  p5.prototype.pixelDensity = function (density) {
    return pixelDensity.call(this, density && density / 4)
  }
${coarseShapes}}`
    await route.fulfill({ response, body })
  })

/**
 * Closes a context of `lower`. The site's worker fetches sketches in the background: one that is under way would fail the whole file
 * of tests, whose tests all passed.
 */
export async function closeLowered(context) {
  await context.unrouteAll({ behavior: 'ignoreErrors' })
  await context.close()
}

/** p5's shapes with a tenth of their triangles, as text for a sketch. */
export const coarseShapes = `;(${coarsenShapes})(p5.prototype, 48)
`

/** A sketch of three.js likewise; without a GPU its thousands of instances are what takes longest. */
const smaller = async (response) =>
  (await response.text())
    .replaceAll(/setPixelRatio\(.*\)/g, 'setPixelRatio(0.25)')
    .replaceAll(/mapSize\.set\(.*\)/g, 'mapSize.set(256, 256)')
    .replaceAll('10_000', '800')

/** The first shows what the second has to draw: then no more, which the next example would wait for. */
const twoFrames = `
{
  const { requestAnimationFrame } = window
  let frames = 0
  window.requestAnimationFrame = (draw) => frames++ < 2 && requestAnimationFrame(draw)
}
`

/** Without the edges of shapes: the warp draws none, and p5 takes seconds to work out those of a model. */
export const plain = `
    p5.Geometry.prototype._edgesToVertices = function () { return this }`

/** One frame of that. */
export const still = `
    this.noLoop()${plain}`

/** How many colours the canvas has, in steps of 8, and which share of it is not background. */
export const statistics = (frame) =>
  frame.evaluate(() => {
    const source = document.querySelector('.p5Canvas, canvas[data-engine]')
    const copy = new OffscreenCanvas(source.width, source.height).getContext('2d')
    copy.drawImage(source, 0, 0)
    const { data } = copy.getImageData(0, 0, source.width, source.height)
    const counts = new Map()
    for (let i = 0; i < data.length; i += 4) {
      const color = data
        .subarray(i, i + 3)
        .map((value) => value >> 3)
        .join()
      counts.set(color, (counts.get(color) ?? 0) + 1)
    }
    const background = Math.max(...counts.values())
    return { colors: counts.size, covered: 1 - (4 * background) / data.length }
  })

export function assertPicture({ colors, covered }) {
  assert.ok(colors >= 30, `only ${colors} colours`)
  assert.ok(covered >= 0.03 && covered <= 0.9, `${(100 * covered).toFixed()}% are not background`)
}
