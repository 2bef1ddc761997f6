// The examples without a GPU: with fewer pixels and frames, and what can be said of the picture that they draw.
import assert from 'node:assert/strict'
import { coarsenShapes, fewSamples, rough } from './frames.js'

/**
 * Vite plugin for a server of the tests: it gives each context the sketches that `lower` asked for, and libraries for a browser to
 * keep, with what it compiled of them. (Of what the driver answers in the server's place a browser keeps nothing.)
 */
export const sketchesForTests = () =>
  answering((request, path, content) => {
    const [, name] = /^\/examples\/([\w-]+)\/sketch\.js$/.exec(path) ?? []
    const wish = cookie(request, 'sketches')
    return name && wish ? lowered(name, String(content), JSON.parse(wish)) : content
  })

/** Vite plugin: what the server answers by itself, in development, is what `change(request, path, content)` makes of it. */
export const answering = (change) => ({
  name: 'answering',
  enforce: 'pre',
  configureServer({ middlewares }) {
    middlewares.use((request, response, next) => {
      const { end, setHeader } = response
      const path = request.url.split('?')[0]
      response.end = (content, ...how) =>
        end.call(response, content && change(request, path, content), ...how)
      if (/^\/(?:dist|node_modules)\//.test(path))
        response.setHeader = (name, value) =>
          setHeader.call(response, name, name === 'Cache-Control' ? 'max-age=86400' : value)
      next()
    })
  },
})

export function cookie({ headers }, name) {
  const found = (headers.cookie ?? '').split('; ').find((each) => each.startsWith(`${name}=`))
  return found && decodeURIComponent(found.slice(name.length + 1))
}

/** Asks the server at `url`, one of `answering`, for something in all requests of the context. */
export const ask = (context, url, name, value) =>
  context.addCookies([{ name, value: encodeURIComponent(value), url }])

/**
 * Sketches are drawn without smooth edges, and those other than `exceptions` with a sixteenth of their pixels and coarse shapes:
 * without a GPU these are what takes long, lit triangles smaller than a pixel most of all. `before` is what p5 does first, or
 * `still`.
 */
export const lower = (context, url, { exceptions = [], before = '' } = {}) =>
  ask(context, url, 'sketches', JSON.stringify({ exceptions, before }))

function lowered(name, text, { exceptions, before }) {
  const edges = needsSmoothEdges(name) ? '' : `;(${rough})()\n`
  if (exceptions.includes(name)) return `${text}\n${edges}`
  if (name.startsWith('three-'))
    return `${edges};(${fewSamples})()\n${before === still ? twoFrames : ''}${smaller(text)}`
  return `${text}
${edges}${before === still ? standing : ''}{
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
}

/** p5's shapes with a tenth of their triangles, as text for a sketch. */
export const coarseShapes = `;(${coarsenShapes})(p5.prototype, 32)
`

/** Without smooth edges these have few colours, or cover little. */
const needsSmoothEdges = (name) => /^(?:deformer-(?:wave|spherify)|spoon)$/.test(name)

/** A sketch of three.js likewise; without a GPU its thousands of instances and triangles are what takes longest. */
const smaller = (text) =>
  text
    .replaceAll(/setPixelRatio\(.*\)/g, 'setPixelRatio(0.25)')
    .replaceAll(/mapSize\.set\(.*\)/g, 'mapSize.set(256, 256)')
    .replaceAll('10_000', '800')
    .replaceAll(/(PlaneGeometry\(\d+, \d+), \d{3}, \d{3}/g, '$1, 64, 64')

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

/** One frame of that, of the same time on every machine. */
export const still = `
    this.noLoop()${plain}`

/** A warp that moves shows little at some moments: a spoon, bent most, less than is asked. */
const standing = `p5.prototype.millis = () => 2500
`

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
