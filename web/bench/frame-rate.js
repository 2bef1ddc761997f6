/** Measures frames per second as a visitor sees them: drawn by requestAnimationFrame, each with a new time. */
import { methods } from './methods.js'
import { fragmentShader, vertexShader } from './shaders.js'

/** Waits for the next frame and returns its start time. */
const nextFrame = async () => {
  await new Promise(requestAnimationFrame)
  return performance.now()
}

/** The warm-up before a measurement, as a fraction of its duration, until page and GPU run at a steady pace. */
const WARM_UP = 0.3

/**
 * Measures frames per second over `duration` milliseconds, or over two frames if these take longer. `draw(frame)` is awaited and must
 * end when the GPU is done: a browser without a cap requests frames faster than they can be drawn, and would queue them for minutes.
 */
export async function framesPerSecond(draw, duration) {
  let frame = 0
  // Measures from the start of the first frame to the start of the frame after the last.
  async function drawFor(milliseconds, minFrames) {
    const start = await nextFrame()
    for (let count = 1; ; count++) {
      await draw(frame++)
      const elapsed = (await nextFrame()) - start
      if (count >= minFrames && elapsed >= milliseconds) return (1000 * count) / elapsed
    }
  }
  await drawFor(WARM_UP * duration, 1)
  return drawFor(duration, 2)
}

/**
 * @param scene with the workload's mesh loaded
 * @param h the step of finite differences
 * @param duration milliseconds of the measurement
 */
export async function frameRate(scene, workload, name, h, duration) {
  const method = methods.find((method) => method.name === name)
  const program = scene.program(vertexShader(method.program(workload)), fragmentShader(method.flat))
  const rate = await framesPerSecond((frame) => {
    scene.draw(program, { millis: 16 * frame, h })
    scene.finish()
  }, duration)
  scene.gl.deleteProgram(program)
  return rate
}
