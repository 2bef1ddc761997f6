// Evaluates images at texture coordinates in double precision, by the formulas of the papers: each texel is weighted by a kernel of its
// distance. This is independent of warpjet's implementation.
import { randomOf } from '../random/generate.js'

const cube = (x) => x ** 3

/** Kernels, as functions of the distance to a texel, in texels. */
const kernels = {
  bilinear: (d) => Math.max(0, 1 - d),
  // Keys (1981), equation 15, which is his equation 8 with a = -1/2.
  bicubic(d) {
    if (d < 1) return 1.5 * cube(d) - 2.5 * d ** 2 + 1
    return d < 2 ? -0.5 * cube(d) + 2.5 * d ** 2 - 4 * d + 2 : 0
  },
  // Sigg and Hadwiger (2005), equation 20-2, as one function of the distance.
  bspline(d) {
    if (d < 1) return 2 / 3 - d ** 2 + cube(d) / 2
    return d < 2 ? cube(2 - d) / 6 : 0
  },
  nearest: (d) => Number(d < 0.5),
}

/** The continuous kernels. */
export const filters = Object.keys(kernels).filter((name) => name !== 'nearest')

/** Each maps the index of a texel on an endless row to one of `size` texels. */
const wrappers = {
  clamp: (i, size) => Math.min(Math.max(i, 0), size - 1),
  repeat: (i, size) => ((i % size) + size) % size,
  mirror(i, size) {
    // Reflects repeatedly at the edges, which are half a texel beyond the outermost texels.
    for (;;) {
      if (i < 0) i = -1 - i
      else if (i >= size) i = 2 * size - 1 - i
      else return i
    }
  },
}

export const wraps = Object.keys(wrappers)

/** Returns red, green, blue and alpha of an image of bytes at u, v. `wrap` is one mode, or one for each axis. */
export function sample(
  { width, height, data },
  u,
  v,
  { filter = 'bilinear', wrap = 'clamp' } = {},
) {
  const [x, y] = [u * width - 0.5, v * height - 0.5]
  const [across, down = across] = [wrap].flat()
  const sums = [0, 0, 0, 0]
  for (let row = Math.floor(y) - 2; row <= y + 2; row++)
    for (let column = Math.floor(x) - 2; column <= x + 2; column++) {
      const weight = kernels[filter](Math.abs(x - column)) * kernels[filter](Math.abs(y - row))
      const at = wrappers[down](row, height) * width + wrappers[across](column, width)
      for (let i = 0; i < 4; i++) sums[i] += (weight * data[4 * at + i]) / 255
    }
  return sums
}

/** Returns an image of random bytes. */
export function randomImage(width, height, seed = 1) {
  const random = randomOf(seed)
  const data = Array.from({ length: 4 * width * height }, () => Math.floor(256 * random()))
  return { width, height, data }
}
