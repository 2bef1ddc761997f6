/** Frames a second as somebody sees them: drawn as the browser asks for them, each with a new time. */
import { methods } from './methods.js'
import { fragmentShader, vertexShader } from './shaders.js'

/** Starts the next frame → when that is. */
const nextFrame = async () => {
  await new Promise(requestAnimationFrame)
  return performance.now()
}

/** The part of a measurement that goes before it, for page and GPU to come to a steady pace. */
const SETTLING = 0.3

/**
 * Frames a second, in `duration` milliseconds, or in two frames that take longer. `draw(frame)`, which is awaited, ends when the GPU is
 * done: a browser without a limit asks for frames faster than they can be drawn, and would let them queue for minutes.
 */
export async function framesASecond(draw, duration) {
  let frame = 0
  // From the start of a frame to the start of the one that follows the last.
  async function drawFor(milliseconds, leastFrames) {
    const start = await nextFrame()
    for (let count = 1; ; count++) {
      await draw(frame++)
      const passed = (await nextFrame()) - start
      if (count >= leastFrames && passed >= milliseconds) return (1000 * count) / passed
    }
  }
  await drawFor(SETTLING * duration, 1)
  return drawFor(duration, 2)
}

/**
 * @param scene with the workload's mesh loaded
 * @param h the step of finite differences
 * @param duration of the measurement, in milliseconds
 */
export async function frameRate(scene, workload, name, h, duration) {
  const method = methods.find((method) => method.name === name)
  const program = scene.program(vertexShader(method.program(workload)), fragmentShader(method.flat))
  const rate = await framesASecond((frame) => {
    scene.draw(program, { millis: 16 * frame, h })
    scene.finish()
  }, duration)
  scene.gl.deleteProgram(program)
  return rate
}
