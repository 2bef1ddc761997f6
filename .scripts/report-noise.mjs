// npm run report:noise: the picture and the figures of web/docs/noise.md, from warpjet itself on the CPU.
import { readFileSync, writeFileSync } from 'node:fs'
import { png } from '../tests/support/png.js'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { good, isMain, main } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const kinds = ['noise', 'simplex', 'valueNoise', 'worley', 'fbm', 'ridged', 'turbulence']

const tile = 150
const gap = 6
/** Cells along the side of a tile. */
const cells = 6

/** A noise at many points at once, as the height of a warp: { values, slopes }. */
async function sample(kind, dimensions, points) {
  const { compileWarp } = await import('../dist/warpjet.js')
  const value = ({ glsl, position }) => {
    const p = [position.x(), position.xy(), position][dimensions - 1]
    return kind === 'worley' ? glsl[kind](p).x() : glsl[kind](p)
  }
  const warp = (derive) =>
    compileWarp(
      (inputs) => {
        const height = value(inputs)
        const { glsl, position } = inputs
        return derive ? glsl.gradient(height, position) : glsl.vec3(height, 0, 0)
      },
      { normals: false },
    )
  const moved = warp(false).evaluate({ positions: points }).positions
  const derived = warp(true).evaluate({ positions: points }).positions
  const count = points.length / 3
  const slope = (i) => Math.hypot(...[0, 1, 2].map((k) => derived[3 * i + k] - points[3 * i + k]))
  return {
    values: Float32Array.from({ length: count }, (_, i) => moved[3 * i] - points[3 * i]),
    slopes: Float32Array.from({ length: count }, (_, i) => slope(i)),
  }
}

const pixels = Float32Array.from({ length: 3 * tile * tile }, (_, i) => {
  const pixel = Math.floor(i / 3)
  return [((pixel % tile) * cells) / tile, (Math.floor(pixel / tile) * cells) / tile, 0.37][i % 3]
})

/** Values above, slopes below, a column a kind; as gray bytes. */
async function picture() {
  const width = kinds.length * (tile + gap) - gap
  const height = 2 * tile + gap
  const bytes = new Uint8Array(width * height).fill(255)
  for (const [column, kind] of kinds.entries()) {
    const { values, slopes } = await sample(kind, 3, pixels)
    const signed = ['noise', 'simplex', 'valueNoise', 'fbm'].includes(kind)
    const gray = [(i) => (signed ? 0.5 + 0.6 * values[i] : values[i]), (i) => slopes[i] / 4]
    for (const [row, brightness] of gray.entries())
      for (let i = 0; i < tile * tile; i++) {
        const x = column * (tile + gap) + (i % tile)
        const y = row * (tile + gap) + Math.floor(i / tile)
        bytes[y * width + x] = 255 * Math.min(Math.max(brightness(i), 0), 1)
      }
  }
  return png(width, height, (x, y) => Array(3).fill(bytes[y * width + x]))
}

/** Of a hundred thousand places: how far from the mean values lie, the middle nine tenths of them, the typical slope. */
async function figures(kind, dimensions) {
  let state = 1
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647
  const count = 100_000
  const points = Float32Array.from({ length: 3 * count }, () => 4091 * (random() - 0.5))
  const { values, slopes } = await sample(kind, dimensions, points)
  const sorted = [...values].sort((a, b) => a - b)
  const at = (share) => sorted[Math.floor(share * (count - 1))].toFixed(2)
  const slope = Math.sqrt(slopes.reduce((sum, x) => sum + x * x, 0) / count).toFixed(2)
  return [`${at(0)} to ${at(1)}`, `${at(0.05)} to ${at(0.95)}`, slope]
}

/** The page, with this run's table between its markers. */
async function page() {
  const rows = []
  for (const kind of kinds)
    for (const dimensions of [2, 3])
      rows.push([`\`${kind}\``, `${dimensions}D`, ...(await figures(kind, dimensions))])
  const head = ['noise', 'of', 'least to largest found', 'nine tenths of all', 'typical slope']
  const table = [head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`)
  const text = readFileSync(path('web/docs/noise.md'), 'utf8')
  const marked = /(<!-- figures -->\n)[^]*?(<!-- end of figures -->)/
  const { format, resolveConfig } = await import('prettier')
  const file = path('web/docs/noise.md')
  return format(text.replace(marked, `$1\n${table.join('\n')}\n\n$2`), {
    ...(await resolveConfig(file)),
    filepath: file,
  })
}

if (isMain(import.meta))
  await main(async () => {
    await setup()
    await build()
    writeFileSync(path('web/docs/noise.png'), await picture())
    writeFileSync(path('web/docs/noise.md'), await page())
    good('web/docs/noise.md and noise.png are new.')
  })
