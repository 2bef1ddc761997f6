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

/**
 * Without a GPU frames are what takes long. A page that draws gets a handful as fast as it can, so that its picture comes, and
 * from then on four a second.
 */
export function fewFrames() {
  const { requestAnimationFrame, cancelAnimationFrame } = window
  const { getContext } = HTMLCanvasElement.prototype
  let free = Infinity
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind.startsWith('webgl')) free = Math.min(free, 3)
    return getContext.call(this, kind, options)
  }
  window.requestAnimationFrame = (draw) =>
    free-- > 0
      ? requestAnimationFrame.call(window, draw)
      : -setTimeout(() => draw(performance.now()), 250)
  // What was asked for by a timer has a number below zero.
  window.cancelAnimationFrame = (request) =>
    request < 0 ? clearTimeout(-request) : cancelAnimationFrame.call(window, request)
}

export async function drawLittle(context) {
  for (const script of [rough, fewFrames]) await context.addInitScript(script)
}
