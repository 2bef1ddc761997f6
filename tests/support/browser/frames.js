// Reduces what pages draw in tests without a GPU, and makes it readable. All functions but `drawLittle` are for `addInitScript`.

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
 * Limits the frames of a page, which take the most time without a GPU: its first `count` frames are immediate, so that its picture
 * appears, and then there is one every 400 milliseconds.
 */
export function fewFrames(count = 3) {
  // The page draws only in frames, and otherwise only asks whether there is WebGL.
  if (location.pathname.includes('/playground/')) return
  const { requestAnimationFrame, cancelAnimationFrame } = window
  const { getContext } = HTMLCanvasElement.prototype
  let free = Infinity
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind.startsWith('webgl')) free = Math.min(free, count)
    return getContext.call(this, kind, options)
  }
  window.requestAnimationFrame = (draw) =>
    free-- > 0
      ? requestAnimationFrame.call(window, draw)
      : -setTimeout(() => draw(performance.now()), 400)
  // Requests by a timer have negative ids.
  window.cancelAnimationFrame = (request) =>
    request < 0 ? clearTimeout(-request) : cancelAnimationFrame.call(window, request)
}

/** Limits p5's shapes to `max` by `max` rectangles; for a page, which has p5's `methods`. */
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

/** Calls `coarsen` with the methods of each p5 that is loaded, and reduces its large canvases to a sixteenth of their pixels. */
function coarsenCanvases(coarsen) {
  function spare(methods) {
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
 * Reduces large canvases of p5 to a sixteenth of their pixels, and its shapes to 32 by 32 rectangles. Sketches whose pictures are
 * checked pixel by pixel use small canvases, which do not change.
 */
export const coarse = { content: `(${coarsenCanvases})(${coarsenShapes})` }

/** `frames` is the number of immediate frames. */
export async function drawLittle(context, frames) {
  for (const script of [disableAntialiasing, fewSamples, coarse])
    await context.addInitScript(script)
  await context.addInitScript(fewFrames, frames)
}

/** The playground waits for three frames of a sketch after its first, and requests them as often as the sketch. */
export const framesInPlayground = 9
