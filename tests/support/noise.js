// The noise of src/noise as functions of numbers, in double precision: written from the papers and the comments in src/noise, but not from
// its code. Points are arrays of 1 to 4 numbers, for worley of 1 to 3.
//
// Each base sums over the corners around a point, instead of interpolating axis by axis, so that its gradient follows by the product rule.

const modulo = (x, n) => x - n * Math.floor(x / n)
const sum = (numbers) => numbers.reduce((total, x) => total + x, 0)
function dot(a, b) {
  let total = 0
  for (let i = 0; i < a.length; i++) total += a[i] * b[i]
  return total
}

const prime = 4091

/** Hashes an integer `h` below 4091 and any integer `i` to an integer below 4091: the cube of a linear function modulo 4091. */
export function hash(h, i) {
  const n = modulo(1597 * (h + modulo(i, prime)) + 823, prime)
  return (n * n * n) % prime
}

const hashOfCell = (cell, seed) => cell.reduce(hash, seed)
const hashOfSeed = (seed) => hash(0, seed)

const factors = { 1: [1], 2: [1, 2531], 3: [1, 3091, 2333] }

/** Returns `count` numbers in [0, 1). */
const randoms = (h, count) => factors[count].map((factor) => ((h * factor) % 4096) / 4096)

const cache = new Map()

/** Memoizes `make(h, n)`. All memoized functions would share the cache, so that only one function can be memoized. */
const memoize = (make) => (h, n) => {
  const key = prime * n + h
  if (!cache.has(key)) cache.set(key, make(h, n))
  return cache.get(key)
}

/** Returns a unit vector: a point of a cube is folded onto the polytope |x| + |y| + … = constant (McEwan and others 2012, section 5). */
export const direction = memoize((h, n) => {
  if (n === 1) return [2 * randoms(h, 1)[0] - 1]
  const cube = randoms(h, n - 1).map((x) => 2 * x - 1)
  const last = (n - 1) / 2 - sum(cube.map(Math.abs))
  const folded = [...cube.map((x) => (last < 0 ? x - Math.sign(x) : x)), last]
  return folded.map((x) => x / Math.hypot(...folded))
})

/** Returns all arrays of `n` elements of `choices`. */
const lists = (choices, n) =>
  n === 0 ? [[]] : lists(choices, n - 1).flatMap((list) => choices.map((c) => [...list, c]))

const fade = (t) => t ** 3 * (6 * t ** 2 - 15 * t + 10)
const fadeSlope = (t) => 30 * t ** 2 * (t - 1) ** 2

const cornersOf = [0, 1, 2, 3, 4].map((n) => lists([0, 1], n))

/** Adds up terms with gradients, { value, gradient }. */
const addUp = (terms, scale = 1) => ({
  value: scale * sum(terms.map(({ value }) => value)),
  gradient: terms[0].gradient.map((_, i) => scale * sum(terms.map(({ gradient }) => gradient[i]))),
})

/**
 * Interpolates values at the corners of a cell of a grid; returns { value, gradient }. The weight of a corner is a product with one factor
 * per axis, fade(t) or 1 - fade(t). `corner.value` and `corner.gradient` return the value at a corner and its gradient, from the hash of
 * the corner and the position of the point relative to it.
 */
function lattice(p, seed, corner) {
  const cell = p.map(Math.floor)
  const inside = p.map((x, i) => x - cell[i])
  /** The weights of the lower and of the upper corner along each axis. */
  const weights = inside.map((t) => [1 - fade(t), fade(t)])

  /** Sums `term` over the corners, times the product of the `weights` of the corner along each axis. Called millions of times. */
  function sumOver(weights, term) {
    const offset = [...p]
    let total = 0
    for (const step of cornersOf[p.length]) {
      let h = seed
      let weight = 1
      for (let i = 0; i < p.length; i++) {
        h = hash(h, cell[i] + step[i])
        weight *= weights[i][step[i]]
        offset[i] = inside[i] - step[i]
      }
      total += weight * term(h, offset)
    }
    return total
  }

  return {
    get value() {
      return sumOver(weights, corner.value)
    },
    get gradient() {
      return inside.map((t, axis) => {
        const slopes = weights.with(axis, [-fadeSlope(t), fadeSlope(t)])
        return sumOver(slopes, corner.value) + sumOver(weights, (h) => corner.gradient(h)[axis])
      })
    },
  }
}

