// Reads the pixels of a WebGL canvas.

/** Reads the first canvas of the page. Returns { width, height, data }: bytes of red, green, blue and alpha, from the top left. */
export async function readPixels(page) {
  const { width, height, bytes } = await page.$eval('canvas', (canvas) => {
    const gl = canvas.getContext('webgl2') ?? canvas.getContext('webgl')
    const { width, height } = canvas
    const data = new Uint8Array(width * height * 4)
    gl.bindFramebuffer(gl.FRAMEBUFFER, null)
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data)
    return { width, height, bytes: data.toBase64() }
  })
  return flipRows(width, height, bytes)
}

/** Runs the code `draw` in the page, and reads its WebGPU canvas at once: the picture is gone when the page continues. */
export async function readWebGPUPixels(page, draw) {
  const { width, height, bytes } = await page.evaluate(`(async () => {
    await (${draw})
    const canvas = document.querySelector('canvas')
    const { width, height } = canvas
    const copy = new OffscreenCanvas(width, height).getContext('2d')
    copy.drawImage(canvas, 0, 0)
    const { data } = copy.getImageData(0, 0, width, height)
    return { width, height, bytes: new Uint8Array(data.buffer).toBase64() }
  })()`)
  return { width, height, data: Buffer.from(bytes, 'base64') }
}

function flipRows(width, height, bytes) {
  const upwards = Buffer.from(bytes, 'base64')
  const rows = Array.from({ length: height }, (_, y) =>
    upwards.subarray((height - 1 - y) * width * 4, (height - y) * width * 4),
  )
  return { width, height, data: Buffer.concat(rows) }
}

/** Returns the colour [red, green, blue] at a point of the image, in pixels, interpolated between four pixel centres. */
export function colorAt({ width, data }, x, y) {
  const [left, top] = [Math.floor(x - 0.5), Math.floor(y - 0.5)]
  const [u, v] = [x - 0.5 - left, y - 0.5 - top]
  const at = (column, row, channel) => data[(row * width + column) * 4 + channel]
  return [0, 1, 2].map(
    (channel) =>
      (1 - v) * ((1 - u) * at(left, top, channel) + u * at(left + 1, top, channel)) +
      v * ((1 - u) * at(left, top + 1, channel) + u * at(left + 1, top + 1, channel)),
  )
}

/** Returns the pixels that are not black → [{ x, y, color }], with x and y from the middle of the image. */
export function litPixels({ width, height, data }) {
  const lit = []
  for (let i = 0; i < width * height; i++) {
    const color = data.subarray(4 * i, 4 * i + 3)
    if (!color[0] && !color[1] && !color[2]) continue
    const [x, y] = [(i % width) + 0.5 - width / 2, Math.floor(i / width) + 0.5 - height / 2]
    lit.push({ x, y, color: [...color] })
  }
  return lit
}

/** Returns the number of pixels of two images that differ by more than `tolerance` in some channel. */
export function differingPixels(a, b, tolerance) {
  const differing = new Set()
  a.data.forEach((value, i) => {
    if (Math.abs(value - b.data[i]) > tolerance) differing.add(i >> 2)
  })
  return differing.size
}

/** Counts the pixels of `image` that are outside the range of the 3 × 3 pixels at the same place in `other` by more than `tolerance`. */
export function beyondEdges(image, other, tolerance) {
  const { width, height, data } = image
  const isBeyond = (x, y, channel) => {
    let [min, max] = [255, 0]
    for (let j = y - 1; j <= y + 1; j++)
      for (let i = x - 1; i <= x + 1; i++) {
        const value = other.data[4 * (j * width + i) + channel]
        if (value < min) min = value
        if (value > max) max = value
      }
    const value = data[4 * (y * width + x) + channel]
    return value < min - tolerance || value > max + tolerance
  }
  let count = 0
  for (let y = 1; y < height - 1; y++)
    for (let x = 1; x < width - 1; x++)
      if (isBeyond(x, y, 0) || isBeyond(x, y, 1) || isBeyond(x, y, 2)) count++
  return count
}

/** Counts the pixels of either image whose color the other image has nowhere within one pixel, up to `tolerance` in each channel. */
export const beyondPixel = (a, b, tolerance) =>
  missingPixels(a, b, tolerance) + missingPixels(b, a, tolerance)

function missingPixels(a, b, tolerance) {
  const { width, height } = a
  const isLike = (i, x, y) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return false
    const j = 4 * (y * width + x)
    return [0, 1, 2, 3].every((k) => Math.abs(a.data[i + k] - b.data[j + k]) <= tolerance)
  }
  const steps = [0, -1, 1]
  let count = 0
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const i = 4 * (y * width + x)
      if (!steps.some((dy) => steps.some((dx) => isLike(i, x + dx, y + dy)))) count++
    }
  return count
}
