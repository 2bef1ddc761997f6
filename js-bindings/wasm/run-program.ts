// Programs on many vertices: by machine code where the engine compiles any, else by the evaluation's own interpreter. Both
// give the same bits.
import type { Program } from '../module/kept-module.js'
import { WarpError } from '../checks/errors.js'
import { type Evaluation, type Memory, withMemory } from './evaluation.js'
import {
  MachineCode,
  type Sink,
  type Stream,
  copy,
  sizeOf,
  verticesAtOnce,
} from './machine-code.js'

/** Runs `program` on so many vertices; `inputs` has all of its inputs in order. */
export function runProgram(
  program: Program,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  withMemory((core, memory) => {
    const code = machineCodeOf(core, memory, program, vertices, inputs, sinks)
    if (code) code.run(memory, vertices, inputs, sinks)
    else interpret(core, memory, program, vertices, inputs, sinks)
  })
}

/**
 * Making machine code takes two to three times as long as readying the interpreter, and running it two thirds: so a program
 * that is run once has none unless it is run on so many vertices.
 */
const worthwhile = 30_000

/** By program, and by what is uniform and wanted: null if it is too long, and nothing after it was run once. */
const codes = new WeakMap<Program, Map<string, MachineCode | null | undefined>>()

/** Where a Content-Security-Policy or the engine itself compiled nothing more. */
let isForbidden = false

function machineCodeOf(
  core: Evaluation,
  memory: Memory,
  program: Program,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
): MachineCode | null | undefined {
  if (isForbidden) return undefined
  let known = codes.get(program)
  if (!known) codes.set(program, (known = new Map<string, MachineCode | null | undefined>()))
  let key = ''
  for (const { isUniform } of inputs) key += isUniform ? 'u' : 'v'
  for (const { results } of sinks) key += `${results.join()};`
  let code = known.get(key)
  if (code === null || code?.core === core) return code
  if (!known.has(key) && vertices < worthwhile) known.set(key, undefined)
  else {
    try {
      code = MachineCode.of(program, core, memory, inputs, sinks)
      known.set(key, code)
    } catch (error) {
      if (error instanceof WarpError || error instanceof WebAssembly.RuntimeError) throw error
      isForbidden = true
    }
  }
  return code
}

function interpret(
  core: Evaluation,
  memory: Memory,
  program: Program,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  const atOnce = Math.min(vertices, verticesAtOnce)
  const streams = inputs.map(({ size, isUniform }) =>
    memory.floats(size * (isUniform ? 1 : atOnce)),
  )
  const results = sinks.map((sink) => memory.floats(sink.results.length * atOnce))
  const streamTable = memory.table(inputs, streams)
  const resultTable = memory.table(sinks.map(sizeOf), results)
  const wanted = memory.list(sinks.flatMap((sink) => sink.results))
  inputs.forEach(({ values, isUniform }, i) => {
    if (isUniform) core.HEAPF32.set(values, streams[i]! / 4)
  })

  const evaluator = core._openEvaluator(
    ...memory.program(program),
    ...wanted,
    streamTable,
    inputs.length,
  )
  memory.evaluator = evaluator
  for (let first = 0; first < vertices; first += atOnce) {
    const now = Math.min(atOnce, vertices - first)
    inputs.forEach(({ values, size, isUniform }, i) => {
      if (!isUniform) copy(core.HEAPF32, streams[i]! / 4, values, first * size, now * size)
    })
    core._runEvaluator(evaluator, now, streamTable, inputs.length, resultTable, sinks.length)
    sinks.forEach((sink, i) => {
      const size = sink.results.length
      const at = results[i]! / 4
      sink.values.set(core.HEAPF32.subarray(at, at + now * size), first * size)
    })
  }
}
