// Measures how many triangles `subdivide` needs to reach a given error on the gallery's warps, adaptively and uniformly.
import { subdivide } from '../../dist/mesh.js'
import { compileWarp } from '../../dist/warpjet.js'
import { box, icosahedron, plane } from '../../tests/support/coarse-meshes.js'
import { deviation } from '../../tests/support/deviation.js'
import { cube, noiseWarps } from '../../tests/support/noise-warps.js'
import { sketchWarps } from '../../tests/warps/sketches.js'
import { say } from '../lib/terminal.mjs'
import { markdownTable } from '../reference/parts.mjs'

const levels = [1, 2, 3, 4, 5, 6]
/** The main table shows the first level whose error is no larger than this fraction of the mesh's size. */
const maxRelativeError = 0.005
/** Adaptive meshes are made with falling tolerances. After this many, the tolerance is half as large. */
const triesPerHalving = 4
/** Tolerances in units for a cube with sides of 180 units, whose points are moved by up to 20 units by noise. */
const tolerances = [1, 0.5, 0.25]
/** The error is measured at points whose distance is the mesh's size divided by this number. */
const samples = 64

// Maps each warp → the name of a shape, a mesh of the size of the gallery's model, and the warp's inputs. For twists and the spoon, these
// are the inputs at the moment at which they bend most.
const cases = {
  'airplane-twist': ['box', box([100, 34, 98]), { millis: 1885 }],
  'bunny-twist': ['icosahedron', icosahedron(100), { millis: 1414 }],
  'bunny-flatten': ['icosahedron', icosahedron(100), { millis: 1414 }],
  carousel: ['plane', plane([55, 85]), { millis: 400, phase: 1.7 }],
  'coarse-and-fine': ['box', box([90, 90, 90]), { millis: 1571 }],
  fingers: ['box', box([128, 200, 42]), { millis: 300 }],
  genie: ['icosahedron', icosahedron(100), { millis: 400 }],
  lotus: ['icosahedron', icosahedron(1), { bend: 1.2 }],
  'sine-cube': ['box', box([100, 100, 100]), { millis: 500 }],
  'sine-sphere': ['icosahedron', icosahedron(1), { millis: 500 }],
  spoon: ['box', box([100, 12.5, 20.6]), { millis: 2356 }],
  'tangent-plane': ['plane', plane([75, 75]), { millis: 500 }],
  'text-bulge': ['plane', plane([250, 60]), { millis: 500, mouse: [320, 240], size: [640, 480] }],
}

export async function measure() {
  const results = []
  for (const { name, warp } of await sketchWarps()) {
    if (!cases[name]) continue
    results.push(measureWarp(name, compileWarp(warp, { normals: false })))
    say(
      `${name}: ${results
        .at(-1)
        .rows.map(({ ratio }) => formatFigure(ratio))
        .join(' ')}`,
    )
  }
  const bending = results.filter(({ chosen }) => chosen.adaptive)
  const reached = bending.filter(({ chosen }) => chosen.ratio <= 1 / 3)
  const list = reached.map(({ name }) => `\`${name}\``).join(', ')
  return {
    reached: `At most a third of the triangles are needed for ${reached.length} of ${bending.length} warps that bend: ${list}.`,
    'chosen levels': markdownTable(
      [
        'warp',
        'base mesh',
        'uniform triangles',
        'its error',
        'adaptive triangles',
        'its error',
        'ratio',
      ],
      results.map(({ name, shape, triangles, chosen }) => [
        `\`${name}\``,
        `${shape}, ${triangles}`,
        ...formatCells(chosen),
      ]),
      true,
    ),
    'all levels': markdownTable(
      ['warp', ...levels],
      results.map(({ name, rows }) => [
        `\`${name}\``,
        ...rows.map(({ ratio }) => formatFigure(ratio)),
      ]),
      true,
    ),
    nearness: markdownTable(
      ['noise', ...tolerances.map((tolerance) => `tolerance ${tolerance}`)],
      measureNoiseErrors(),
      true,
    ),
  }
}

/** Returns a row per kind of noise: its name, and the errors as fractions of the tolerances. */
function measureNoiseErrors() {
  const errorOf = (warp, tolerance) => {
    const subdivided = subdivide(cube, { warp, tolerance, angle: Infinity })
    return deviation(subdivided, warp, {}, Math.min(1, 2 * tolerance)) / tolerance
  }
  return Object.entries(noiseWarps).map(([name, warp]) => [
    `\`${name}\``,
    ...tolerances.map((tolerance) => errorOf(warp, tolerance).toFixed(2)),
  ])
}

/**
 * Returns { name, shape, triangles, rows, chosen }. `triangles` are those of the mesh before subdivision. `rows` has a row per level: the
 * uniform mesh, the smallest adaptive mesh whose error is not larger (undefined if there is none), and the ratio of their triangles.
 * `chosen` is the row of the main table.
 */
function measureWarp(name, warp) {
  const [shape, mesh, uniforms] = cases[name]
  const size = 2 * mesh.positions.reduce((max, x) => Math.max(max, Math.abs(x)), 0)
  const measureMesh = (subdivided) => ({
    triangles: subdivided.indices.length / 3,
    error: deviation(subdivided, warp, uniforms, size / samples),
  })
  // If the warp does not bend the mesh, the error is only the rounding of float32.
  const isRounding = (error) => error < 1e-6 * size

  const uniform = levels.map((level) => measureMesh(subdivide(mesh, { levels: level })))
  const adaptive = []
  if (!isRounding(uniform[0].error)) {
    const last = uniform.at(-1)
    const options = { warp, uniforms, angle: Infinity }
    for (let tolerance = 4 * uniform[0].error; ; tolerance *= 2 ** (-1 / triesPerHalving)) {
      adaptive.push(measureMesh(subdivide(mesh, { ...options, tolerance })))
      const { error, triangles } = adaptive.at(-1)
      if (error <= last.error || triangles > 2 * last.triangles) break
    }
  }
  const rows = uniform.map((row) => {
    const [best] = adaptive
      .filter(({ error }) => error <= row.error)
      .sort((a, b) => a.triangles - b.triangles)
    return { uniform: row, adaptive: best, ratio: best && best.triangles / row.triangles }
  })
  const chosen = rows.find((row) => row.uniform.error <= maxRelativeError * size) ?? rows.at(-1)
  return { name, shape, triangles: mesh.indices.length / 3, rows, chosen }
}

function formatFigure(number) {
  return number === undefined ? '–' : String(Number(number.toPrecision(2)))
}

function formatCells({ uniform, adaptive, ratio }) {
  return [
    uniform.triangles,
    formatFigure(uniform.error),
    adaptive?.triangles ?? '–',
    formatFigure(adaptive?.error),
    formatFigure(ratio),
  ]
}
