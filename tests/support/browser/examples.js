// Reduces pixels and frames of the examples, so that they run without a GPU, and checks their pictures.
import assert from 'node:assert/strict'
import { coarsenShapes, disableAntialiasing, fewSamples } from './frames.js'

/**
 * Vite plugin for a test server: serves sketches as reduced as the context's cookie from `reduceSketches` requests. (The browser would
 * cache no responses, and no compiled code of libraries, if Playwright intercepted them instead.)
 */
export const sketchesForTests = () =>
  replaceResponses((request, path, content) => {
    const [, name] = /^\/examples\/([\w-]+)\/sketch\.js$/.exec(path) ?? []
    const reduction = cookie(request, 'sketches')
    return name && reduction ? reduceSketch(name, String(content), JSON.parse(reduction)) : content
  })

/**
 * Vite plugin: replaces the responses of the development server by the results of `change(request, path, content)`, and lets browsers cache
 * libraries.
 */
export const replaceResponses = (change) => ({
  name: 'replace-responses',
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

/** Returns the value of a request's cookie; `undefined` if there is none. */
export function cookie({ headers }, name) {
  const found = (headers.cookie ?? '').split('; ').find((each) => each.startsWith(`${name}=`))
  return found && decodeURIComponent(found.slice(name.length + 1))
}

/** Adds a cookie to all requests of the context to the server at `url`, which uses `replaceResponses`. */
export const addCookie = (context, url, name, value) =>
  context.addCookies([{ name, value: encodeURIComponent(value), url }])

/**
 * Draws sketches without antialiasing and, except `exceptions`, with a sixteenth of their pixels and coarse shapes. Without a GPU, pixels
 * and lit triangles smaller than a pixel take most of the time. `before` is code that runs before each createCanvas() returns, such as
 * `still`.
 */
export const reduceSketches = (context, url, { exceptions = [], before = '' } = {}) =>
  addCookie(context, url, 'sketches', JSON.stringify({ exceptions, before }))

function reduceSketch(name, text, { exceptions, before }) {
  const edges = needsSmoothEdges(name) ? '' : `;(${disableAntialiasing})()\n`
  if (exceptions.includes(name)) return `${text}\n${edges}`
  if (name.startsWith('three-'))
    return `${edges};(${fewSamples})()\n${before === still ? twoFrames : ''}${reduceThreeSketch(text)}`
  return `${text}
${edges}${before === still ? fixedTime : ''}{
  const { createCanvas, pixelDensity } = p5.prototype
  p5.prototype.createCanvas = function (...size) {
    const canvas = createCanvas.apply(this, size)
    // A canvas gets the density of the screen, whatever was set before.
    this.pixelDensity(1)
    ${before}
    return canvas
  }
  p5.prototype.pixelDensity = function (density) {
    return pixelDensity.call(this, density && density / 4)
  }
${coarseShapes}}`
}

/** Code for a sketch that limits p5's shapes to about a tenth of their default triangles. */
export const coarseShapes = `;(${coarsenShapes})(p5.prototype, 32)
`

/** Tests for examples that without antialiasing have too few colours, or cover too few pixels. */
const needsSmoothEdges = (name) => /^(?:deformer-(?:wave|spherify)|spoon)$/.test(name)

/** Reduces a sketch of three.js, whose thousands of instances and triangles take the most time without a GPU. */
const reduceThreeSketch = (text) =>
  text
    .replaceAll(/setPixelRatio\(.*\)/g, 'setPixelRatio(0.25)')
    .replaceAll(/mapSize\.set\(.*\)/g, 'mapSize.set(256, 256)')
    .replaceAll('10_000', '800')
    .replaceAll(/(PlaneGeometry\(\d+, \d+), \d{3}, \d{3}/g, '$1, 64, 64')

/** Stops the sketch after two frames: the next example would otherwise wait for its frames. */
const twoFrames = `
{
  const { requestAnimationFrame } = window
  let frames = 0
  window.requestAnimationFrame = (draw) => frames++ < 2 && requestAnimationFrame(draw)
}
`

/** Removes the edges of shapes. Warps do not draw them, and p5 takes seconds to compute those of a model. */
export const withoutEdges = `
    p5.Geometry.prototype._edgesToVertices = function () { return this }`

/** Draws one frame without edges, at a fixed time. */
export const still = `
    this.noLoop()${withoutEdges}`

/** Fixes the time, since at some moments little is visible: a spoon at its max bend covers less than the threshold. */
const fixedTime = `p5.prototype.millis = () => 2500
`

/** Returns the number of colours in the canvas, in steps of 8, and the fraction of it that is not background. */
export const measurePicture = (frame) =>
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
