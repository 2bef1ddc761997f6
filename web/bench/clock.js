/**
 * Measures the GPU time of a frame. A timer query measures the GPU alone, and is used if the driver's timer is right.
 * Otherwise a pixel is read back: this ends only after the frame is complete, and adds the same round trip to every method.
 */

/** Returns the milliseconds from the call until the GPU is done. */
function timeByFence(scene, draw) {
  const start = performance.now()
  draw()
  scene.finish()
  return performance.now() - start
}

/** Returns milliseconds, measured by the GPU's own timer; NaN if the driver reports a disjoint measurement. */
async function timeByQuery(scene, extension, draw) {
  const { gl } = scene
  const query = gl.createQuery()
  gl.beginQuery(extension.TIME_ELAPSED_EXT, query)
  draw()
  gl.endQuery(extension.TIME_ELAPSED_EXT)
  scene.finish()
  // A query's result becomes available in a later task of the page, never in the current one.
  const isAvailable = () => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)
  for (let i = 0; i < 100 && !isAvailable(); i++) await new Promise((later) => setTimeout(later))
  const nanoseconds = isAvailable() ? gl.getQueryParameter(query, gl.QUERY_RESULT) : NaN
  gl.deleteQuery(query)
  return gl.getParameter(extension.GPU_DISJOINT_EXT) ? NaN : nanoseconds / 1e6
}

/** Repeats `draw` until it takes 20 ms, so that the round trip of a fence is negligible. */
function repeatFrames(scene, draw) {
  const drawTimes = (count) => () => {
    for (let i = 0; i < count; i++) draw()
  }
  let count = 1
  while (count < 1024 && timeByFence(scene, drawTimes(count)) < 20) count *= 2
  return drawTimes(count)
}

/**
 * @param draw draws a frame to test the timer with
 * @returns { kind, time }: `kind` names the clock, `await time(draw)` returns the milliseconds of a frame
 */
export async function openClock(scene, draw) {
  const extension = scene.gl.getExtension('EXT_disjoint_timer_query_webgl2')
  const fence = { kind: 'readback fence', time: async (frame) => timeByFence(scene, frame) }
  if (!extension) return fence

  // The timers of some drivers do not wait for the GPU: they report zero, or the time to submit the work. So compare the timer with the
  // readback.
  const work = repeatFrames(scene, draw)
  const ratios = []
  for (let i = 0; i < 5; i++) {
    const byQuery = await timeByQuery(scene, extension, work)
    ratios.push(byQuery / timeByFence(scene, work))
  }
  ratios.sort((a, b) => a - b)
  if (!(ratios[2] > 0.5 && ratios[2] < 1.2)) return fence
  return { kind: 'timer query', time: (frame) => timeByQuery(scene, extension, frame) }
}
