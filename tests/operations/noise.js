// The kinds of noise, and the points at which tests evaluate them.
import { randomOf } from '../random/generate.js'

/** Noises from which others can be composed. */
export const bases = ['noise', 'simplex', 'valueNoise']
export const fractals = ['fbm', 'ridged', 'turbulence']
export const noises = [...bases, 'worley', 'curl', ...fractals]

const dimensionsOf = { worley: [1, 2, 3], curl: [3, 4] }

/** { kind, dimensions } of each noise. */
export const kindsOfNoise = noises.flatMap((kind) =>
  (dimensionsOf[kind] ?? [1, 2, 3, 4]).map((dimensions) => ({ kind, dimensions })),
)

export const isFractal = (kind) => fractals.includes(kind)

/** Options other than the defaults. */
export const settingsOf = (kind) =>
  isFractal(kind) ? { octaves: 3, lacunarity: 1.9, gain: 0.6, seed: 7 } : { seed: 7 }

/**
 * Points among the cells near the origin and up to `far` cells from it, as float32 numbers. Their coordinates keep a distance of
 * 1/1024 from integers and halves, where third derivatives jump.
 */
export function noisePoints(dimensions, count, far = 1000) {
  const random = randomOf(dimensions)
  return Array.from({ length: count }, (_, i) =>
    Array.from({ length: dimensions }, () => {
      const cell = Math.floor(2 * (i % 2 ? far : 6) * (random() - 0.5))
      return Math.fround(cell + (Math.floor(random() * 511) + 0.5) / 512)
    }),
  )
}
