// A recorded offset function without evaluation on the CPU: its uniforms, shader code and frame constants.
import type { ReadAsFloats, Variable } from '../core/expression/shapes.js'
import { drawInputs, type InputName } from '../core/inputs/inputs.js'
import { withUniforms } from '../core/inputs/uniform-expressions.js'
import { numbersFor } from '../core/inputs/uniform-values.js'
import { lazily } from '../core/module/lazily.js'
import {
  inputsOf,
  inputsReadBy,
  type IsFrameConstant,
  type Target,
} from '../core/module/serialized-module.js'
import type { OffsetFunction } from '../core/types/types.js'
import { ownProperty } from '../options/guards.js'
import { callback } from '../options/kinds.js'
import { finiteDouble, readNumbers } from '../options/numbers.js'
import type { Place } from '../options/place.js'
import { frameOf, type FrameConstants } from './frame.js'
import { HostUniforms } from './host-uniforms.js'
import type { DrawInput, Host } from './host.js'
import { stageFor } from './normal-stage.js'
import type { NormalStage, NormalsOption } from './normals-option.js'
import { recordWarp, resultNumber, type RecordedWarp, type Result } from './recorded-warp.js'
import { shaderNames } from './shader-names.js'
import { settingsOf, type RecordOptions, type TextOptions } from './warp-options.js'
import { writeWarp, type HostText } from './warp-text.js'

export interface HostOptions extends RecordOptions {
  /** Missing for `compileWarp`, whose shader code is for any host. */
  host?: Host
  /** The option `uniforms` as the user passed it. */
  uniforms?: object | undefined
  /** True if shader code reads frame constants. Default: true for a host. */
  perFrame?: boolean | undefined
}

/**
 * The values of one draw call: maps names of inputs, such as `millis`, and of uniforms → values. A uniform without a value here keeps its
 * current one.
 */
export type DrawValues = Readonly<Record<string, unknown>>

/** An input of the warp: its names in the shader, and among the values of a draw call. */
export interface NamedInput {
  readonly label: string
  readonly name: string
}

const noNumbers: readonly number[] = []

/** Inputs of a draw call that all of its instances share. */
const sharedInputs = (Object.keys(drawInputs) as DrawInput[]).filter((name) => name !== 'instance')

export class OffsetWarp {
  readonly uniforms: HostUniforms
  protected readonly recorded: RecordedWarp
  protected readonly isFrameConstant: IsFrameConstant | undefined
  protected readonly host: Host | undefined
  private readonly userNames: ReadonlyMap<string, string>

  /** Calls the offset function, once. */
  constructor(
    /** The call that makes the warp. */
    protected readonly place: Place,
    offset: OffsetFunction,
    options: HostOptions,
  ) {
    const { host, perFrame = host !== undefined } = options
    callback.read(offset, place)
    this.host = host
    const uniforms = (this.uniforms = new HostUniforms(place, options.uniforms, host))
    const { declared } = uniforms
    if (!host) rejectNamesakes(place, declared.keys(), options.names)
    this.userNames = new Map(uniforms.names.map((name) => [uniforms.labelOf(name), name]))
    const labelled = withUniforms(place, offset, declared, uniforms.labelOf)
    this.recorded = recordWarp(labelled, settingsOf(place, options, host && shaderNames))
    if (host && !host.hasParameters) this.rejectMissing(host)
    this.isFrameConstant = perFrame ? this.frameConstantTest() : undefined
  }

  /** `true` if the warped normal depends on how normal and uv vary over the surface. */
  get varies() {
    return this.recorded.varies
  }

  /** `true` if shader code treats normal and uv as constant although the warped normal depends on how they vary. */
  get isApproximate() {
    return this.recorded.isApproximate
  }

  /** `true` if all vertices move by the same offset, so that normals stay as they are. */
  get isRigid(): boolean {
    return this.inputsOf('offset').length === 0
  }

  /** Tests whether the warped position of a vertex depends on the input. */
  reads(input: InputName): boolean {
    return this.inputNumbersRead().has(this.recorded.inputs[input])
  }

