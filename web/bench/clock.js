/**
 * How long the GPU takes for a frame. A timer query, where the driver has one that tells the truth, sees the GPU alone; else a
 * pixel is read back, which cannot return before the frame is done and adds one round trip to every method alike.
 */

/** Milliseconds from the call to the GPU's end. */
function fenced(scene, draw) {
  const start = performance.now()
  draw()
  scene.finish()
  return performance.now() - start
}

/** Milliseconds as the GPU's own timer counts them; NaN where something else disturbed it. */
async function queried(scene, extension, draw) {
  const { gl } = scene
  const query = gl.createQuery()
  gl.beginQuery(extension.TIME_ELAPSED_EXT, query)
  draw()
  gl.endQuery(extension.TIME_ELAPSED_EXT)
  scene.finish()
  // Results come with a later task of the page, never within this one.
  const isThere = () => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)
  for (let i = 0; i < 100 && !isThere(); i++) await new Promise((later) => setTimeout(later))
  const nanoseconds = isThere() ? gl.getQueryParameter(query, gl.QUERY_RESULT) : NaN
  gl.deleteQuery(query)
  return gl.getParameter(extension.GPU_DISJOINT_EXT) ? NaN : nanoseconds / 1e6
}

/** So many frames in a row that the round trip of a fence is little beside them. */
function longWork(scene, draw) {
  const times = (count) => () => {
    for (let i = 0; i < count; i++) draw()
  }
  let count = 1
  while (count < 1024 && fenced(scene, times(count)) < 20) count *= 2
  return times(count)
}

/**
 * @param draw a frame, to try the timer on
 * @returns { kind, time }: `kind` says which clock it is, `await time(draw)` the milliseconds of a frame
 */
export async function openClock(scene, draw) {
  const extension = scene.gl.getExtension('EXT_disjoint_timer_query_webgl2')
  const fence = { kind: 'readback fence', time: async (frame) => fenced(scene, frame) }
  if (!extension) return fence

  // A driver may answer at once, with zero, or with the time of handing the work over.
  const work = longWork(scene, draw)
  const trusted = []
  for (let i = 0; i < 5; i++) {
    const own = await queried(scene, extension, work)
    trusted.push(own / fenced(scene, work))
  }
  trusted.sort((a, b) => a - b)
  if (!(trusted[2] > 0.5 && trusted[2] < 1.2)) return fence
  return { kind: 'timer query', time: (frame) => queried(scene, extension, frame) }
}
