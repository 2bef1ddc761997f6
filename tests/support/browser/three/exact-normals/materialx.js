// MaterialX's gradient noise in double precision, from its specification. Bob Jenkins' function `final` selects a gradient at each corner
// of a cell from the integer coordinates of the corner.

const rotl = (x, k) => (x << k) | (x >>> (32 - k))

/** Bob Jenkins' `final`. */
function mix(a, b, c) {
  c = (c ^ b) - rotl(b, 14)
  a = (a ^ c) - rotl(c, 11)
  b = (b ^ a) - rotl(a, 25)
  c = (c ^ b) - rotl(b, 16)
  a = (a ^ c) - rotl(c, 4)
  b = (b ^ a) - rotl(a, 14)
  return ((c ^ b) - rotl(b, 24)) >>> 0
}

function hashOf(cell) {
  const start = 0xdeadbeef + (cell.length << 2) + 13
  const [a, b, c = 0] = cell
  return mix((start + a) | 0, (start + b) | 0, (start + c) | 0)
}

function gradient(hash, [x, y, z]) {
  const isFlat = z === undefined
  const h = hash & (isFlat ? 7 : 15)
  const u = h < (isFlat ? 4 : 8) ? x : y
  const v = isFlat ? 2 * (h < 4 ? y : x) : h < 4 ? y : h === 12 || h === 14 ? x : z
  return (h & 1 ? -u : u) + (h & 2 ? -v : v)
}

const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10)

/** Returns noise at a point of two or three dimensions; `component` selects a component of noise that returns a vector. */
export function noise(p, component = 0) {
  const cell = p.map(Math.floor)
  const inside = p.map((x, i) => x - cell[i])
  const interpolate = (corner, axis) => {
    if (axis < 0) {
      const hash = hashOf(cell.map((x, i) => x + corner[i])) >>> (8 * component)
      return gradient(
        hash & 0xff,
        inside.map((x, i) => x - corner[i]),
      )
    }
    const [low, high] = [0, 1].map((end) => interpolate({ ...corner, [axis]: end }, axis - 1))
    return low + (high - low) * fade(inside[axis])
  }
  return interpolate({}, p.length - 1) * (p.length === 2 ? 0.6616 : 0.982)
}

/** Returns the sum of octaves of noise, each of twice the frequency and half the height. */
export const fractal = (p, octaves) =>
  Array.from({ length: octaves }, (_, i) => noise(p.map((x) => x * 2 ** i)) / 2 ** i).reduce(
    (a, b) => a + b,
  )

/** Maps an integer to a number from 0 to 1, by the generator PCG as in three's `hash`. */
export function hash(seed) {
  const state = (Math.imul(seed, 747796405) + 2891336453) >>> 0
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0
  return (((word >>> 22) ^ word) >>> 0) / 2 ** 32
}