export const bases = {
  /** Perlin 2002, with directions of length 1, scaled to reach 1. */
  noise(p, seed) {
    const scale = 2 / Math.sqrt(p.length)
    return lattice(p, seed, {
      value: (h, offset) => scale * dot(direction(h, p.length), offset),
      gradient: (h) => direction(h, p.length).map((x) => scale * x),
    })
  },

  valueNoise: (p, seed) =>
    lattice(p, seed, { value: (h) => (2 * h) / (prime - 1) - 1, gradient: () => p.map(() => 0) }),

  /** Perlin 2001, Gustavson 2005; kernels (reach - d²)⁴, scaled to reach 1. */
  simplex(p, seed) {
    const n = p.length
    const skew = n === 1 ? 0 : (Math.sqrt(n + 1) - 1) / n
    const unskew = n === 1 ? 0 : (1 - 1 / Math.sqrt(n + 1)) / n
    const cell = p.map((x) => Math.floor(x + skew * sum(p)))
    const positionOf = (corner) => corner.map((c) => c - unskew * sum(corner))
    const offsetFrom = (corner) => positionOf(corner).map((x, i) => p[i] - x)
    // Orders the axes by descending coordinate; axes with equal coordinates keep their order.
    const first = offsetFrom(cell)
    const order = [...p.keys()].sort((a, b) => first[b] - first[a])
    const terms = Array.from({ length: n + 1 }, (_, steps) => {
      const corner = cell.map((c, i) => c + (order.indexOf(i) < steps ? 1 : 0))
      const offset = offsetFrom(corner)
      const falloff = Math.max((n === 1 ? 1 : 0.5) - dot(offset, offset), 0)
      const g = direction(hashOfCell(corner, seed), n)
      const along = dot(g, offset)
      return {
        value: falloff ** 4 * along,
        gradient: g.map((x, i) => falloff ** 4 * x - 8 * falloff ** 3 * offset[i] * along),
      }
    })
    return addUp(terms, [0, 3.16049, 99.2043, 107.6534, 108.5678][n])
  },
}

export const noise = (p, { seed = 0 } = {}) => bases.noise(p, hashOfSeed(seed)).value
export const valueNoise = (p, { seed = 0 } = {}) => bases.valueNoise(p, hashOfSeed(seed)).value
export const simplex = (p, { seed = 0 } = {}) => bases.simplex(p, hashOfSeed(seed)).value

/** Returns [F1, F2], the distances to the nearest and second nearest of random points, of which each cell has one (Worley 1996). */
export function worley(p, { seed = 0 } = {}) {
  const home = p.map(Math.floor)
  let nearest = [Infinity, Infinity]
  for (const { step, distance } of stepsOf(p.length)) {
    if (distance > nearest[1]) break
    const cell = home.map((c, i) => c + step[i])
    const point = randoms(hashOfCell(cell, hashOfSeed(seed)), p.length)
    const pointDistance = Math.hypot(...p.map((x, i) => cell[i] + point[i] - x))
    if (pointDistance < nearest[1])
      nearest = [...nearest.slice(0, 1), pointDistance].sort((a, b) => a - b)
  }
  return nearest
}

const stepsCache = {}

/** Returns the steps to cells, each with the minimum distance between the cell and the home cell, in ascending order. */
const stepsOf = (dimensions) =>
  (stepsCache[dimensions] ??= lists([-3, -2, -1, 0, 1, 2, 3], dimensions)
    .map((step) => ({
      step,
      distance: Math.hypot(...step.map((x) => Math.max(Math.abs(x) - 1, 0))),
    }))
    .sort((a, b) => a.distance - b.distance))

const shifts = [0.6180339887498949, 0.7548776662466927, 0.8191725133961645, 0.8566748838545029]

const fractal =
  (shape) =>
  (p, { octaves = 5, lacunarity = 2, gain = 0.5, noise: base = 'noise', seed = 0 } = {}) => {
    const strengths = Array.from({ length: octaves }, (_, k) => gain ** k)
    const values = strengths.map((strength, k) => {
      const point = p.map((x, i) => x * lacunarity ** k + k * shifts[i])
      const first = hashOfSeed(seed)
      return strength * shape(bases[base](point, k === 0 ? first : hash(first, k)).value)
    })
    return sum(values) / sum(strengths)
  }

export const fbm = fractal((x) => x)
export const turbulence = fractal(Math.abs)
export const ridged = fractal((x) => (1 - Math.abs(x)) ** 2)

/** Returns the curl of three noises (Bridson and others 2007, equation 1). */
export function curl(p, { noise: base = 'noise', seed = 0 } = {}) {
  const [x, y, z] = [1, 2, 3].map((i) => bases[base](p, hash(hashOfSeed(seed), i)).gradient)
  return [z[1] - y[2], x[2] - z[0], y[0] - x[1]]
}
