// Writes the shader code of a recorded warp, in a language and with the names of a host.
import { drawInputs, vertexInputs } from '../core/inputs/inputs.js'
import { toDeclared, uniqueDeclared, type Compiled, type Declared } from '../core/module/result.js'
import { writeText, type IsFrameConstant, type Target } from '../core/module/serialized-module.js'
import { Place } from '../options/place.js'
import { isFrameUniform } from './frame.js'
import { resultNumber, type RecordedWarp, type Result } from './recorded-warp.js'
import { withoutUndefined, type TextOptions } from './warp-options.js'

/** An offset function as shader code. */
export interface WarpText extends Compiled {
  /** The uniforms that the code reads: millis, mouse, size, pixelDensity, and your own. */
  uniforms: Declared[]
  /** The attributes that the code reads: position, normal, uv, color, tangent, and those of `surfaceVariation`. */
  attributes: Declared[]
}

/** Shader code for a host, which declares the variables that it reads. */
export interface HostText extends WarpText {
  /** Variables of the shader that are not inputs of the warp: those of the option `uniforms`, and parameters. */
  parameters: Declared[]
  /** Names of the uniforms that carry frame constants. */
  frame: string[]
}

export function writeWarp(
  recorded: RecordedWarp,
  target: Target,
  results: readonly Result[],
  options: TextOptions & {
    isFrameConstant?: IsFrameConstant | undefined
    fadesNoise?: boolean
    reflectsAtBorders?: boolean
  } = {},
): HostText {
  const { settings, module, inputs } = recorded
  const { place, surfaceVariation } = settings
  const names: Record<string, string> = { ...settings.names, ...withoutUndefined(options.names) }
  const outputs = { ...settings.outputs, ...withoutUndefined(options.outputs) }
  rejectSplitInputs(inputs, settings.names, names)
  // The module contains the names of the recording. We pass names that differ from these, and expressions such as ( p ).xy.
  const renamed = Object.entries(inputs)
    .filter(([name]) => names[name] !== settings.names[name] || !/^\w+$/.test(names[name]!))
    .map(([name, number]): [number, string] => [number, names[name]!])
  const {
    code,
    declarations,
    stats,
    inputs: inputsRead,
  } = writeText(module, target, {
    inputs: renamed,
    results: results.map((result) => [
      resultNumber(recorded, result, surfaceVariation),
      result in outputs ? outputs[result as keyof typeof outputs] : otherName(result),
    ]),
    isFrameConstant: options.isFrameConstant,
    fadesNoise: options.fadesNoise,
    reflectsAtBorders: options.reflectsAtBorders,
  })
  const numbers = new Set<number>(Object.values(inputs))
  const nonInputs = inputsRead.filter(({ number }) => !numbers.has(number))
  const frame = uniqueDeclared(nonInputs.filter(isFrameUniform))
  const parameters = uniqueDeclared(nonInputs.filter((variable) => !isFrameUniform(variable)))
  const selectInputs = (sizes: Partial<Record<keyof typeof inputs, number>>) =>
    (Object.keys(sizes) as (keyof typeof inputs)[]).flatMap((name) => {
      const input = inputsRead.find(({ number }) => number === inputs[name])
      return input ? toDeclared({ ...input, name }) : []
    })
  const uniforms = selectInputs(drawInputs)
  rejectNamesakes(place, names, uniforms, parameters)
  return {
    code,
    declarations,
    stats,
    uniforms: [...uniforms, ...frame, ...parameters],
    attributes: selectInputs(vertexInputs),
    parameters,
    frame: frame.map(({ name }) => name),
  }
}

/** Returns the name in shader code of a result such as `other0`. */
export const otherName = (result: string) => `warpjet${result[0]!.toUpperCase()}${result.slice(1)}`

/** Throws if a parameter is named like an input that has another name in the shader: `uniforms` would list that name twice. */
function rejectNamesakes(
  place: Place,
  names: Record<string, string>,
  inputs: readonly Declared[],
  parameters: readonly Declared[],
) {
  const taken = new Set(inputs.map(({ name }) => name))
  for (const { name } of parameters)
    if (taken.has(name))
      throw place.error(
        `the shader has a variable "${name}", but the warp reads the input ${name} as "${names[name]}"; rename the variable of the shader.`,
      )
}

const emitPlace = new Place('emit')

/** Throws if inputs that had one name when the warp was recorded, and so are one input, have different names now. */
function rejectSplitInputs(
  inputs: Record<string, number>,
  recordedNames: Record<string, string>,
  names: Record<string, string>,
) {
  const first = new Map<number, string>()
  for (const [name, number] of Object.entries(inputs)) {
    const other = first.get(number) ?? name
    first.set(number, other)
    if (names[name] !== names[other])
      throw emitPlace.error(
        `${other} and ${name} were one input, "${recordedNames[name]}", when the offset was compiled; use one name for both again, or compile it with these names.`,
      )
  }
}
