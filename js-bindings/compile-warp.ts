// `compileWarp`: from an offset function to a warp, as shader text and on the CPU.
import type { Compilation } from './compilation.js'
import { withCompilation } from './compiled.js'
import { type CpuWarp, type WarpProgram, createCpuWarp } from './cpu-warp.js'
import type { OffsetFunction, UniformValues } from './types.js'
import {
  type BuiltWarp,
  type WarpOptions,
  type WarpText,
  buildWarp,
  declareUniforms,
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
 * numbers of length 1 and at right angles to the warped normal, the fourth as it came. `normal`, `uv`
 * and `color` count as constant over the surface: where the offset depends on them, their share of
 * the turn is left out. The same warp runs on the CPU by `evaluate` and its companions. Throws a
 * `WarpError` if the offset is no function, returns no vec3, or misuses an operation, and for wrong
 * options.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  given: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  const settings = readOptions('compileWarp', given as OffsetFunction, options)
  const { offset, declared } = declareUniforms('compileWarp', given as OffsetFunction, options)
  return withCompilation(settings.target, false, (compilation) => {
    const warp = buildWarp(compilation, 'compileWarp', offset, settings)
    return { ...warp.text, ...createCpuWarp({ declared, ...programOf(compilation, warp) }) }
  })
}

/** The tangent that the CPU turns, if the text turns none: a name that no sketch has. */
const hiddenTangent = '_warpjetTangent'

function programOf(compilation: Compilation, warp: BuiltWarp): Omit<WarpProgram, 'declared'> {
  const { inputs, offset, moved, turned } = warp
  const names = { tangent: hiddenTangent, ...warp.names }
  // In the order of numbersOf in cpu-warp.ts.
  const results = [moved]
  if (turned) {
    const operate = operations(compilation)
    const tangent = inputs.tangent ?? compilation.input(names.tangent, [1, 4], 'compileWarp')
    results.push(turned, turnTangent(compilation, warp, tangent, turned))
    results.push(operate('determinant', operate('deformation', offset, inputs.position)))
  }
  return { program: compilation.program(results), hasNormals: turned !== undefined, names }
}
