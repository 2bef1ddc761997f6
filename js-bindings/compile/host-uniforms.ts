// The option `uniforms` in a host: the name of each uniform in the shader, and its value now, as numbers or as the host's image.
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
  /** Returns its numbers now, column by column; empty for an image. */
  numbers: () => number[]
  /** Present for an image: returns its present image. */
  image?: () => unknown
}

const plainNumbers: HostValues = { isImage: () => false, toNumbers: (value) => value }

export class HostUniforms {
  /** Maps the user's names to uniforms, with their present values. */
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

  /** Returns the present value; that of a function is what it returns. */
  get(name: string): unknown {
    const value = this.values[name]
    return isCallable(value) ? (value as () => unknown)() : value
  }

  /** Returns the value that the user set, which may be a function. */
  given(name: string): unknown {
    return this.values[name]
  }

  /** Sets and checks a value, so that an error has the user's line in its stack. */
  set(name: string, value: unknown) {
    if (!this.declared.has(name)) throw this.unknown(name)
    this.read(name, value)
    this.values[name] = value
  }

  unknown(name: string): WarpError {
    return unknownUniform(this.place, name, this.names)
  }

  /** Reads a value that a call passes in place of the present one. */
  numbersFor(name: string, value: unknown): number[] {
    return numbersFor(this.place.uniform(name), this.declared.get(name)!.shape, value)
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

  /** Replaces values of the host's classes. */
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

  /** Reads the value anew each time, since an array may change in place, and another value may be set. */
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
    const now = this.toPlain(isCallable(value) ? (value as () => unknown)() : value)
    if (shape !== imageShape) return numbersFor(this.place.uniform(name), shape, now)
    const { image } = (now ?? {}) as { image?: unknown }
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

/** Undoes `toPlain` for an image. Images of p5 are not wrapped. */
const hostImage = (value: object): unknown => ('image' in value ? value.image : value)
