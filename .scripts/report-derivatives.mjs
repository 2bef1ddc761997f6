// npm run report:derivatives: measures every operation on the CPU and on three GPU pipelines, as
// the tests do, and writes what came out as web/docs/derivatives.md.
import { mkdirSync, writeFileSync } from 'node:fs'
import { format, resolveConfig } from 'prettier'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { good, main, say, seconds } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const file = path('web/docs/derivatives.md')
const dialects = ['CPU', 'glsl300', 'glsl100', 'wgsl']

await main(async () => {
  const { chromium } = await setup()
  process.env.WARPJET_CHROMIUM = chromium
  await build()
  const start = performance.now()
  const { cases } = await import('../tests/operations/reference.js')
  const groups = [...new Set(cases.map(({ group }) => group))]
  const lines = []
  const measureCase = await openMeasuring()
  for (const name of groups) {
    const group = cases.filter((operation) => operation.group === name)
    lines.push(await line(name, group, measureCase))
    say(lines.at(-1))
  }
  await measureCase.close()

  mkdirSync(path('web/docs'), { recursive: true })
  const options = { ...(await resolveConfig(file)), parser: 'markdown' }
  writeFileSync(file, await format(page(lines, cases), options))
  good(`web/docs/derivatives.md, ${groups.length} operations in ${seconds(start)}`)
})

/** A function that measures a case in a dialect. What it is made of needs the build. */
async function openMeasuring() {
  const { measure } = await import('../tests/operations/measure.js')
  const { programOf, runOnCpu } = await import('../tests/operations/program.js')
  const { openPipelines } = await import('../tests/support/browser/pipelines.js')
  const pipelines = await openPipelines()
  const measureCase = (operation, dialect) => {
    const program = programOf(operation, dialect === 'CPU' ? 'glsl300' : dialect)
    return measure(operation, (points) =>
      dialect === 'CPU' ? runOnCpu(program, points) : pipelines.run(dialect, program, points),
    )
  }
  return Object.assign(measureCase, { close: pipelines.close })
}

/** An operation as a line of the table. */
async function line(name, group, measureCase) {
  const cells = [`\`${name}\``]
  let measured
  for (const dialect of dialects) {
    measured = []
    for (const operation of group)
      if (dialect !== 'CPU' || !operation.inShaders)
        measured.push(await measureCase(operation, dialect))
    cells.push(
      measured.length ? `${worst(measured, 'value')}, ${worst(measured, 'derivative')}` : '–',
    )
  }
  const sum = (kind) => measured.reduce((total, found) => total + found[kind], 0)
  const unique = (texts) => [...new Set(texts)].join('; ')
  const kinks = unique(group.flatMap((operation) => operation.kinks ?? []))
  cells.push(sum('points'), sum('derivatives'))
  cells.push(sum('excluded') ? `${sum('excluded')}: ${kinks}` : '')
  cells.push(unique(group.flatMap(({ sensitivity }) => sensitivity.because ?? [])))
  return `| ${cells.join(' | ')} |`
}

function worst(measured, kind) {
  return inShort(Math.max(...measured.map((found) => found[kind].error)))
}

function inShort(error) {
  return error ? error.toExponential(0) : '0'
}

function tableHead(names) {
  return `| ${names.join(' | ')} |\n| ${names.map(() => '---').join(' | ')} |`
}

function page(lines, cases) {
  return `# How exact values and derivatives are

Every operation was compiled together with its derivatives by every number of every operand, and
ran on the CPU in double precision and, in each dialect, on a GPU pipeline of headless Chromium in
float32: \`glsl300\` in a vertex shader of WebGL 2, \`glsl100\` in one of WebGL 1, \`wgsl\` in a
compute shader of WebGPU. What came out is compared with a reference that was written independently
in plain JavaScript, and with finite differences of it.

\`npm run report:derivatives\` writes this page. \`tests/core/operations.test.js\` and
\`tests/core/operations.browser.test.js\` measure the same, and have bounds.

The columns of dialects have the worst error of the value and the worst error of a derivative.
Errors are in proportion to the expected number where that is above 1, and to what the last column
says. Those of derivatives on the CPU are the errors of the differences, good to 1e-10. The
pipelines here are SwiftShader's, which computes without a GPU: its sine and cosine alone are 2e-4
off.

Derivatives are left out only where the differences themselves show a kink or a jump, with steps
down to 2e-7. What holds exactly there is agreed on in \`tests/operations/conventions.js\`, and tested.
Own functions (\`fn\`) are not on the CPU, as their text is in the languages of shaders.

${tableHead(['operation', ...dialects, 'points', 'derivatives', 'left out', 'in proportion to'])}
${lines.join('\n')}

## Bounds on a GPU

${tableHead(['value', 'derivative', 'reason'])}
${[...new Set(cases.map(({ tolerance }) => tolerance))]
  .map(
    ({ value, derivative, because }) =>
      `| ${inShort(value)} | ${inShort(derivative)} | ${because} |`,
  )
  .join('\n')}
`
}
