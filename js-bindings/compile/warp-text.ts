// The text of a recorded warp, in a language and under the names of a host.
import { type Declared, type Compiled, declared, declaredOf } from '../core/module/result.js'
import { resultName } from '../core/expression/session.js'
import { drawInputs, vertexInputs } from '../core/inputs/inputs.js'
import { type Known, type Target, writeText } from '../core/module/kept-module.js'
import { WarpError } from '../errors/errors.js'
import { isFrameConstant } from './frame.js'
import { type RecordedWarp, type Result, resultNumber } from './recorded-warp.js'
import { type TextOptions, withoutGaps } from './warp-options.js'

/** An offset function as shader text. */
export interface WarpText extends Compiled {
  /** The inputs that are read and are the same for a whole draw call: millis, mouse, size,
   * pixelDensity, and the sketch's own parameters. */
  uniforms: Declared[]
  /** The inputs that are read and differ by vertex: position, normal, uv, color, tangent, and those of
   * `surfaceVariation`. */
  attributes: Declared[]
}

/** A text for a host, which declares what the text reads. */
export interface HostText extends WarpText {
  /** Variables of the shader that are no inputs of the warp: uniforms of the option, and parameters. */
  parameters: Declared[]
  /** Names of the frame constants. */
  frame: string[]
}

export function writeWarp(
  recorded: RecordedWarp,
  target: Target,
  results: readonly Result[],
  options: TextOptions & { known?: Known | undefined } = {},
): HostText {
  const { settings, module, inputs } = recorded
  const { method, surfaceVariation } = settings
  const names: Record<string, string> = { ...settings.names, ...withoutGaps(options.names) }
  const outputs = { ...settings.outputs, ...withoutGaps(options.outputs) }
  checkMerged(inputs, settings.names, names)
  // A plain name is in the module as it was when the offset was recorded.
  const renamed = Object.entries(inputs)
    .filter(([name]) => names[name] !== settings.names[name] || !/^\w+$/.test(names[name]!))
    .map(([name, number]): [number, string] => [number, names[name]!])
  const {
    code,
    declarations,
    stats,
    inputs: read,
  } = writeText(module, target, {
    inputs: renamed,
    results: results.map((result) => [
      resultNumber(recorded, result, surfaceVariation),
      resultName(outputs[result], `${method} outputs`),
    ]),
    known: options.known,
  })
  const numbers = new Set<number>(Object.values(inputs))
  const others = read.filter(({ number }) => !numbers.has(number))
  const frame = declaredOf(others.filter(isFrameConstant))
  const parameters = declaredOf(others.filter((variable) => !isFrameConstant(variable)))
  const among = (sizes: Partial<Record<keyof typeof inputs, number>>) =>
    (Object.keys(sizes) as (keyof typeof inputs)[]).flatMap((name) => {
      const input = read.find(({ number }) => number === inputs[name])
      return input ? declared({ ...input, name }) : []
    })
  const uniforms = among(drawInputs)
  refuseNamesakes(method, names, uniforms, parameters)
  return {
    code,
    declarations,
    stats,
    uniforms: [...uniforms, ...frame, ...parameters],
    attributes: among(vertexInputs),
    parameters,
    frame: frame.map(({ name }) => name),
  }
}

/** A parameter under the name of an input that the shader calls otherwise: both would be one uniform. */
function refuseNamesakes(
  method: string,
  labels: Record<string, string>,
  inputs: readonly Declared[],
  parameters: readonly Declared[],
) {
  const taken = new Set(inputs.map(({ name }) => name))
  for (const { name } of parameters)
    if (taken.has(name))
      throw new WarpError(
        `${method}: the shader's "${name}" has the name of the input ${name}, which the warp reads as "${labels[name]}"; rename it.`,
      )
}

/** Inputs that had one name when the function was called are one. */
function checkMerged(
  inputs: Record<string, number>,
  were: Record<string, string>,
  are: Record<string, string>,
) {
  const first = new Map<number, string>()
  for (const [name, number] of Object.entries(inputs)) {
    const other = first.get(number) ?? name
    first.set(number, other)
    if (are[name] !== are[other])
      throw new WarpError(
        `emit: ${other} and ${name} were one input, "${were[name]}", when the offset was compiled; give both one name again, or compile it with these names.`,
      )
  }
}
