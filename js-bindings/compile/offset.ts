// What both kinds of `compileWarp` do: the offset function is called, and texts are written of what is kept of it.
import { finiteDouble, readNumbers } from '../options/numbers.js'
import { WarpError } from '../errors/errors.js'
import { drawInputs } from '../core/inputs/inputs.js'
import { type DeclaredUniforms, numbersFor } from '../core/inputs/declared-uniforms.js'
import type { Variable } from '../core/expression/shapes.js'
import { type Uniforms, checkUniforms } from '../core/inputs/vertices.js'
import { type Known, type Target, checkTarget, inputsOf } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { type FrameUniforms, frameOf } from './frame.js'
import { noteApproximation } from '../errors/notes.js'
import { checkOptions, own } from '../options/options.js'
import type { OffsetFunction } from '../core/types/types.js'
import {
  type KeptWarp,
  type TextOptions,
  type WarpOptions,
  type WarpText,
  checkNames,
  declareUniforms,
  keepWarp,
  readOptions,
  writeWarp,
} from './warp-text.js'

export function compileOffset(given: OffsetFunction, options: WarpOptions) {
  const settings = readOptions('compileWarp', given, options)
  const { offset, declared } = declareUniforms('compileWarp', given, options)
  const warp = keepWarp(offset, settings)
  const known = options.perFrame ? knownOf(warp, declared) : undefined
  const { text } = writeWarp(warp, settings.target, { known })
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  const emit = (target: Target, more: TextOptions = {}): WarpText => {
    checkOptions('emit', more, ['names', 'outputs'])
    checkNames('emit', more)
    return writeWarp(warp, checkTarget(target), { ...more, known }).text
  }
  const frame = lazily(() => known && frameOf(warp, known))
  const valuesOfFrame: ValuesOfFrame = (method, given) =>
    valuesOf(method, warp, declared, given, frame())
  const uniformNames = lazily(() => namesOf(warp, declared))
  const frameUniforms = (given: Uniforms = {}) => {
    checkUniforms('frameUniforms', given, uniformNames())
    return valuesOfFrame('frameUniforms', given)
  }
  return { warp, declared, text, known, valuesOfFrame, emits: { emit, frameUniforms } }
}

/** The names that `frameUniforms` accepts beside those of a draw call: declared uniforms and other parameters of the shader. */
function namesOf({ inputs, module }: KeptWarp, declared: DeclaredUniforms): ReadonlySet<string> {
  const numbers = new Set(Object.values(inputs))
  const others = inputsOf(module).filter(({ number }) => !numbers.has(number))
  return new Set([...declared.keys(), ...others.map(({ name }) => name)])
}

/** All of a draw call but which one of several instances is drawn. */
const frameInputs = Object.keys(drawInputs).filter((name) => name !== 'instance')

/** Inputs of a draw call, and what the option `uniforms` declares; other names may be anything of the shader. */
function knownOf({ inputs }: KeptWarp, declared: DeclaredUniforms): Known {
  const numbers = new Set(frameInputs.map((name) => inputs[name]))
  return ({ name, number }) =>
    numbers.has(number) || (declared.has(name) && !declared.get(name)!.image)
}

function valuesOf(
  method: string,
  { inputs }: KeptWarp,
  declared: DeclaredUniforms,
  given: Readonly<Record<string, unknown>>,
  frame: ReturnType<typeof frameOf>,
): FrameUniforms {
  const names = new Map(frameInputs.map((name) => [inputs[name], name]))
  const numbersOf = ({ number, name: label, shape: [columns, rows] }: Variable) => {
    const name = names.get(number) ?? label
    const value = own(given, name)
    const uniform = declared.get(name)
    const place = `${method}: the uniform "${name}"`
    if (value === undefined && uniform) return uniform.numbers(method)
    if (value === undefined)
      throw new WarpError(
        `${method}: the warp reads "${name}"; give it a value, as in { ${name}: 0 }.`,
      )
    return uniform
      ? numbersFor(place, uniform.shape, value)
      : readNumbers(place, value, columns * rows, finiteDouble)
  }
  return frame?.(numbersOf) ?? {}
}

/** The vec4s of the frame, from uniforms that were checked. */
export type ValuesOfFrame = (
  method: string,
  given: Readonly<Record<string, unknown>>,
) => FrameUniforms

/** What a compiled warp has beside its text. */
export interface Emits {
  /**
   * The text once more: in another language, or for a host with other names. The offset function is not called again, so
   * that it is the same warp, also if it was made by chance. What is not given is as in the options of `compileWarp`.
   */
  emit(target: Target, options?: TextOptions): WarpText
  /**
   * With the option `perFrame`: values for the vec4s `warpjetFrame0`, … among `uniforms`, to be set each frame. It takes the inputs
   * that are the same for a frame, such as `{ millis: performance.now() }`, and values in the place of those that the option `uniforms` gave.
   * Throws a `WarpError` for a value that is missing or wrong.
   */
  frameUniforms(inputs?: Uniforms): FrameUniforms
}
