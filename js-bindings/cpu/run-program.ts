// Programs on many vertices: by machine code where the engine compiles any, else by the evaluation's own interpreter. Both
// give the same bits.
import type { Program } from '../core/module/kept-module.js'
import type { ResultSet } from '../core/module/result-set.js'
import { WarpError } from '../errors/errors.js'
import { evaluation } from '../wasm/evaluation.js'
import { withProgram } from './analyse-program.js'
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
 * take. Nothing is left for the garbage
 * collector where that is there: functions that capture variables stand apart, for each call would make their scope.
 */
export function runProgram(
  program: Program,
  wanted: ResultSet,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  const code = machineCodeOf(program, wanted, vertices, inputs, sinks)
  if (code) code.run(vertices, inputs, sinks)
  else interpret(program, wanted, vertices, inputs, sinks)
}

/**
 * Making machine code takes two to three times as long as readying the interpreter, and running it two thirds: so a program
 * that is run once has none unless it is run on so many vertices.
 */
const worthwhile = 30_000

/** What is known of a program for some results and inputs of one kind. */
interface Known {
  wanted: ResultSet
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
  wanted: ResultSet,
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
  if (code === null || code?.core === evaluation.get()) return code
  try {
    return (known.code = MachineCode.of(program, wanted.numbers, inputs, sinks))
  } catch (error) {
    if (error instanceof WarpError) throw error
    isForbidden = true
    return undefined
  }
}

function likeThese(
  all: readonly Known[],
  wanted: ResultSet,
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

function interpret(
  program: Program,
  wanted: ResultSet,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  const atOnce = Math.min(vertices, verticesAtOnce)
  withProgram(program, (loaded) =>
    evaluation.use(
      ({ Evaluator }) => new Evaluator(loaded, wanted.numbers, inputs, sinks.map(sizeOf), atOnce),
      (evaluator) => {
        inputs.forEach(({ values, isUniform }, i) => {
          if (isUniform) evaluator.input(i).set(values)
        })
        for (let first = 0; first < vertices; first += atOnce) {
          const now = Math.min(atOnce, vertices - first)
          inputs.forEach(({ values, size, isUniform }, i) => {
            if (!isUniform) copy(evaluator.input(i), 0, values, first * size, now * size)
          })
          evaluator.run(now)
          sinks.forEach(({ values, results: { length: size } }, i) =>
            values.set(evaluator.result(i).subarray(0, now * size), first * size),
          )
        }
      },
    ),
  )
}
