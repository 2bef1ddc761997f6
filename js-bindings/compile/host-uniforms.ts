// The option `uniforms` in a host: the name of each uniform in the shader, and its current value, as numbers or as the host's image.
import { imageShape, typeOf, type ShapeName } from '../core/expression/shapes.js'
import {
  uniformsKind,
  unknownUniform,
  type DeclaredUniform,
  type DeclaredUniforms,
} from '../core/inputs/declared-uniforms.js'
import { numbersFor } from '../core/inputs/uniform-values.js'
import { describe, type WarpError } from '../errors/errors.js'
import { isCallable, isList } from '../options/guards.js'
import type { Place } from '../options/place.js'
import type { Host, HostValues } from './host.js'
import { samplingNumbers, samplingUniforms } from './image-sampling.js'

/** A uniform of the shader. */
export interface HostUniform {
  /** Its name in the shader. */
  label: string
  type: ShapeName
  /** Returns its current numbers, column by column; empty for an image. */
  numbers: () => number[]
  /** Returns the current image. Present for an image only. */
  image?: () => unknown
}

const plainNumbers: HostValues = { isImage: () => false, toNumbers: (value) => value }

export class HostUniforms {
  /** Maps the user's names to uniforms, with their current values. */
  readonly declared: DeclaredUniforms
  /** The uniforms of the shader. Those for the sampling of an image follow the image. */
  readonly inShader: readonly HostUniform[]
  readonly names: readonly string[]
  private readonly labels: ReadonlyMap<string, string>
  private readonly values: Record<string, unknown>

  constructor(
    /** The call that made the warp. */
    private readonly place: Place,
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

  /** Returns the name of a uniform in the shader. */
  readonly labelOf = (name: string): string => this.labels.get(name)!

  /** Returns the current value of a uniform; if it is a function, what the function returns. */
  get(name: string): unknown {
    const value = this.values[name]
    return isCallable(value) ? (value as () => unknown)() : value
  }

  /** Returns the value that the user set, which may be a function. */
  given(name: string): unknown {
    return this.values[name]
  }

  /** Sets a value. It is checked now, so that an error has the user's line in its stack. */
  set(name: string, value: unknown) {
    if (!this.declared.has(name)) throw this.unknown(name)
    this.read(name, value)
    this.values[name] = value
  }

  /** Returns the error about a name that is not a uniform of the warp. */
  unknown(name: string): WarpError {
    return unknownUniform(this.place, name, this.names)
  }

  /** Returns the numbers of a value that a call passes in place of the current one. */
  numbersFor(name: string, value: unknown, place = this.place): number[] {
    return numbersFor(place.uniform(name), this.declared.get(name)!.shape, value)
  }

  private declare(option: object | undefined): DeclaredUniforms {
    const { values } = this.host ?? {}
    const declared = uniformsKind.read(
      values && isRecord(option) ? this.plain(option) : option,
      this.place,
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

  /** Replaces values of the host's classes by plain ones. */
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

  /** Returns properties that read the value anew each time, since an array may change in place, and another value may be set. */
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

  /** Returns the numbers of a value, or the host's image. */
  private read(name: string, value: unknown, shape = this.declared.get(name)!.shape): unknown {
    const plain = this.toPlain(isCallable(value) ? (value as () => unknown)() : value)
    if (shape !== imageShape) return numbersFor(this.place.uniform(name), shape, plain)
    const { image } = (plain ?? {}) as { image?: unknown }
    if (image) return image
    throw this.place.uniform(name).expected(`a texture of ${this.host!.name}`, describe(value))
  }

  private shaderUniforms(name: string, { shape, image }: DeclaredUniform): HostUniform[] {
    const label = this.labelOf(name)
    const { numbers } = this.declared.get(name)!
    const uniform = { label, type: typeOf(shape), numbers: () => numbers(this.place) }
    if (!image) return [uniform]
    const read = () => hostImage(image())
    return [{ ...uniform, image: read }, ...this.samplingOf(label, read)]
  }

  private samplingOf(label: string, read: () => unknown): HostUniform[] {
    const { sampling } = this.host ?? {}
    if (!sampling?.read) return []
    const currentSampling = () => sampling.read!(read() as never)
    const names = samplingUniforms(label)
    const settings: HostUniform = {
      label: names.settings,
      type: 'vec3',
      numbers: () => samplingNumbers(currentSampling()),
    }
    const transform: HostUniform = {
      label: names.transform,
      type: 'mat3',
      numbers: () => [...currentSampling().transform!],
    }
    return sampling.hasTransform ? [settings, transform] : [settings]
  }
}

const isRecord = (option: unknown): option is object =>
  typeof option === 'object' && option !== null && !isList(option)

/** Returns the image that `toPlain` has wrapped. Images of p5 are not wrapped. */
const hostImage = (value: object): unknown => ('image' in value ? value.image : value)
