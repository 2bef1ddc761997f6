// Evaluates warps at the vertices of meshes.
import type { Uniforms, Vertices } from '../core/inputs/vertices.js'
import type { CpuWarp } from '../cpu/cpu-warp.js'
import type { WarpedVertices } from '../cpu/results.js'
import { warpProgram, type RunningProgram } from '../cpu/warp-program.js'
import { WarpError, describe } from '../errors/errors.js'
import { isList } from '../options/guards.js'
import { kind } from '../options/kinds.js'
import { anyNumber, firstWrong } from '../options/numbers.js'
import type { Place } from '../options/place.js'

/** A warp that can evaluate vertices: the part of `compileWarp`'s result that meshes need. */
export interface Evaluates extends Pick<CpuWarp, 'evaluate'> {
  /** @internal */
  readonly [warpProgram]?: RunningProgram
}

/** The kind of a warp that runs on the CPU; `makers` names the functions that return one, for messages. */
export const warpKind = (makers = 'compileWarp') =>
  kind<Evaluates>(
    `a result of ${makers}`,
    (value) => typeof (value as Evaluates | undefined)?.evaluate === 'function',
  )

/** Returns whether the warp needs the gradients of normals and uvs over the mesh. */
export const readsVariation = (warp: Evaluates) => warp[warpProgram]?.varies ?? false

/** Calls `warp.evaluate`, and makes its messages name the function that the user called. */
export function evaluateFor(
  place: Place,
  warp: Evaluates,
  vertices: Vertices,
  uniforms?: Uniforms,
): WarpedVertices {
  let warped: WarpedVertices
  try {
    warped = warp.evaluate(vertices, { uniforms })
  } catch (error) {
    // The warp may come from another script, which has its own class WarpError.
    const { name, message = '' } = (error ?? {}) as Partial<Error>
    if (name !== 'WarpError') throw error
    throw new WarpError(message.replace(/^evaluate: /, `${place.method}: `))
  }
  if (!warp[warpProgram]) rejectWrongArrays(place.part("the warp's evaluate"), warped, vertices)
  return warped
}

/** Checks the result of a warp that was made by hand. */
function rejectWrongArrays(place: Place, warped: unknown, vertices: Vertices) {
  const count = vertices.positions.length / 3
  const makeResultError = (what: string, got: string) =>
    place.error(`expected ${place.subject} to return ${what}, got ${got}.`)
  if (typeof warped !== 'object' || warped === null)
    throw makeResultError('{ positions, normals }', describe(warped))
  for (const [name, size] of [
    ['positions', 3],
    ['normals', 3],
    ['tangents', 4],
  ] as const) {
    const numbers = (warped as Record<string, unknown>)[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers) || numbers.length !== size * count)
      throw makeResultError(
        `${name} as an array of ${size * count} numbers, ${size} per vertex`,
        describe(numbers),
      )
    const wrong = firstWrong(numbers, anyNumber)
    if (wrong >= 0) throw makeResultError(`a number as ${name}[${wrong}]`, describe(numbers[wrong]))
  }
}
