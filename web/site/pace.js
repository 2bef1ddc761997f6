/**
 * Limits how often a canvas is drawn, since the GPU, or a CPU in its place, must also show the page. The time to submit a frame says
 * nothing about its cost, so we wait for a fence. (Drawing fewer pixels was tried, too: resizing the canvas takes longer than that saves.)
 */

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** Max milliseconds of a frame that does not hinder the page. */
const maxFrame = 12
/** Max milliseconds of a pause. After a slower frame, the pause is three times its excess over `maxFrame`. */
const maxPause = 400

/** Waits for the end of a frame and pauses after a slow one. Returns true if the frame was fast. Await it after each frame. */
export async function finishFrame(gl) {
  const began = performance.now()
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)
  gl.flush()
  const isDone = () =>
    gl.isContextLost() || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED
  do await sleep(4)
  while (!isDone())
  gl.deleteSync(fence)
  const tooLong = performance.now() - began - maxFrame
  if (tooLong > 0) await sleep(Math.min(maxPause, 3 * tooLong))
  return tooLong <= 0
}
