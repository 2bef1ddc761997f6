// Counts holes in the pictures of a sketch in which the camera moves around closed shapes that are warped with detail.
import assert from 'node:assert/strict'
import { leavePage } from './browser.js'
import { breakEdge, countHoles } from './holes.js'

const size = 128

/**
 * Draws frames. Returns { holes, framesWithHoles, least, indexUploads, broken }: the number of pixels in holes, the number of frames with holes, the
 * smallest number of pixels that the shapes cover, how often indices were uploaded, and how many of these uploads had an edge that
 * `isBroken` breaks on purpose. The shapes are white, and everything behind and inside of them is magenta.
 */
export async function watchHoles(host, { frames, isBroken = false, tolerance = 1 }) {
  const { page, messages } = await host.open(`
    p5.disableFriendlyErrors = true
    const size = ${size}
    const isWebGPU = ${host.isWebGPU}
    ${countHoles}
    ${breakEdge}
    let moving, uploads = [], indexUploads = 0, broken = 0

    /** Returns the indices to upload. */
    function changeIndices(values) {
      indexUploads++
      if (!${isBroken}) return values
      const copy = values.slice()
      if (breakEdge(copy, uploads[0], 3, 53 * indexUploads)) broken++
      return copy
    }

    /** Records attributes, and changes indices. Detail uploads positions first, then the other attributes, and indices last. */
    function watch(isIndices, args, at) {
      const values = args[at]
      if (isIndices && values instanceof Uint32Array) {
        args[at] = changeIndices(values)
        uploads = []
      } else if (values instanceof Float32Array) uploads.push(values)
    }

    function watchUploads() {
      if (isWebGPU) {
        const { device } = p5.instance._renderer
        const { writeBuffer } = device.queue
        device.queue.writeBuffer = function (...args) {
          if (args[0].usage & (GPUBufferUsage.INDEX | GPUBufferUsage.VERTEX))
            watch(args[0].usage & GPUBufferUsage.INDEX, args, 2)
          return writeBuffer.apply(this, args)
        }
        // We cannot watch indices that compute passes write, so the passes must fail.
        if (${isBroken}) device.createComputePipelineAsync = () => Promise.reject(new Error('none'))
        return
      }
      const gl = drawingContext
      const { bufferData } = gl
      gl.bufferData = function (...args) {
        watch(args[0] === gl.ELEMENT_ARRAY_BUFFER, args, 1)
        return bufferData.apply(this, args)
      }
    }

    async function setup() {
      pixelDensity(1)
      ${host.canvas(size, size)}
      // With several samples per pixel, some samples at edge-on triangles would show the inside of any mesh.
      await setAttributes('antialias', false)
      noLoop()
      watchUploads()
      moving = createWarp(
        ({ position, uniforms }) =>
          position.mult(position.mult(2).add(uniforms.shift).simplex().mult(0.15)),
        { uniforms: { shift: 0 }, detail: ${tolerance} },
      )
      window.done = true
    }

    function draw() {
      background(255, 0, 255)
      noStroke()
      // The camera stays near the plane of the torus, so that it never looks through the torus.
      const angle = frameCount / 50
      const distance = 330 + 70 * cos(frameCount / 30)
      const [x, y] = [distance * cos(angle), distance * sin(angle)]
      perspective(0.75, 1, 10, 1000)
      camera(x, y, 40 * sin(frameCount / 20), 0, 0, 0, 0, 0, 1)
      for (const isInside of [true, false]) {
        push()
        if (isInside) fill(255, 0, 255)
        else {
          fill(255)
          // Lights make p5 use its material shaders, which are those that are warped.
          ambientLight(255)
          moving({ shift: frameCount / 40 })
        }
        translate(0, 0, -85)
        isInside ? sphere(20, 24, 16) : sphere(36, 24, 16)
        translate(0, 0, 85)
        isInside ? torus(28, 5) : torus(28, 15)
        translate(0, 0, 85)
        isInside ? box(24) : box(54)
        pop()
      }
    }

    function readBytes() {
      if (!isWebGPU) {
        const data = new Uint8Array(4 * size * size)
        drawingContext.bindFramebuffer(drawingContext.FRAMEBUFFER, null)
        drawingContext.readPixels(0, 0, size, size, drawingContext.RGBA, drawingContext.UNSIGNED_BYTE, data)
        return data
      }
      window.copied ??= new OffscreenCanvas(size, size).getContext('2d', { willReadFrequently: true })
      window.copied.drawImage(document.querySelector('canvas'), 0, 0)
      return window.copied.getImageData(0, 0, size, size).data
    }

    async function watchFrames(frames) {
      const found = { holes: 0, framesWithHoles: 0, least: size * size }
      for (let i = 0; i < frames; i++) {
        await redraw()
        const data = readBytes()
        const isOpen = (i) => data[4 * i + 1] < 250
        const holes = countHoles(size, isOpen)
        found.holes += holes
        found.framesWithHoles += holes > 0
        let white = 0
        for (let i = 0; i < size * size; i++) white += !isOpen(i)
        found.least = Math.min(found.least, white)
      }
      return { ...found, indexUploads, broken }
    }`)
  assert.deepEqual(messages, [])
  const found = await page.evaluate((frames) => watchFrames(frames), frames)
  await leavePage(page)
  assert.deepEqual(messages, [])
  return found
}
