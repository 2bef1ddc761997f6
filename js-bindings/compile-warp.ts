// `compileWarp`: from an offset function to a warp, as shader text and on the CPU.
import type { Compilation } from './compilation.js'
import { withCompilation } from './compiled.js'
import { type CpuWarp, createCpuWarp } from './cpu-warp.js'
import type { OffsetFunction, UniformValues } from './types.js'
import type { WarpProgram } from './warp-program.js'
import {
  type BuiltWarp,
  type WarpOptions,
  type WarpText,
  buildWarp,
  declareUniforms,
  noteIfApproximate,
  operations,
  readOptions,
  turnTangent,
} from './warp-text.js'

/** An offset function as shader text and on the CPU. */
export interface CompiledWarp extends WarpText, CpuWarp {}

/**
 * Compiles an offset function into statements that move a vertex and turn its normal. They declare
 * `vec3 offset, warpedPosition, warpedNormal`; the normal has length 1, or 0 where the warp
 * collapses the surface. With `tangents: true` they declare `vec4 warpedTangent` too: its first three
 * numbers of length 1 and at right angles to the warped normal, the fourth as it came. `color` counts
 * as constant over the surface, and so do `normal` and `uv` in the text without the option
 * `surfaceVariation`: where the offset depends on them, their share of the turn is left out then. The same warp runs on the CPU by `evaluate` and its companions. Throws a
 * `WarpError` if the offset is no function, returns no vec3, or misuses an operation, and for wrong
 * options.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  given: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  const settings = readOptions('compileWarp', given as OffsetFunction, options)
  const { offset, declared } = declareUniforms('compileWarp', given as OffsetFunction, options)
  return withCompilation(settings.target, (compilation) => {
    const warp = buildWarp(compilation, 'compileWarp', offset, settings)
    noteIfApproximate(warp)
    return { ...warp.text, ...createCpuWarp({ declared, ...programOf(compilation, warp) }) }
  })
}

function programOf(compilation: Compilation, warp: BuiltWarp): Omit<WarpProgram, 'declared'> {
  const { inputs, moved, deformation, varies, isAccepted } = warp
  // The tangent is first, for a shader may carry it in the place of another attribute.
  const names = { tangent: warp.names.tangent!, ...warp.names }
  // In the order of numbersOf in cpu-warp.ts.
  const results = [moved]
  if (deformation) {
    const operate = operations(compilation)
    const turned = operate('turnNormal', deformation, inputs.normal)
    results.push(turned, turnTangent(compilation, deformation, inputs.tangent!, turned))
    results.push(operate('determinant', deformation))
  }
  const hasNormals = deformation !== undefined
  return { program: compilation.program(results), hasNormals, varies, isAccepted, names }
}