  /** Returns an integer of the host of which the code reads 16 bits at a time; `undefined` if there is none. */
  findHalvedInteger(): ReadAsFloats | undefined {
    return [...this.recorded.module.conversions.values()].find(({ half }) => half)
  }

  /** Returns the numbers of uniforms and of the draw call's inputs that the warped position of a vertex depends on. */
  state(drawValues: DrawValues): number[] {
    const numbers: number[] = []
    this.writeState(drawValues, numbers)
    return numbers
  }

  /**
   * Writes the numbers of `state` to the start of an array, and returns how many there are. Inputs that are numbers create no garbage.
   * Errors name the call `place`. Default: the call that made the warp.
   */
  writeState(drawValues: DrawValues, to: number[], place = this.place): number {
    return this.writeNumbers(this.namedInputsRead(), drawValues, to, place)
  }

  /** Writes the current numbers of inputs like `writeState`. Inputs that differ by vertex have none. */
  protected writeNumbers(
    inputs: readonly NamedInput[],
    drawValues: DrawValues,
    to: number[],
    place: Place,
  ): number {
    let count = 0
    for (const { label, name } of inputs) {
      const value = ownProperty(drawValues, name)
      if (typeof value === 'number' && !this.uniforms.declared.has(name)) to[count++] = value
      else for (const each of this.numbersNow(place, name, label, drawValues)) to[count++] = each
    }
    return count
  }

  /** Adds the names of inputs among the values of a draw call. */
  protected nameInputs(inputs: readonly Variable[]): NamedInput[] {
    return inputs.map((variable) => ({ label: variable.name, name: this.valueNameOf(variable) }))
  }

  /** Returns the stage that computes normals: the option `normals`, with `'auto'` resolved for this warp. */
  stageOfNormals(option: NormalsOption): NormalStage {
    return option === 'auto'
      ? stageFor(this.recorded, this.isFrameConstant, ({ name }) =>
          this.byLabel().get(name)?.numbers(),
        )
      : option
  }

  /** Returns the numbers of a uniform, by its name in the shader: those of a value that the draw call passes, or the current ones. */
  uniformNumbers(label: string, drawValues: DrawValues): readonly number[] {
    return this.numbersNow(this.place, this.userName(label), label, drawValues)
  }

  text(target: Target, results: readonly Result[], options: TextOptions = {}): HostText {
    return writeWarp(this.recorded, target, results, {
      ...options,
      isFrameConstant: this.isFrameConstant,
    })
  }

  /**
   * Writes the code of a fragment shader, in which noise that is finer than a pixel fades, and a pixel on the border of a mesh stays in the
   * domain of the warp. In GLSL ES 1.00 the code does neither, since screen-space derivatives need an extension there.
   */
  fragmentText(target: Target, results: readonly Result[], options: TextOptions = {}): HostText {
    const hasScreenDerivatives = target !== 'glsl100'
    return writeWarp(this.recorded, target, results, {
      ...options,
      isFrameConstant: this.isFrameConstant,
      fadesNoise: this.recorded.settings.fadeNoise && hasScreenDerivatives,
      reflectsAtBorders: hasScreenDerivatives,
    })
  }

  /** Returns the constants of a frame: the same object while the values stay the same. */
  frame(drawValues: DrawValues, place = this.place): FrameConstants {
    return this.frameConstants()((variable) => this.numbersOf(place, variable, drawValues))
  }

  /** Returns the user's names of uniforms and of other variables of the shader. */
  readonly variableNames = lazily((): ReadonlySet<string> => {
    const numbers = new Set<number>(Object.values(this.recorded.inputs))
    const others = inputsOf(this.recorded.module).filter(({ number }) => !numbers.has(number))
    return new Set([...this.uniforms.names, ...others.map(({ name }) => this.userName(name))])
  })

  /** Returns the user's names of the variables that the warped position, normal or tangent depends on. */
  namesRead(): ReadonlySet<string> {
    const results: Result[] = this.recorded.settings.tangents
      ? ['position', 'normal', 'tangent']
      : ['position', 'normal']
    return new Set(this.inputsOf(...results).map(({ name }) => this.userName(name)))
  }

  /** Maps the shader's name of a uniform → the user's name. Other names are unchanged. */
  protected userName(label: string): string {
    return this.userNames.get(label) ?? label
  }

