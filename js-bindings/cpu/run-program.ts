// Evaluates programs at many vertices: by machine code where the engine compiles it, otherwise by the interpreter of the
// evaluation module. Machine code and interpreter give the same bits.
import type { ResultSet } from '../core/module/result-set.js'
import type { Program } from '../core/module/serialized-module.js'
import { WarpError } from '../errors/errors.js'
import { evaluation } from '../wasm/evaluation.js'
import { withProgram } from './analyse-program.js'
import { MachineCode, batchSize, copy, sizeOf, type Sink, type Stream } from './machine-code.js'

/**
 * Evaluates `program`. `inputs` has all of its inputs in order, and `wanted` are the results that the sinks receive. With machine
 * code it creates no garbage: `interpret` is a separate function because its closures capture variables, whose scope each call
 * would allocate.
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
 * The minimum number of vertices for machine code in the first run of a program. Making the code takes 2 to 3 times as long as preparing
 * the interpreter; running it takes two thirds of the interpreter's time.
 */
const minVerticesForCode = 30_000

/** A use of a program: which results it computes, and which of its inputs are uniform. */
interface Use {
  wanted: ResultSet
  isUniform: readonly boolean[]
  /** Missing until it is compiled; `null` if the program is too long. */
  code?: MachineCode | null
}

/** Maps a program → its few uses, which are compared one by one, since a string key would create garbage in each call. */
const usesOf = new WeakMap<Program, Use[]>()

/** `true` once a Content-Security-Policy or the engine itself has forbidden compilation of code. */
let isForbidden = false

function machineCodeOf(
  program: Program,
  wanted: ResultSet,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
): MachineCode | null | undefined {
  if (isForbidden) return undefined
  let uses = usesOf.get(program)
  if (!uses) usesOf.set(program, (uses = []))
  let use = findUse(uses, wanted, inputs)
  if (!use) {
    uses.push((use = { wanted, isUniform: inputs.map(({ isUniform }) => isUniform) }))
    if (vertices < minVerticesForCode) return undefined
  }
  const { code } = use
  if (code === null || code?.core === evaluation.get()) return code
  try {
    return (use.code = MachineCode.compile(program, wanted.numbers, inputs, sinks))
  } catch (error) {
    if (error instanceof WarpError) throw error
    isForbidden = true
    return undefined
  }
}

function findUse(
  uses: readonly Use[],
  wanted: ResultSet,
  inputs: readonly Stream[],
): Use | undefined {
  next: for (const use of uses) {
    if (use.wanted !== wanted) continue
    for (let i = 0; i < inputs.length; i++)
      if (inputs[i]!.isUniform !== use.isUniform[i]) continue next
    return use
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
  const maxCount = Math.min(vertices, batchSize)
  withProgram(program, (loaded) =>
    evaluation.use(
      ({ Evaluator }) => new Evaluator(loaded, wanted.numbers, inputs, sinks.map(sizeOf), maxCount),
      (evaluator) => {
        inputs.forEach(({ values, isUniform }, i) => {
          if (isUniform) evaluator.input(i).set(values)
        })
        for (let first = 0; first < vertices; first += maxCount) {
          const count = Math.min(maxCount, vertices - first)
          inputs.forEach(({ values, size, isUniform }, i) => {
            if (!isUniform) copy(evaluator.input(i), 0, values, first * size, count * size)
          })
          evaluator.run(count)
          sinks.forEach(({ values, results: { length: size } }, i) =>
            values.set(evaluator.result(i).subarray(0, count * size), first * size),
          )
        }
      },
    ),
  )
}
