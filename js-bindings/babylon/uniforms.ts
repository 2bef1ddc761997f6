// The uniforms of a warp in Babylon.js: the option's values, and those that are set in their place.
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import { samplingOf } from './sampling.js'
import type { BabylonUniform } from './uniform.js'
import { WarpError, describe } from '../errors/errors.js'
import { isCallable } from '../options/options.js'
import { type Shape, imageShape } from '../core/expression/shapes.js'
import {
  type DeclaredUniforms,
  numbersFor,
  readDeclaredOf,
  unknownUniform,
  withSampling,
  withUniforms,
} from '../core/inputs/declared-uniforms.js'
import type { OffsetFunction } from '../core/types/types.js'

const isTexture = (value: unknown): value is BaseTexture =>
  typeof (value as Partial<BaseTexture> | undefined)?.getInternalTexture === 'function'

/** What `inputs/declared-uniforms.ts` knows an image by. */
const plain = (value: unknown): unknown =>
  isTexture(value) ? { width: 1, height: 1, texture: value } : withoutMethods(value)

/** A Color3 has r, g and b, and a Matrix its numbers. */
function withoutMethods(value: unknown): unknown {
  const { r, g, b, a, m } = (value ?? {}) as Record<string, unknown>
  if (r !== undefined && b !== undefined) return a === undefined ? [r, g, b] : [r, g, b, a]
  return m ?? vectorOf(value)
}

function vectorOf(value: unknown): unknown {
  if (typeof value !== 'object' || value === null || !('x' in value)) return value
  const { x, y, z, w } = value as Record<string, unknown>
  return [x, y, z, w].filter((part) => part !== undefined)
}

const now = (given: unknown) => plain(isCallable(given) ? (given as () => unknown)() : given)

export function readUniforms(method: string, offset: OffsetFunction, option: object | undefined) {
  const declared = withSampling(readDeclaredOf(method, option, plain), { hasTransform: true })
  const labels = new Map([...declared.keys()].map((name, i) => [name, `warpjet${i}`]))
  const values: Record<string, unknown> = {}
  const uniforms = [...declared].flatMap(([name, { shape }]): BabylonUniform[] => {
    const label = labels.get(name)!
    let given: unknown = (option as Record<string, unknown>)[name]
    const read = readerOf(`The warp's uniform "${name}"`, shape)
    read(given)
    Object.defineProperty(values, name, {
      enumerable: true,
      get: () => given,
      set(value) {
        // Looked at here, where the mistake is.
        read(value)
        given = value
      },
    })
    if (shape !== imageShape) return [{ label, shape, numbers: () => read(given) as number[] }]
    const image = () => read(given) as BaseTexture
    return [{ label, shape, numbers: () => [], image }, ...samplingOf(label, image)]
  })
  const onCpu: DeclaredUniforms = new Map(
    uniforms.map(({ label, shape, numbers, image }) => [
      label,
      {
        shape,
        numbers,
        isFunction: true,
        ...(image && { image: () => ({ width: 1, height: 1 }) }),
      },
    ]),
  )
  const labelled = withUniforms(method, offset, declared, (name) => labels.get(name)!)
  return { labelled, uniforms, onCpu, values: sealed(method, values) }
}

/** The numbers of a uniform, or its texture; throws for what is neither. */
const readerOf = (place: string, shape: Shape) => (value: unknown) => {
  if (shape !== imageShape) return numbersFor(place, shape, now(value))
  const { texture } = (now(value) ?? {}) as { texture?: BaseTexture }
  if (texture) return texture
  throw new WarpError(`${place} must be a texture of Babylon.js, but is ${describe(value)}.`)
}

/** A name that is none says so. */
const sealed = (method: string, values: Record<string, unknown>) =>
  new Proxy(values, {
    set(target, name, value) {
      if (Object.hasOwn(target, name)) return Reflect.set(target, name, value)
      throw unknownUniform(method, String(name), Object.keys(target))
    },
  })
