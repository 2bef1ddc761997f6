// Reduces what pages draw in tests without a GPU, and makes it readable. All functions but `drawLittle` are for `addInitScript`.

/** Three.js clears its canvas after a frame is shown; this keeps it until it is read. */
export function keepFrames() {
  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
  }
}

/** Turns off antialiasing, which takes two thirds of the time for small triangles. */
export function rough() {
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
 * Without a GPU frames take most time. A page gets its first `count` frames as fast as it can, so that its picture appears, and
 * then one every 400 milliseconds.
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

/** Calls `coarsen` with the methods of each p5 that is loaded, and gives its large canvases a sixteenth of their pixels. */
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
 * Gives large canvases of p5 a sixteenth of their pixels, and limits its shapes to 32 by 32 rectangles. Sketches whose pictures
 * are checked pixel by pixel draw small.
 */
export const coarse = { content: `(${coarsenCanvases})(${coarsenShapes})` }

/** `frames` is the number that a page gets as fast as it can. */
export async function drawLittle(context, frames) {
  for (const script of [rough, fewSamples, coarse]) await context.addInitScript(script)
  await context.addInitScript(fewFrames, frames)
}

/** The playground waits for three frames of a sketch after its first, and requests them as often as the sketch. */
export const framesInPlayground = 9
