// Draws the picture of web/docs/noise.md and computes the numbers of its table, with warpjet on the CPU.
import { writeFileSync } from 'node:fs'
import { compileWarp } from '../../dist/warpjet.js'
import { png } from '../../tests/support/png.js'
import { randomNumbers } from '../../tests/support/three-meshes.js'
import { path } from '../lib/files.mjs'
import { markdownTable } from '../reference/parts.mjs'

const kinds = ['noise', 'simplex', 'valueNoise', 'worley', 'fbm', 'ridged', 'turbulence']

/** The side of a tile, and the gap between tiles, in pixels. */
const tile = 150
const gap = 6
/** The side of a tile is as long as this many cells of noise. */
const cellsPerTile = 6

/**
 * Evaluates a noise at many points at once. One warp moves the points along x by the noise, another by its gradient. Returns
 * { values, slopes }, where a slope is the length of a gradient.
 */
function sample(kind, dimensions, points) {
  const value = ({ glsl, position }) => {
    const p = [position.x(), position.xy(), position][dimensions - 1]
    return kind === 'worley' ? glsl[kind](p).x() : glsl[kind](p)
  }
  const compileNoise = (isGradient) =>
    compileWarp(
      (inputs) => {
        const height = value(inputs)
        const { glsl, position } = inputs
        return isGradient ? glsl.gradient(height, position) : glsl.vec3(height, 0, 0)
      },
      { normals: false },
    )
  const movedByNoise = compileNoise(false).evaluate({ positions: points }).positions
  const movedByGradient = compileNoise(true).evaluate({ positions: points }).positions
  const count = points.length / 3
  const slope = (i) =>
    Math.hypot(...[0, 1, 2].map((k) => movedByGradient[3 * i + k] - points[3 * i + k]))
  return {
    values: Float32Array.from({ length: count }, (_, i) => movedByNoise[3 * i] - points[3 * i]),
    slopes: Float32Array.from({ length: count }, (_, i) => slope(i)),
  }
}

const pixels = Float32Array.from({ length: 3 * tile * tile }, (_, i) => {
  const pixel = Math.floor(i / 3)
  return [
    ((pixel % tile) * cellsPerTile) / tile,
    (Math.floor(pixel / tile) * cellsPerTile) / tile,
    0.37,
  ][i % 3]
})

/** Draws values above and slopes below, one column per kind, in gray. */
function drawPicture() {
  const width = kinds.length * (tile + gap) - gap
  const height = 2 * tile + gap
  const bytes = new Uint8Array(width * height).fill(255)
  for (const [column, kind] of kinds.entries()) {
    const { values, slopes } = sample(kind, 3, pixels)
    const isSigned = ['noise', 'simplex', 'valueNoise', 'fbm'].includes(kind)
    const brightnesses = [
      (i) => (isSigned ? 0.5 + 0.6 * values[i] : values[i]),
      (i) => slopes[i] / 4,
    ]
    for (const [row, brightness] of brightnesses.entries())
      for (let i = 0; i < tile * tile; i++) {
        const x = column * (tile + gap) + (i % tile)
        const y = row * (tile + gap) + Math.floor(i / tile)
        bytes[y * width + x] = 255 * Math.min(Math.max(brightness(i), 0), 1)
      }
  }
  return png(width, height, (x, y) => Array(3).fill(bytes[y * width + x]))
}

/** Returns the range of 100,000 values, the range of the middle nine tenths of them, and the root mean square of the slopes. */
function computeStatistics(kind, dimensions) {
  const random = randomNumbers()
  const count = 100_000
  const points = Float32Array.from({ length: 3 * count }, () => 4091 * (random() - 0.5))
  const { values, slopes } = sample(kind, dimensions, points)
  const sorted = [...values].sort((a, b) => a - b)
  const quantile = (fraction) => sorted[Math.floor(fraction * (count - 1))].toFixed(2)
  const slope = Math.sqrt(slopes.reduce((sum, x) => sum + x * x, 0) / count).toFixed(2)
  return [`${quantile(0)} to ${quantile(1)}`, `${quantile(0.05)} to ${quantile(0.95)}`, slope]
}

/** Returns the table that replaces the part `figures` of web/docs/noise.md. */
export function measure() {
  writeFileSync(path('web/docs/noise.png'), drawPicture())
  const rows = kinds.flatMap((kind) =>
    [2, 3].map((dimensions) => [
      `\`${kind}\``,
      `${dimensions}D`,
      ...computeStatistics(kind, dimensions),
    ]),
  )
  const head = ['noise', 'dimensions', 'min to max', 'middle nine tenths', 'typical slope']
  return { figures: markdownTable(head, rows) }
}
