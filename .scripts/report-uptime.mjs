// npm run report:uptime: how right the gallery's warps are after a week, with and without what is computed once a frame,
// written as web/docs/uptime.md.
import { writeFileSync } from 'node:fs'
import { format, resolveConfig } from 'prettier'
import { launchBrowser } from '../tests/browser/support/browser.js'
import { openPipeline } from '../tests/browser/support/transform-feedback.js'
import { afterAWeek, isMeasured } from '../tests/browser/support/uptime.js'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { good, main } from './lib/terminal.mjs'

const file = path('web/docs/uptime.md')

const size = (value) => (value === 0 ? '0' : value.toExponential(0))
const degrees = (value) => (value < 0.0001 ? '0' : value.toFixed(value < 0.1 ? 4 : 1))
const share = (value) => `${(100 * value).toFixed(value < 0.1 ? 1 : 0)} %`

const cells = ({ then, step }) => [size(then.position), degrees(then.angle), share(step)]

await main(async () => {
  await build()
  const { warps } = await import('../tests/warps/index.js')
  const browser = await launchBrowser()
  const gpu = await openPipeline(browser)
  const rows = []
  for (const warp of warps.filter(isMeasured)) {
    const before = await afterAWeek(gpu, warp, {})
    const now = await afterAWeek(gpu, warp, { perFrame: true })
    const start = [size(now.start.position), degrees(now.start.angle)]
    rows.push([`\`${warp.name}\``, ...start, ...cells(before), ...cells(now)])
  }
  await browser.close()
  const table = rows.map((row) => `| ${row.join(' | ')} |`).join('\n')
  const options = await resolveConfig(file)
  writeFileSync(file, await format(page(table), { ...options, filepath: file }))
  good(`${rows.length} warps are in web/docs/uptime.md`)
})

function page(table) {
  return `# A week of uptime

An installation runs for days. After a week \`millis\` is 600,000,000, and float32, which shaders compute with, has steps of 64 there:
\`sin(y + millis / 500)\` stands still for four frames and then jumps, and its argument, 1,200,000, has lost all but its first
seven digits.

So what depends only on what is the same for a whole frame (\`millis\`, \`mouse\`, \`size\`, \`pixelDensity\` and the option \`uniforms\`) is computed once a
frame on the CPU, in double. Where it is added inside of something periodic, it comes less by whole periods: by 2π in \`sin\` and \`cos\`,
by π in \`tan\`, by 1 in \`fract\`, by the divisor in \`mod\` where that is a constant, and by the 4,091 cells after which noise repeats. Of a sketch's
function nothing is asked: \`position.y.mult(4).add(millis.div(500)).sin()\` is read as it is written, also through sums, differences,
multiples and quotients.

\`createWarp\` of p5 always does that. \`compileWarp(offset, { perFrame: true })\` has uniforms \`warpjetFrame0\`, … in its text, and
\`warp.frameUniforms({ millis: performance.now() })\` gives their values, to be set each frame.

What stays as it was: \`millis\` where nothing periodic stands around it, such as a shape that moves on for ever; noise of \`simplex\` kind in
one, two or four dimensions, whose cells are skewed by irrational shares, and fractals whose lacunarity is no whole number; what
\`glsl.fn\` computes; and in shader text (\`glslOffset\`) constants are float32's, as GLSL has it, so that \`1.6 * time\` is that of another 1.6. More than
128 numbers a frame stay in the shader. Noise itself has float32's digits at up to 2,045 cells from its origin, an eighth of a thousandth of a
cell.

## Measured

Each warp of the gallery on its mesh, by transform feedback on WebGL 2, beside its double oracle: a plain function of numbers, with
normals from finite differences. The largest error of positions, in parts of the size of the mesh; of normals, in degrees; and of
the way that vertices go in 16 ms, in parts of the longest such way (100 %: nothing moved, or nothing should have). The sine is one of float32's accuracy, since that
of SwiftShader, which stands in for a GPU here, is not. \`npm run report:uptime\` writes this page, and
\`tests/browser/uptime.test.js\` has bounds for the last three columns.

| warp | at start: positions | normals (°) | after a week, before: positions | normals (°) | 16 ms | now: positions | normals (°) | 16 ms |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
${table}
`
}
