// An offset function as far as it is not run on vertices: its uniforms, texts and frame constants.
import { withUniforms } from '../core/inputs/uniform-expressions.js'
import { numbersFor } from '../core/inputs/uniform-values.js'
import { type InputName, drawInputs } from '../core/inputs/inputs.js'
import { type Known, type Target, inputsOf, inputsReadBy } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import type { Variable } from '../core/expression/shapes.js'
import type { OffsetFunction } from '../core/types/types.js'
import { WarpError } from '../errors/errors.js'
import { checkCallback, own } from '../options/options.js'
import { finiteDouble, readNumbers } from '../options/numbers.js'
import { type FrameConstants, frameOf } from './frame.js'
import type { DrawInput, Host } from './host.js'
import { HostUniforms } from './host-uniforms.js'
import { type RecordedWarp, type Result, recordWarp, resultNumber } from './recorded-warp.js'
import { shaderNames } from './shader-names.js'
import { type RecordOptions, type TextOptions, settingsOf } from './warp-options.js'
import { type HostText, writeWarp } from './warp-text.js'

export interface HostOptions extends RecordOptions {
  /** Missing for `compileWarp`, whose texts are for any host. */
  host?: Host
  /** The option `uniforms`, as the user wrote it. */
  uniforms?: object | undefined
  /** `true` if texts read frame constants. Default: `true` for a host. */
  perFrame?: boolean | undefined
}

/** Maps names to the values of a draw call's inputs, and to values that replace those of uniforms. */
export type DrawValues = Readonly<Record<string, unknown>>

/** Inputs of a draw call that are the same for all of its instances. */
const frameInputs = (Object.keys(drawInputs) as DrawInput[]).filter((name) => name !== 'instance')

export class OffsetWarp {
  readonly uniforms: HostUniforms
  protected readonly recorded: RecordedWarp
  protected readonly known: Known | undefined
  protected readonly host: Host | undefined
  private readonly userNames: ReadonlyMap<string, string>

  /** Calls the offset function, once. */
  constructor(
    protected readonly method: string,
    offset: OffsetFunction,
    options: HostOptions,
  ) {
    const { host, perFrame = host !== undefined } = options
    checkCallback(method, offset)
    this.host = host
    const uniforms = (this.uniforms = new HostUniforms(method, options.uniforms, host))
    const { declared } = uniforms
    if (!host) rejectNamesakes(method, declared.keys(), options.names)
    this.userNames = new Map(uniforms.names.map((name) => [uniforms.labelOf(name), name]))
    const labelled = withUniforms(method, offset, declared, uniforms.labelOf)
    this.recorded = recordWarp(labelled, settingsOf(method, options, host && shaderNames))
    if (host && !host.hasParameters) this.rejectMissing(host)
    this.known = perFrame ? this.frameInputs() : undefined
  }

  /** `true` if the warped normal depends on how normal and uv vary over the surface. */
  get varies() {
    return this.recorded.varies
  }

  /** `true` if texts treat normal and uv as constant although the warped normal depends on how they vary. */
  get isApproximate() {
    return this.recorded.isApproximate
  }

  /** Tests whether the place of a vertex depends on the input. */
  reads(input: InputName): boolean {
    return this.numbersRead().has(this.recorded.inputs[input])
  }

  /** The numbers that the place of a vertex depends on, of uniforms and of inputs of the draw call. */
  state(given: DrawValues): number[] {
    return this.inputsRead().flatMap((variable) => this.stateOf(variable, given))
  }

  text(target: Target, results: readonly Result[], options: TextOptions = {}): HostText {
    return writeWarp(this.recorded, target, results, { ...options, known: this.known })
  }

  /** The constants of a frame. While the values stay the same, so does the object. */
  frame(given: DrawValues, method = this.method): FrameConstants {
    return this.frameConstants()((variable) => this.numbersOf(method, variable, given))
  }

  /** Names of uniforms and of other variables of the shader, as users call them. */
  readonly variableNames = lazily((): ReadonlySet<string> => {
    const numbers = new Set<number>(Object.values(this.recorded.inputs))
    const others = inputsOf(this.recorded.module).filter(({ number }) => !numbers.has(number))
    return new Set([...this.uniforms.names, ...others.map(({ name }) => this.userName(name))])
  })

