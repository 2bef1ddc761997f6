// `compileWarp`: from an offset function to a warp, as shader text and on the CPU.
import { type Emits, type ValuesOfFrame, compileOffset } from './offset.js'
import { type CpuWarp, createCpuWarp } from '../cpu/cpu-warp.js'
import type { DeclaredUniforms } from '../core/inputs/declared-uniforms.js'
import { type Known, makeProgram } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { warpResults } from '../wasm/tables.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type KeptWarp, type WarpOptions, type WarpText, onSurface } from './warp-text.js'

/** An offset function as shader text and on the CPU. */
export interface CompiledWarp extends WarpText, Emits, CpuWarp {}

/**
 * Compiles an offset function into statements that move a vertex and turn its normal. They declare
 * `vec3 offset, warpedPosition, warpedNormal`; the normal has length 1, or 0 where the warp
 * collapses the surface, and points outwards even if the warp mirrors all of space. With `tangents: true` they also declare
 * `vec4 warpedTangent`: its xyz has length 1 and is at right angles to the warped normal; its w is that of the input tangent, or
 * its negative if the warp mirrors all of space. `color` counts
 * as constant over the surface, and so do `normal` and `uv` in the text without the option
 * `surfaceVariation`: where the offset depends on them, their share of the turn is left out then. The same warp runs on the CPU by `evaluate` and its companions. Throws a
 * `WarpError` if the offset is no function, returns no vec3, or misuses an operation, and for wrong
 * options.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  given: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  const { warp, declared, text, emits, known, valuesOfFrame } = compileOffset(
    given as OffsetFunction,
    options,
  )
  return {
    ...text,
    ...emits,
    ...runOnCpu(warp, declared, 'position', undefined, known, known && valuesOfFrame),
  }
}

/**
 * What is kept of an offset function, on the CPU. With `place: 'offset'` it gives how far a vertex moves, in place of where. `nameOf`
 * tells what the user calls an input that the text calls otherwise. With `known` it reads the vec4s of the frame in place of what
 * they are computed from; `valuesOfFrame` gives them, unless `declared` has them.
 */
export const runOnCpu = (
  warp: KeptWarp,
  declared: DeclaredUniforms,
  place: 'position' | 'offset' = 'position',
  nameOf = (name: string) => name,
  known?: Known,
  valuesOfFrame?: ValuesOfFrame,
): CpuWarp =>
  createCpuWarp({
    declared,
    valuesOfFrame,
    program: lazily(() => {
      const program = programOf(warp, place, known)
      const inputs = program?.inputs.map((each) => ({ ...each, name: nameOf(each.name) }))
      return program && { ...program, inputs: inputs! }
    }),
    directionProgram: lazily(() =>
      makeProgram(warp.module, [warpResults.position, warpResults.direction].map(onSurface), known),
    ),
    // No function of the host decides it.
    orientationProgram: lazily(() => makeProgram(warp.module, [warpResults.orientation], known)!),
    hasNormals: warp.settings.normals,
    varies: warp.varies,
    isAccepted: warp.settings.isAccepted,
    // The tangent is first, for a shader may carry it in the place of another attribute.
    inputs: { tangent: warp.inputs.tangent!, ...warp.inputs },
  })

/** In the order of numbersOf in cpu-warp.ts. */
function programOf(
  { module, settings }: KeptWarp,
  place: 'position' | 'offset',
  known: Known | undefined,
) {
  const { [place]: position, normal, tangent, determinant } = warpResults
  const results = settings.normals ? [position, normal, tangent, determinant] : [position]
  return makeProgram(module, results.map(onSurface), known)
}
