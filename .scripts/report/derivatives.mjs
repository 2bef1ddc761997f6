// Measures the errors of every operation on the CPU and on three GPU pipelines, in the same way as the tests.
import { measure as measureOperation } from '../../tests/operations/measure.js'
import { programOf, runOnCpu } from '../../tests/operations/program.js'
import { cases } from '../../tests/operations/reference.js'
import { openPipelines } from '../../tests/support/browser/pipelines.js'
import { say } from '../lib/terminal.mjs'
import { markdownTable } from '../reference/parts.mjs'

/** The processor or shading language in which operations run. */
const targets = ['CPU', 'glsl300', 'glsl100', 'wgsl']

const format = (error) => (error ? error.toExponential(0) : '0')
const unique = (texts) => [...new Set(texts)].join('; ')

export async function measure() {
  const pipelines = await openPipelines()
  const rows = []
  for (const name of new Set(cases.map(({ group }) => group))) {
    const group = cases.filter((operation) => operation.group === name)
    rows.push(await measureRow(name, group, pipelines))
    say(rows.at(-1).join('  '))
  }
  await pipelines.close()
  const bounds = [...new Set(cases.map(({ tolerance }) => tolerance))]
  return {
    operations: markdownTable(
      ['operation', ...targets, 'points', 'derivatives', 'left out', 'in proportion to'],
      rows,
    ),
    bounds: markdownTable(
      ['value', 'derivative', 'reason'],
      bounds.map(({ value, derivative, because }) => [format(value), format(derivative), because]),
    ),
  }
}

function measureIn(target, operation, pipelines) {
  const isCpu = target === 'CPU'
  const program = programOf(operation, isCpu ? 'glsl300' : target)
  return measureOperation(operation, (points) =>
    isCpu ? runOnCpu(program, points) : pipelines.run(target, program, points),
  )
}

async function measureRow(name, group, pipelines) {
  const cells = [`\`${name}\``]
  // After the loop: the results in the last target, from which the row's counts are.
  let measured
  for (const target of targets) {
    measured = []
    for (const operation of group)
      if (target !== 'CPU' || !operation.inShaders)
        measured.push(await measureIn(target, operation, pipelines))
    const maxError = (kind) => format(Math.max(...measured.map((result) => result[kind].error)))
    cells.push(measured.length ? `${maxError('value')}, ${maxError('derivative')}` : '–')
  }
  const sum = (kind) => measured.reduce((total, result) => total + result[kind], 0)
  const kinks = unique(group.flatMap((operation) => operation.kinks ?? []))
  return [
    ...cells,
    sum('points'),
    sum('derivatives'),
    sum('excluded') ? `${sum('excluded')}: ${kinks}` : '',
    unique(group.flatMap(({ sensitivity }) => sensitivity.because ?? [])),
  ]
}
