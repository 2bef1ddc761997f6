/**
 * How often a canvas is drawn: the GPU has the page to show, too, and where there is none the CPU is one. A frame that was called for
 * tells nothing, so we ask when it is done. (Fewer pixels were tried as well: a canvas takes longer to change its size than they save.)
 */

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** Milliseconds for a frame that are no hindrance to the page. */
const light = 12
/** Milliseconds; after a heavier one the page has the GPU for three times what it was too long, but for no longer than this. */
const longest = 400

/** To be awaited after each frame → whether that was light. */
export async function rest(gl) {
  const began = performance.now()
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)
  gl.flush()
  const isDone = () =>
    gl.isContextLost() || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED
  do await sleep(4)
  while (!isDone())
  gl.deleteSync(fence)
  const tooLong = performance.now() - began - light
  if (tooLong > 0) await sleep(Math.min(longest, 3 * tooLong))
  return tooLong <= 0
}