  private readonly inputsRead = lazily(() => this.inputsOf('position'))
  private readonly namedInputsRead = lazily(() => this.nameInputs(this.inputsRead()))
  private readonly inputNumbersRead = lazily(
    () => new Set(this.inputsRead().map(({ number }) => number)),
  )
  private readonly frameConstants = lazily(() =>
    this.isFrameConstant ? frameOf(this.recorded.module, this.isFrameConstant) : () => ({}),
  )
  private readonly byLabel = lazily(
    () => new Map(this.uniforms.inShader.map((uniform) => [uniform.label, uniform])),
  )
  private readonly drawNames = lazily(
    () =>
      new Map<number, DrawInput>(sharedInputs.map((name) => [this.recorded.inputs[name], name])),
  )

  private inputsOf(...results: Result[]): Variable[] {
    const { module, settings } = this.recorded
    const numbers = results.map((each) =>
      resultNumber(this.recorded, each, settings.surfaceVariation),
    )
    return inputsReadBy(module, numbers)
  }

  /** Makes the test for inputs that are constant during a frame: those of the draw call, and uniforms except images. */
  private frameConstantTest(): IsFrameConstant {
    const { inputs } = this.recorded
    const numbers = new Set(sharedInputs.map((name) => inputs[name]))
    const labels = new Set(
      this.uniforms.inShader.filter(({ image }) => !image).map(({ label }) => label),
    )
    return ({ name, number }) => numbers.has(number) || labels.has(name)
  }

  /** Returns the name of an input among the values of a draw call. */
  private valueNameOf({ number, name: label }: Variable): string {
    return this.drawNames().get(number) ?? this.userName(label)
  }

  private numbersNow(
    place: Place,
    name: string,
    label: string,
    drawValues: DrawValues,
  ): readonly number[] {
    const value = ownProperty(drawValues, name)
    if (value === undefined) return this.byLabel().get(label)?.numbers() ?? noNumbers
    return this.uniforms.declared.has(name)
      ? this.uniforms.numbersFor(name, value, place)
      : [value as number | number[]].flat()
  }

  private numbersOf(place: Place, variable: Variable, drawValues: DrawValues): readonly number[] {
    const {
      name: label,
      shape: [columns, rows],
    } = variable
    const name = this.valueNameOf(variable)
    const value = ownProperty(drawValues, name)
    const uniform = this.uniforms.declared.get(name)
    if (value === undefined && uniform) return uniform.numbers(place)
    const sampling = this.byLabel().get(label)
    if (value === undefined && sampling) return sampling.numbers()
    if (value === undefined)
      throw place.error(`the warp reads "${name}"; pass a value, as in { ${name}: 0 }.`)
    const uniformPlace = place.uniform(name)
    return uniform
      ? numbersFor(uniformPlace, uniform.shape, value)
      : readNumbers(uniformPlace, value, columns * rows, { test: finiteDouble })
  }

  /** Throws for an input that the host lacks, and for a `glsl.param` that is not declared. */
  private rejectMissing({ name: host, inputs: provided, advice = {} }: Host) {
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
        throw this.place.error(
          `the offset reads "${label}" by glsl.param, which no shader of ${host} declares; read it as uniforms.${label}, with the option { uniforms: { ${label}: … } }.`,
        )
      }
      if (!(input in drawInputs) || provided.includes(input as DrawInput)) continue
      const remedy =
        advice[input as DrawInput] ??
        `declare it, as in { uniforms: { my${input[0]!.toUpperCase()}${input.slice(1)}: ${drawInputs[input as DrawInput] === 1 ? 1 : '[0, 0]'} } }`
      throw this.place.error(`the offset reads ${input}, which ${host} does not have; ${remedy}.`)
    }
  }
}

/** Throws for a uniform that has the shader's name of an input. */
function rejectNamesakes(
  place: Place,
  uniforms: Iterable<string>,
  names: TextOptions['names'] = {},
) {
  const declared = new Set(uniforms)
  for (const [input, name] of Object.entries(names))
    if (declared.has(name))
      throw place.error(
        `the uniform "${name}" has the name that the option "names" gives to ${input}; rename one of them.`,
      )
}
