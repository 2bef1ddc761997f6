// What pages of the tests draw, without a GPU: less of it, and so that it can be looked at. All but `drawLittle` are for
// `addInitScript`.

/** Three.js leaves its canvas empty once a frame is shown: so it stays until somebody has looked. */
export function keepFrames() {
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
  }
}

/** Without smooth edges, which take two thirds of the time where triangles are small. */
export function rough() {
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, antialias: false })
  }
}

/** What three.js's materials mirror is smoothed by 256 samples a pixel, which takes seconds. */
export function fewSamples() {
  const { shaderSource } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
    const few = text.replace('#define GGX_SAMPLES 256u', '#define GGX_SAMPLES 8u')
    return shaderSource.call(this, shader, few)
  }
}

/**
 * Without a GPU frames are what takes long. A page that draws gets `most` as fast as it can, so that its picture comes, and from
 * then on one every 400 milliseconds.
 */
export function fewFrames(most = 3) {
  // It draws in frames alone, and only asks whether there is a WebGL.
  if (location.pathname.includes('/playground/')) return
  const { requestAnimationFrame, cancelAnimationFrame } = window
  const { getContext } = HTMLCanvasElement.prototype
  let free = Infinity
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind.startsWith('webgl')) free = Math.min(free, most)
    return getContext.call(this, kind, options)
  }
  window.requestAnimationFrame = (draw) =>
    free-- > 0
      ? requestAnimationFrame.call(window, draw)
      : -setTimeout(() => draw(performance.now()), 400)
  // What was asked for by a timer has a number below zero.
  window.cancelAnimationFrame = (request) =>
    request < 0 ? clearTimeout(-request) : cancelAnimationFrame.call(window, request)
}

/** p5's shapes get no more than `most` by `most` rectangles; for a page, which has p5's `methods`. */
export function coarsenShapes(methods, most) {
  // Where the numbers for detail begin among those that a shape takes.
  const shapes = { plane: 2, sphere: 1, ellipsoid: 3, cylinder: 2, cone: 2, torus: 2 }
  for (const [name, first] of Object.entries(shapes)) {
    const shape = methods[name]
    methods[name] = function (...sizes) {
      const isDetail = (size, i) => i >= first && typeof size === 'number'
      return shape.apply(
        this,
        sizes.map((size, i) => (isDetail(size, i) ? Math.min(size, most) : size)),
      )
    }
  }
}

/** Calls `coarsen` with the methods of each p5 that comes, and gives its large canvases a sixteenth of their pixels. */
function coarsenCanvases(coarsen) {
  function spare(methods) {
    const { createCanvas, pixelDensity } = methods
    const isLarge = ({ width, height }) => width * height > 160 * 160
    methods.createCanvas = function (...how) {
      const canvas = createCanvas.apply(this, how)
      // It comes with the density of the screen, whatever was asked for before.
      if (isLarge(this)) this.pixelDensity(1)
      return canvas
    }
    methods.pixelDensity = function (density) {
      return pixelDensity.call(this, density && isLarge(this) ? density / 4 : density)
    }
    coarsen(methods, 32)
  }

  const known = new WeakSet()
  let p5
  Object.defineProperty(window, 'p5', {
    configurable: true,
    get: () => p5,
    set(given) {
      p5 = given
      const methods = given?.prototype
      if (!methods?.createCanvas || known.has(methods)) return
      known.add(methods)
      spare(methods)
    },
  })
}

/**
 * Of p5's canvases the large ones get a sixteenth of their pixels, and its shapes no more than 32 by 32 rectangles. What is asked
 * of a picture pixel by pixel is drawn small by its sketch.
 */
export const coarse = { content: `(${coarsenCanvases})(${coarsenShapes})` }

/** `frames` are those that a page gets as fast as it can. */
export async function drawLittle(context, frames) {
  for (const script of [rough, fewSamples, coarse]) await context.addInitScript(script)
  await context.addInitScript(fewFrames, frames)
}

/** Of a sketch the playground waits for three frames after its first, and asks for them as often as it. */
export const framesInPlayground = 9
