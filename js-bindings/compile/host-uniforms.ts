// The option `uniforms` in a host: what the shader calls each one, and its value now, as numbers or as the host's image.
import {
  type DeclaredUniform,
  type DeclaredUniforms,
  readDeclared,
  unknownUniform,
} from '../core/inputs/declared-uniforms.js'
import { numbersFor } from '../core/inputs/uniform-values.js'
import { type ShapeName, imageShape, typeOf } from '../core/expression/shapes.js'
import { WarpError, describe } from '../errors/errors.js'
import { isCallable, isList } from '../options/options.js'
import type { Host, HostValues } from './host.js'
import { samplingNumbers, samplingUniforms } from './image-sampling.js'

/** One uniform of the shader. */
export interface HostUniform {
  /** Its name in the shader. */
  label: string
  type: ShapeName
  /** Its numbers now, column by column; none of an image. */
  numbers: () => number[]
  /** Present for an image: returns the image that it is now. */
  image?: () => unknown
}

const plainNumbers: HostValues = { isImage: () => false, toNumbers: (value) => value }

export class HostUniforms {
  /** Maps the user's names to uniforms, with their present values. */
  readonly declared: DeclaredUniforms
  /** The uniforms of the shader. The sampling of an image follows the image. */
  readonly inShader: readonly HostUniform[]
  readonly names: readonly string[]
  private readonly labels: ReadonlyMap<string, string>
  private readonly values: Record<string, unknown>

  constructor(
    private readonly method: string,
    option: object | undefined,
    private readonly host: Host | undefined,
  ) {
    this.values = { ...option }
    this.declared = this.declare(option)
    this.names = [...this.declared.keys()]
    this.labels = new Map(this.names.map((name, i) => [name, host ? `${host.prefix}${i}` : name]))
    this.inShader = [...this.declared].flatMap(([name, uniform]) =>
      this.shaderUniforms(name, uniform),
    )
  }

  /** Returns the name that a uniform has in the shader. */
  readonly labelOf = (name: string): string => this.labels.get(name)!

  /** The value that was given, or what its function gives now. */
  get(name: string): unknown {
    const value = this.values[name]
    return isCallable(value) ? (value as () => unknown)() : value
  }

  /** The value that was given: a function as it is. */
  given(name: string): unknown {
    return this.values[name]
  }

  /** Checks the value here, where the mistake is. */
  set(name: string, value: unknown) {
    if (!this.declared.has(name)) throw this.unknown(name)
    this.read(name, value)
    this.values[name] = value
  }

  unknown(name: string): WarpError {
    return unknownUniform(this.method, name, this.names)
  }

  /** The numbers of a value in the place of the present one. */
  numbersFor(name: string, value: unknown): number[] {
    return numbersFor(placeOf(name), this.declared.get(name)!.shape, value)
  }

  private declare(option: object | undefined): DeclaredUniforms {
    const { values } = this.host ?? {}
    const declared = readDeclared(
      this.method,
      values && isRecord(option) ? this.plain(option) : option,
    )
    const { hasTransform } = this.host?.sampling ?? {}
    return new Map(
      [...declared].map(([name, uniform]) => [
        name,
        {
          ...uniform,
          ...(values && this.liveValue(name, uniform)),
          ...(uniform.image && hasTransform !== undefined && { sampling: { hasTransform } }),
        },
      ]),
    )
  }

  private plain(option: object) {
    return Object.fromEntries(
      Object.entries(option).map(([name, given]: [string, unknown]) => [
        name,
        isCallable(given) ? () => this.toPlain((given as () => unknown)()) : this.toPlain(given),
      ]),
    )
  }

  private toPlain(value: unknown): unknown {
    const { isImage, toNumbers } = this.host?.values ?? plainNumbers
    return isImage(value) ? { width: 1, height: 1, image: value } : toNumbers(value)
  }

  /** Numbers of a list that may change in place, or of another value that was set. */
  private liveValue(name: string, { shape }: DeclaredUniform): Partial<DeclaredUniform> {
    const read = () => this.read(name, this.values[name], shape)
    read()
    const isImage = shape === imageShape
    return {
      isFunction: true,
      value: undefined,
      numbers: () => (isImage ? [] : (read() as number[])),
      image: isImage ? () => ({ width: 1, height: 1, image: read() }) : undefined,
    }
  }

  /** The numbers of a value, or the host's image. */
  private read(name: string, value: unknown, shape = this.declared.get(name)!.shape): unknown {
    const now = this.toPlain(isCallable(value) ? (value as () => unknown)() : value)
    if (shape !== imageShape) return numbersFor(placeOf(name), shape, now)
    const { image } = (now ?? {}) as { image?: unknown }
    if (image) return image
    throw new WarpError(
      `${placeOf(name)} must be a texture of ${this.host!.name}, but is ${describe(value)}.`,
    )
  }

  private shaderUniforms(name: string, { shape, image }: DeclaredUniform): HostUniform[] {
    const label = this.labelOf(name)
    const { numbers } = this.declared.get(name)!
    const uniform = { label, type: typeOf(shape), numbers: () => numbers(this.method) }
    if (!image) return [uniform]
    const read = () => hostImage(image())
    return [{ ...uniform, image: read }, ...this.samplingOf(label, read)]
  }

  private samplingOf(label: string, read: () => unknown): HostUniform[] {
    const { sampling } = this.host ?? {}
    if (!sampling?.read) return []
    const now = () => sampling.read!(read() as never)
    const names = samplingUniforms(label)
    const settings: HostUniform = {
      label: names.settings,
      type: 'vec3',
      numbers: () => samplingNumbers(now()),
    }
    const transform: HostUniform = {
      label: names.transform,
      type: 'mat3',
      numbers: () => [...now().transform!],
    }
    return sampling.hasTransform ? [settings, transform] : [settings]
  }
}

const isRecord = (option: unknown): option is object =>
  typeof option === 'object' && option !== null && !isList(option)

/** Undoes `toPlain` of an image. p5's images are as they were. */
const hostImage = (value: object): unknown => ('image' in value ? value.image : value)

const placeOf = (name: string) => `The warp's uniform "${name}"`
