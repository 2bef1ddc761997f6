// Starts sketches in instance mode on WEBGPU canvases, and records their divided shapes.

export const size = 240

export const errors = []

/** The buffers of our passes that are not destroyed. */
export const buffers = new Set()

const isOurs = ({ label }) => label.startsWith('warpjet detail')

/** Records the errors of a device and our buffers, and lets tests read the buffers. */
function watch(device) {
  device.addEventListener('uncapturederror', ({ error }) => errors.push(error.message))
  const { createBuffer } = device
  device.createBuffer = (settings) => {
    const { MAP_READ, MAP_WRITE, COPY_SRC } = GPUBufferUsage
    const usage =
      settings.usage & (MAP_READ | MAP_WRITE) ? settings.usage : settings.usage | COPY_SRC
    const buffer = createBuffer.call(device, { ...settings, usage })
    if (!isOurs(buffer)) return buffer
    buffers.add(buffer)
    const { destroy } = buffer
    buffer.destroy = () => {
      buffers.delete(buffer)
      destroy.call(buffer)
    }
    return buffer
  }
}

/** The divided shapes that were drawn since the last picture began. */
const draws = []

/** Records the calls of all render passes. */
function recordDraws() {
  const bound = new WeakMap()
  const stateOf = (pass) => bound.get(pass) ?? bound.set(pass, {}).get(pass)
  const replace = (name, record) => {
    const call = GPURenderPassEncoder.prototype[name]
    GPURenderPassEncoder.prototype[name] = function (...given) {
      record(stateOf(this), ...given)
      return call.apply(this, given)
    }
  }
  replace('setIndexBuffer', (now, index) => (now.index = index))
  replace('setVertexBuffer', (now, slot, buffer, offset) => {
    if (slot === 0) now.positions = { buffer, offset }
  })
  const add = (now, drawn) => isOurs(now.index) && draws.push({ ...now, ...drawn })
  replace('drawIndexed', (now, count) => add(now, { count }))
  replace('drawIndexedIndirect', (now, indirectBuffer) => add(now, { indirectBuffer }))
}
recordDraws()

export const wait = (time) => new Promise((resolve) => setTimeout(resolve, time))

/** Copies the picture of a canvas, which is lost when the page continues. */
function copyOf(canvas) {
  const { width, height } = canvas
  const copy = new OffscreenCanvas(width, height).getContext('2d')
  copy.drawImage(canvas, 0, 0)
  return copy.getImageData(0, 0, width, height)
}

/**
 * Starts a sketch with a canvas of its own. `draw(p, i)` draws picture i. Without passes, the CPU divides all shapes. If
 * `isSharp`, the canvas has no antialiasing.
 * Returns { p, picture(i), read(draw), begin(i), remove() }.
 */
export async function startSketch({ setup = () => {}, draw, hasPasses = true, isSharp }) {
  let pending
  const p = await new Promise((resolve) => {
    new p5((p) => {
      p.setup = async () => {
        p.pixelDensity(1)
        await p.createCanvas(size, size, p.WEBGPU)
        if (isSharp) await p.setAttributes('antialias', false)
        const { device } = p._renderer
        watch(device)
        if (!hasPasses) device.createComputePipelineAsync = () => Promise.reject(new Error('none'))
        p.noLoop()
        setup(p)
      }
      p.draw = () => {
        if (!pending) return resolve(p)
        p.background(0)
        p.push()
        draw(p, pending.shift())
        p.pop()
      }
    })
  })
  await wait(20)
  const { device } = p._renderer
  const read = async (buffer, Numbers, offset, bytes) => {
    const copy = device.createBuffer({
      size: bytes,
      usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST,
    })
    const encoder = device.createCommandEncoder()
    encoder.copyBufferToBuffer(buffer, offset, copy, 0, bytes)
    device.queue.submit([encoder.finish()])
    await copy.mapAsync(GPUMapMode.READ)
    const values = new Numbers(copy.getMappedRange().slice())
    copy.destroy()
    return values
  }
  return {
    p,
    /** Draws picture i and then `others` in one call of `redraw`. Returns { image, draws }: the last image, and the draws of all pictures. */
    async picture(i = 0, ...others) {
      pending = [i, ...others]
      draws.length = 0
      await p.redraw(pending.length)
      return { image: copyOf(p.canvas), draws: [...draws] }
    },
    /** Reads a divided shape. Returns { indices, places }. */
    async read({ index, positions, count, indirectBuffer }) {
      const length = count ?? (await read(indirectBuffer, Uint32Array, 0, 4))[0]
      const indices = await read(index, Uint32Array, 0, 4 * length)
      const vertices = indices.reduce((a, b) => Math.max(a, b), 0) + 1
      const { buffer, offset } = positions
      return { indices, places: await read(buffer, Float32Array, offset, 12 * vertices) }
    },
    /** Draws until compute passes divide all shapes. */
    async begin(...pictures) {
      for (let k = 0; k < 1000; k++) {
        const { draws } = await this.picture(...pictures)
        if (draws.length && draws.every(({ indirectBuffer }) => indirectBuffer)) return
        await wait(10)
      }
      throw new Error(`compute passes did not begin: ${errors}`)
    },
    remove: () => p.remove(),
  }
}
