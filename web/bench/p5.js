/** Measures the cost of a warp in a sketch for each supported version of p5: draws the same sketch with and without the warp, in turn. */
import { framesPerSecond } from './frame-rate.js'
import { medianRatio, quantile, shuffle, summarize } from './statistics.js'

/** Paths on the benchmark's server. */
const libraries = ['/node_modules/p5-v1/lib/p5.min.js', '/node_modules/p5/lib/p5.min.js']

/** Opens a sketch in its own iframe, because a page can hold only one p5. */
async function openSketch(p5, size, millis) {
  const frame = document.createElement('iframe')
  frame.src = `p5-sketch.html?${new URLSearchParams({ p5, size, millis })}`
  Object.assign(frame, { width: size, height: size })
  Object.assign(frame.style, { position: 'fixed', inset: 0, border: 0 })
  document.body.append(frame)
  await new Promise((loaded) => (frame.onload = loaded))
  return { frame, ...(await frame.contentWindow.sketch) }
}

/**
 * Opens the sketches, passes them to `work`, each with and without the warp, and closes them. A sketch is hidden until its show() is
 * called.
 */
async function withSketches({ size, millis }, work) {
  const sketches = []
  const show = (shown) => {
    for (const sketch of sketches) sketch.frame.hidden = sketch !== shown
  }
  try {
    for (const p5 of libraries) sketches.push(await openSketch(p5, size, millis))
    show(undefined)
    const variants = (sketch) =>
      [false, true].map((isWarped) => ({
        method: nameOf(sketch, isWarped),
        unwarped: nameOf(sketch, false),
        vertices: sketch.vertices,
        show: () => show(sketch),
        draw: () => sketch.draw(isWarped),
      }))
    return await work(sketches.flatMap(variants))
  } finally {
    for (const { frame } of sketches) frame.remove()
  }
}

const nameOf = ({ version }, isWarped) => `p5 ${version}, ${isWarped ? 'warpjet' : 'no warp'}`

/** Measures frames in milliseconds from the call of p5's redraw() until the GPU is done. Returns at least one time. */
async function timeFrames({ draw }, { frames, turn = Infinity }) {
  const times = []
  const end = performance.now() + turn
  while (!times.length || (times.length < frames && performance.now() < end)) {
    const start = performance.now()
    await draw()
    times.push(performance.now() - start)
  }
  return times
}

/**
 * @param settings { size, millis, rounds, frames, turn? }: the canvas size in pixels; the time of the warp; the others as in measure.js
 * @returns { clock, vertices, results: [{ method, frame, toNoWarp }] }: `frame` is { median, low, high } in milliseconds, `toNoWarp`
 * the ratio to a frame of the same sketch without the warp, taken within a round
 */
export async function measureP5(settings) {
  const cells = new Map()
  let vertices
  for (let round = 0; round < settings.rounds; round++) {
    // Each round opens new sketches, because recompiling the same source can change the frame time.
    await withSketches(settings, async (sketches) => {
      for (const sketch of sketches) {
        const { method, unwarped } = sketch
        if (!cells.has(method)) cells.set(method, { method, unwarped, times: [], medians: [] })
        vertices = sketch.vertices
        await sketch.draw()
      }
      for (const sketch of shuffle(sketches)) {
        const times = await timeFrames(sketch, settings)
        const cell = cells.get(sketch.method)
        cell.times.push(...times)
        cell.medians.push(quantile(times))
      }
    })
  }
  return {
    clock: 'readback fence',
    vertices,
    results: [...cells.values()].map(({ method, unwarped, times, medians }) => ({
      method,
      frame: summarize(times),
      toNoWarp: medianRatio(medians, cells.get(unwarped).medians),
    })),
  }
}

/** @param settings { size, millis, duration } @returns frames per second by method */
export const p5FrameRates = (settings) =>
  withSketches(settings, async (sketches) => {
    const rates = {}
    for (const { method, show, draw } of sketches) {
      show()
      rates[method] = await framesPerSecond(draw, settings.duration)
    }
    return rates
  })
