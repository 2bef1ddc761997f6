// npm run report:subdivision: how many triangles `subdivide` needs for a given error on the gallery's warps, adaptively and
// uniformly, written as web/docs/subdivision.md.
import { mkdirSync, writeFileSync } from 'node:fs'
import { format, resolveConfig } from 'prettier'
import { build } from './build.mjs'
import { box, icosahedron, plane } from './lib/coarse-meshes.mjs'
import { path } from './lib/files.mjs'
import { good, main, say, seconds } from './lib/terminal.mjs'

const file = path('web/docs/subdivision.md')
const levels = [1, 2, 3, 4, 5, 6]
/** The main table has, for each warp, the first level that is so near: a share of the length of the mesh. */
const near = 0.005
/** Tolerances are tried from large to small, so many to each halving. */
const triesAHalving = 4
/** On a cube of 180 units that noise moves by up to 20. */
const tolerances = [1, 0.5, 0.25]
/** Samples on the longest edge that comes. */
const samples = 64

// Sizes are those of the gallery's models. Twists and the spoon are at the moment at which they bend most.
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

await main(async () => {
  await build()
  const start = performance.now()
  const { compileWarp } = await import('../dist/warpjet.js')
  const { sketchWarps } = await import('../tests/warps/sketches.js')
  const found = []
  for (const { name, warp } of await sketchWarps()) {
    if (!cases[name]) continue
    found.push(await measure(name, compileWarp(warp, { normals: false })))
    say(
      `${name}: ${found
        .at(-1)
        .rows.map(({ ratio }) => inShort(ratio))
        .join(' ')}`,
    )
  }
  mkdirSync(path('web/docs'), { recursive: true })
  const options = { ...(await resolveConfig(file)), parser: 'markdown' }
  writeFileSync(file, await format(page(found, await nearness()), options))
  good(`web/docs/subdivision.md, ${found.length} warps in ${seconds(start)}`)
})

/** For each kind of noise, the errors in parts of the tolerances. */
async function nearness() {
  const { subdivide } = await import('../dist/mesh.js')
  const { deviation } = await import('../tests/support/deviation.js')
  const { cube, noiseWarps } = await import('../tests/support/noise-warps.js')
  const errorOf = (warp, tolerance) => {
    const fine = subdivide(cube, { warp, tolerance, angle: Infinity })
    return deviation(fine, warp, {}, Math.min(1, 2 * tolerance)) / tolerance
  }
  return Object.entries(noiseWarps).map(([name, warp]) => ({
    name,
    errors: tolerances.map((tolerance) => errorOf(warp, tolerance)),
  }))
}