  /** The user's name of a uniform, by the shader's; any other name as it is. */
  protected userName(label: string): string {
    return this.userNames.get(label) ?? label
  }

  private readonly inputsRead = lazily(() => this.inputsOf('position'))
  private readonly numbersRead = lazily(
    () => new Set(this.inputsRead().map(({ number }) => number)),
  )
  private readonly frameConstants = lazily(() =>
    this.known ? frameOf(this.recorded.module, this.known) : () => ({}),
  )
  private readonly byLabel = lazily(
    () => new Map(this.uniforms.inShader.map((uniform) => [uniform.label, uniform])),
  )
  private readonly drawNames = lazily(
    () => new Map<number, DrawInput>(frameInputs.map((name) => [this.recorded.inputs[name], name])),
  )

  private inputsOf(...results: Result[]): Variable[] {
    const { module, settings } = this.recorded
    const numbers = results.map((each) =>
      resultNumber(this.recorded, each, settings.surfaceVariation),
    )
    return inputsReadBy(module, numbers)
  }

  /** Inputs that are the same for a whole frame: those of the draw call, and uniforms but images. */
  private frameInputs(): Known {
    const { inputs } = this.recorded
    const numbers = new Set(frameInputs.map((name) => inputs[name]))
    const labels = new Set(
      this.uniforms.inShader.filter(({ image }) => !image).map(({ label }) => label),
    )
    return ({ name, number }) => numbers.has(number) || labels.has(name)
  }

  private stateOf({ number, name }: Variable, given: DrawValues): readonly number[] {
    const input = this.drawNames().get(number)
    return input
      ? [given[input] as number | number[]].flat()
      : (this.byLabel().get(name)?.numbers() ?? [])
  }

  private numbersOf(
    method: string,
    { number, name: label, shape: [columns, rows] }: Variable,
    given: DrawValues,
  ): readonly number[] {
    const name = this.drawNames().get(number) ?? this.userName(label)
    const value = own(given, name)
    const uniform = this.uniforms.declared.get(name)
    const place = `${method}: the uniform "${name}"`
    if (value === undefined && uniform) return uniform.numbers(method)
    const ofSampling = this.byLabel().get(label)
    if (value === undefined && ofSampling) return ofSampling.numbers()
    if (value === undefined)
      throw new WarpError(
        `${method}: the warp reads "${name}"; give it a value, as in { ${name}: 0 }.`,
      )
    return uniform
      ? numbersFor(place, uniform.shape, value)
      : readNumbers(place, value, columns * rows, finiteDouble)
  }

  private rejectMissing({ name: host, inputs: known, advice = {} }: Host) {
    const { inputs, settings } = this.recorded
    const results: Result[] = settings.tangents
      ? ['position', 'normal', 'tangent']
      : ['position', 'normal']
    const names = new Map(Object.entries(inputs).map(([name, number]) => [number, name]))
    const labels = this.byLabel()
    for (const { number, name: label } of this.inputsOf(...results)) {
      const input = names.get(number)
      if (!input) {
        // The size of an image has no name.
        if (!label || labels.has(label)) continue
        throw new WarpError(
          `${this.method}: the offset reads "${label}" by glsl.param, which no shader of ${host} declares; read it as uniforms.${label}, with the option { uniforms: { ${label}: … } }.`,
        )
      }
      if (!(input in drawInputs) || known.includes(input as DrawInput)) continue
      const remedy =
        advice[input as DrawInput] ??
        `declare it, as in { uniforms: { my${input[0]!.toUpperCase()}${input.slice(1)}: ${drawInputs[input as DrawInput] === 1 ? 1 : '[0, 0]'} } }`
      throw new WarpError(
        `${this.method}: the offset reads ${input}, which ${host} does not have; ${remedy}.`,
      )
    }
  }
}

/** Throws for a uniform under the name that the text has for an input. */
function rejectNamesakes(
  method: string,
  uniforms: Iterable<string>,
  names: TextOptions['names'] = {},
) {
  const declared = new Set(uniforms)
  for (const [input, name] of Object.entries(names))
    if (declared.has(name))
      throw new WarpError(
        `${method}: the uniform "${name}" has the name that the option "names" gives to ${input}; rename one of them.`,
      )
}
