// Reduces what pages draw in tests without a GPU, and lets tests read their canvases. All functions but `drawLittle` are for
// `addInitScript`.

/** Preserves the canvas of three.js, which is otherwise cleared after a frame is shown. */
export function keepFrames() {
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
  }
}

/** Disables antialiasing, which takes two thirds of the time for small triangles. */
export function disableAntialiasing() {
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, antialias: false })
  }
}

/** Reduces the 256 samples per pixel by which three.js smooths the reflections of materials, which take seconds. */
export function fewSamples() {
  const { shaderSource } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
    const few = text.replace('#define GGX_SAMPLES 256u', '#define GGX_SAMPLES 8u')
    return shaderSource.call(this, shader, few)
  }
}

/**
 * Limits the animation frames of a page, which take the most time without a GPU: the first `count` frames after it creates a WebGL context
 * are immediate, so that its picture appears, and the later ones are 400 milliseconds apart.
 */
export function fewFrames(count = 3) {
  // The playground draws only in iframes. Its page creates a context only to find out whether there is WebGL.
  if (location.pathname.includes('/playground/')) return
  const { requestAnimationFrame, cancelAnimationFrame } = window
  const { getContext } = HTMLCanvasElement.prototype
  let immediate = Infinity
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind.startsWith('webgl')) immediate = Math.min(immediate, count)
    return getContext.call(this, kind, options)
  }
  window.requestAnimationFrame = (draw) =>
    immediate-- > 0
      ? requestAnimationFrame.call(window, draw)
      : -setTimeout(() => draw(performance.now()), 400)
  // Requests by a timer have negative ids.
  window.cancelAnimationFrame = (request) =>
    request < 0 ? clearTimeout(-request) : cancelAnimationFrame.call(window, request)
}

/** Limits the shapes of p5 to `max` by `max` rectangles. Runs in a page; `methods` is p5's prototype. */
export function coarsenShapes(methods, max) {
  // Maps a shape to the index of its first detail argument.
  const shapes = { plane: 2, sphere: 1, ellipsoid: 3, cylinder: 2, cone: 2, torus: 2 }
  for (const [name, first] of Object.entries(shapes)) {
    const shape = methods[name]
    methods[name] = function (...sizes) {
      const isDetail = (size, i) => i >= first && typeof size === 'number'
      return shape.apply(
        this,
        sizes.map((size, i) => (isDetail(size, i) ? Math.min(size, max) : size)),
      )
    }
  }
}

/** Calls `coarsen` with the prototype of each p5 that is loaded, and reduces large canvases of this p5 to a sixteenth of their pixels. */
function coarsenCanvases(coarsen) {
  function reduce(methods) {
    const { createCanvas, pixelDensity } = methods
    const isLarge = ({ width, height }) => width * height > 160 * 160
    methods.createCanvas = function (...how) {
      const canvas = createCanvas.apply(this, how)
      // A canvas gets the density of the screen, whatever was set before.
      if (isLarge(this)) this.pixelDensity(1)
      return canvas
    }
    methods.pixelDensity = function (density) {
      return pixelDensity.call(this, density && isLarge(this) ? density / 4 : density)
    }
    coarsen(methods, 32)
  }

  const reduced = new WeakSet()
  let p5
  Object.defineProperty(window, 'p5', {
    configurable: true,
    get: () => p5,
    set(value) {
      p5 = value
      const methods = value?.prototype
      if (!methods?.createCanvas || reduced.has(methods)) return
      reduced.add(methods)
      reduce(methods)
    },
  })
}

/**
 * Reduces large canvases of p5 to a sixteenth of their pixels, and its shapes to 32 by 32 rectangles. Sketches whose pictures are
 * checked pixel by pixel use small canvases, which do not change.
 */
export const coarse = { content: `(${coarsenCanvases})(${coarsenShapes})` }

/** Reduces antialiasing, samples, pixels, shapes and frames of all pages of a context. `frames` is the `count` of `fewFrames`. */
export async function drawLittle(context, frames) {
  for (const script of [disableAntialiasing, fewSamples, coarse])
    await context.addInitScript(script)
  await context.addInitScript(fewFrames, frames)
}

/**
 * The number of immediate frames that a sketch in the playground needs: the playground waits until the sketch has drawn three frames after
 * its first, and requests as many frames itself.
 */
export const framesInPlayground = 9