/** A warp's rows, one for each level: the uniform mesh, and the smallest adaptive mesh that is at least as near. */
async function measure(name, warp) {
  const { subdivide } = await import('../dist/mesh.js')
  const { deviation } = await import('../tests/support/deviation.js')
  const [shape, mesh, uniforms] = cases[name]
  const length = 2 * mesh.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0)
  const measured = (fine) => ({
    triangles: fine.indices.length / 3,
    error: deviation(fine, warp, uniforms, length / samples),
  })
  // What is left of a mesh that the warp does not bend is the rounding of float32.
  const isNothing = (error) => error < 1e-6 * length

  const uniform = levels.map((level) => measured(subdivide(mesh, { levels: level })))
  const adaptive = []
  if (!isNothing(uniform[0].error)) {
    const last = uniform.at(-1)
    const options = { warp, uniforms, angle: Infinity }
    for (let tolerance = 4 * uniform[0].error; ; tolerance *= 2 ** (-1 / triesAHalving)) {
      adaptive.push(measured(subdivide(mesh, { ...options, tolerance })))
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
  const chosen = rows.find((row) => row.uniform.error <= near * length) ?? rows.at(-1)
  return { name, shape, triangles: mesh.indices.length / 3, rows, chosen }
}

function inShort(number) {
  return number === undefined ? '–' : String(Number(number.toPrecision(2)))
}

function tableHead(names) {
  return `| ${names.join(' | ')} |\n| ${names.map((_, i) => (i ? '--:' : '---')).join(' | ')} |`
}

function cells({ uniform, adaptive, ratio }) {
  return [
    uniform.triangles,
    inShort(uniform.error),
    adaptive?.triangles ?? '–',
    inShort(adaptive?.error),
    inShort(ratio),
  ]
}

function tableRow(texts) {
  return `| ${texts.join(' | ')} |`
}

function page(found, noises) {
  const bending = found.filter(({ chosen }) => chosen.adaptive)
  const reached = bending.filter(({ chosen }) => chosen.ratio <= 1 / 3)
  return `# How many triangles \`subdivide\` needs

The coarsest mesh of each shape was subdivided uniformly (\`levels\` 1 to ${levels.at(-1)}) and adaptively (\`tolerance\`), for each warp of
the gallery that \`compileWarp\` compiles, at one moment at which it bends much. The error is the largest distance from the
true warped surface to the warped triangles: points of each triangle, on a lattice of at least 4 steps a side and at least
${samples} along the mesh, are warped by \`warp.evaluate\`, and the closest point is found of the flat triangle between its warped
corners. \`subdivide\` itself has no part in that. Adaptive tolerances go down by ${triesAHalving} steps a halving, and the smallest
mesh counts whose measured error is at most that of the uniform one. It is asked for positions alone (\`angle: Infinity\`).
Lengths are in units of the mesh.

\`npm run report:subdivision\` writes this page. \`tests/mesh/subdivision.test.js\` measures the same, and has bounds.

The aim, at most a third of the triangles, is reached for ${reached.length} of ${bending.length} warps that bend:
${reached.map(({ name }) => `\`${name}\``).join(', ')}.

## At an error of ${100 * near} % of the length

For each warp, the first level whose error is at most ${100 * near} % of the longest side of the mesh.

${tableHead(['warp', 'base mesh', 'uniform triangles', 'its error', 'adaptive triangles', 'its error', 'ratio'])}
${found.map(({ name, shape, triangles, chosen }) => tableRow([`\`${name}\``, `${shape}, ${triangles}`, ...cells(chosen)])).join('\n')}

## Ratio at each level

${tableHead(['warp', ...levels])}
${found.map(({ name, rows }) => tableRow([`\`${name}\``, ...rows.map(({ ratio }) => inShort(ratio))])).join('\n')}

## How near it comes

\`subdivide\` looks at samples of the warped surface, more of them where it finds surprises, and splits what is farther away
than 0.95 of the tolerance, since between samples there can be a little more. So what is narrower than a 200th of the mesh can be
missed. Measured on a cube of 180 units with one edge a side, whose points noise moves by up to 20, in parts of the tolerance:

${tableHead(['noise', ...tolerances.map((tolerance) => `tolerance ${tolerance}`)])}
${noises.map(({ name, errors }) => tableRow([`\`${name}\``, ...errors.map((error) => error.toFixed(2))])).join('\n')}

## Why not everywhere

This is what the formulas of the warps suggest; it is not measured.

- What an adaptive mesh saves is where the warp bends less than at its worst. \`spoon\` bends in one part, along one axis;
  \`fingers\` only on one half, most at its end, and hardly across.
- \`sine-cube\`, \`sine-sphere\` and \`tangent-plane\` are waves of one length everywhere, and \`lotus\` and \`bunny-twist\`
  bend all over: there is little to leave out. Uniform triangles, each cut into four of its own shape, are then as good,
  and some levels need fewer than an adaptive mesh has, which splits edges in two and adds triangles around to close cracks.
- The twists (\`airplane-twist\`, \`coarse-and-fine\`), \`genie\`, \`carousel\` and \`text-bulge\` are in between: flat along one direction
  or calm in one part, but not enough of the surface.
- \`bunny-flatten\` is linear: it has no error from the start, and an adaptive mesh stays as it was. It is not counted.
- \`displaced-plane\` is not here, as it is made by \`gen\`, which gives only a text.
`
}
