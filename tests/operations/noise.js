// The kinds of noise, and the points at which tests evaluate them.
import { randomOf } from '../random/generate.js'

/**
 * The properties of most noises: the dimensions of the points that they accept, the number of their values, the range of each, and
 * whether their slopes jump. Noise of |n| has kinks where n is 0; in 1D, `noise` is 0 at every border of a cell.
 */
const standard = { dimensions: [1, 2, 3, 4], size: 1, range: [-1, 1], hasKinks: false }

/** Maps each noise → its properties. */
export const propertiesOf = {
  noise: { ...standard, isBase: true },
  simplex: { ...standard, isBase: true },
  valueNoise: { ...standard, isBase: true },
  worley: { ...standard, dimensions: [1, 2, 3], size: 2, range: [0, 2], hasKinks: true },
  curl: { ...standard, dimensions: [3, 4], size: 3, range: [-Infinity, Infinity] },
  fbm: { ...standard, isFractal: true },
  ridged: { ...standard, isFractal: true, range: [0, 1], hasKinks: true },
  turbulence: { ...standard, isFractal: true, range: [0, 1], hasKinks: true },
}

export const noises = Object.keys(propertiesOf)
export const isFractal = (kind) => Boolean(propertiesOf[kind].isFractal)
export const fractals = noises.filter(isFractal)
/** Noises from which others can be composed. */
export const bases = noises.filter((kind) => propertiesOf[kind].isBase)

/** { kind, dimensions } for each kind of noise and each number of dimensions that it accepts. */
export const kindsOfNoise = noises.flatMap((kind) =>
  propertiesOf[kind].dimensions.map((dimensions) => ({ kind, dimensions })),
)

/** Returns options that differ from the defaults. */
export const settingsOf = (kind) =>
  isFractal(kind) ? { octaves: 3, lacunarity: 1.9, gain: 0.6, seed: 7 } : { seed: 7 }

/**
 * Returns points of cells near the origin and of cells up to `maxDistance` cells from it, as float32 numbers. Their coordinates keep a
 * distance of 1/1024 from integers and halves, where third derivatives jump.
 */
export function noisePoints(dimensions, count, maxDistance = 1000) {
  const random = randomOf(dimensions)
  return Array.from({ length: count }, (_, i) =>
    Array.from({ length: dimensions }, () => {
      const cell = Math.floor(2 * (i % 2 ? maxDistance : 6) * (random() - 0.5))
      return Math.fround(cell + (Math.floor(random() * 511) + 0.5) / 512)
    }),
  )
}
