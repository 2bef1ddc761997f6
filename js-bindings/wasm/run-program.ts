// Programs on many vertices: by machine code where the engine compiles any, else by the evaluation's own interpreter. Both
// give the same bits.
import type { Program } from '../core/module/kept-module.js'
import { WarpError } from '../errors/errors.js'
import { type Evaluation, type Memory, getEvaluation, withMemory } from './evaluation.js'
import {
  MachineCode,
  type Sink,
  type Stream,
  copy,
  sizeOf,
  verticesAtOnce,
} from './machine-code.js'

/**
 * Runs `program` on so many vertices; `inputs` has all of its inputs in order, and `wanted` are the results that the sinks
 * take, always in the same array for the same ones: the machine code is found by it. Nothing is left for the garbage
 * collector where that is there: functions that capture variables stand apart, for each call would make their scope.
 */
export function runProgram(
  program: Program,
  wanted: readonly number[],
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  const code = machineCodeOf(program, wanted, vertices, inputs, sinks)
  if (code) code.run(vertices, inputs, sinks)
  else interpretAll(program, wanted, vertices, inputs, sinks)
}

/**
 * Making machine code takes two to three times as long as readying the interpreter, and running it two thirds: so a program
 * that is run once has none unless it is run on so many vertices.
 */
const worthwhile = 30_000

/** What is known of a program for some results and inputs of one kind. */
interface Known {
  wanted: readonly number[]
  isUniform: readonly boolean[]
  /** Null if the program is too long, and nothing after it was run once. */
  code?: MachineCode | null
}

/** Of each program a few, which are compared: a key would be text that is made at each call. */
const knowns = new WeakMap<Program, Known[]>()

/** Where a Content-Security-Policy or the engine itself compiled nothing more. */
let isForbidden = false

function machineCodeOf(
  program: Program,
  wanted: readonly number[],
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
): MachineCode | null | undefined {
  if (isForbidden) return undefined
  let all = knowns.get(program)
  if (!all) knowns.set(program, (all = []))
  let known = likeThese(all, wanted, inputs)
  if (!known) {
    all.push((known = { wanted, isUniform: inputs.map(({ isUniform }) => isUniform) }))
    if (vertices < worthwhile) return undefined
  }
  const { code } = known
  if (code === null || code?.core === getEvaluation()) return code
  try {
    return (known.code = makeMachineCode(program, wanted, inputs, sinks))
  } catch (error) {
    if (error instanceof WarpError) throw error
    isForbidden = true
    return undefined
  }
}

function likeThese(
  all: readonly Known[],
  wanted: readonly number[],
  inputs: readonly Stream[],
): Known | undefined {
  next: for (const known of all) {
    if (known.wanted !== wanted) continue
    for (let i = 0; i < inputs.length; i++)
      if (inputs[i]!.isUniform !== known.isUniform[i]) continue next
    return known
  }
  return undefined
}

const makeMachineCode = (
  program: Program,
  wanted: readonly number[],
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) => withMemory((core, memory) => MachineCode.of(program, wanted, core, memory, inputs, sinks))

const interpretAll = (
  program: Program,
  wanted: readonly number[],
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) => withMemory((core, memory) => interpret(core, memory, program, wanted, vertices, inputs, sinks))

function interpret(
  core: Evaluation,
  memory: Memory,
  program: Program,
  wanted: readonly number[],
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
  inputs.forEach(({ values, isUniform }, i) => {
    if (isUniform) core.HEAPF32.set(values, streams[i]! / 4)
  })

  const evaluator = core._openEvaluator(
    ...memory.program(program),
    ...memory.list(wanted),
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
