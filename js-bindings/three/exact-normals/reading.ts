// Reads where a vertex shader moves vertices, as a warp.
import type { IUniform } from 'three'
import { readOffset } from '../../glsl-source/offset.js'
import type { External } from '../../glsl-source/listing.js'
import { asOwn } from '../../errors/operators.js'
import { Place } from '../../options/place.js'
import type { Settings, WarpSpace } from '../settings.js'
import { ThreeWarp } from '../three-warp.js'
import { three } from '../values.js'
import type { ExactShader } from './shader.js'
import { movedFunction, vertexSource } from './vertex-source.js'

/** A variable of the shader that the displacement reads there, and that the CPU has no value of. */
export interface Parameter {
  name: string
  type: string
  isAttribute: boolean
}

export interface Reading {
  warp: ThreeWarp
  parameters: readonly Parameter[]
}

export type ExactSettings = Pick<Settings, 'method' | 'normals' | 'surfaceVariation'>

const host = { ...three, hasParameters: true }

/**
 * Returns the displacement of a shader; `undefined` if it moves no vertex, or all by the same offset. `values` are uniforms in
 * addition to those of the shader, which the CPU knows.
 */
export function readDisplacement(
  shader: ExactShader,
  settings: ExactSettings,
  space: WarpSpace,
  values: Record<string, () => unknown> = {},
): Reading | undefined {
  const { text, attributes } = vertexSource(shader)
  const { offset, externals } = readOffset(new Place(settings.method), 'glsl', text, {
    function: movedFunction,
    returns: 'position',
    maxIterations: 256,
  })
  const uniforms: Record<string, () => unknown> = {}
  for (const external of externals) {
    const value = values[external.name] ?? valueOf(shader.uniforms, external, attributes)
    if (value) uniforms[external.name] = value
  }
  const warp = new ThreeWarp(
    // Withholds the other inputs, since millis, size and instance are names of the shader here.
    asOwn(({ glsl, position, normal, uv, uniforms }) =>
      offset({ glsl, position, normal, uv, uniforms } as never),
    ),
    { ...settings, space, uniforms, isShared: false },
    host,
  )
  if (warp.isRigid) return undefined
  const read = warp.namesRead()
  const inputs = new Set(['position', 'normal', 'uv'])
  return {
    warp,
    parameters: externals
      .filter(
        ({ name, type, isRead }) =>
          !inputs.has(name) && !uniforms[name] && (isSampler(type) ? isRead : read.has(name)),
      )
      .map(({ name, type }) => ({
        name,
        type,
        isAttribute: attributes.has(name) || name.startsWith('gl_'),
      })),
  }
}

const isSampler = (type: string) => /sampler/i.test(type)

/** Returns a function for the present value of a uniform; `undefined` if the shader has no usable one. */
function valueOf(
  uniforms: Record<string, IUniform>,
  { name, shape, type }: External,
  attributes: ReadonlySet<string>,
): (() => unknown) | undefined {
  const [root = '', ...path] = name.match(/\w+/g) ?? []
  const uniform = uniforms[root]
  if (!uniform || attributes.has(root)) return undefined
  const read = () =>
    path.reduce<unknown>(
      (value, part) => (value as Record<string, unknown> | undefined)?.[part],
      uniform.value,
    )
  return isUsable(read(), type, shape) ? read : undefined
}

function isUsable(value: unknown, type: string, [columns, rows]: readonly [number, number]) {
  if (isSampler(type)) return type === 'sampler2D' && host.values!.isImage(value)
  if (typeof value === 'boolean') return type === 'bool'
  const numbers = [host.values!.toNumbers(value)].flat() as unknown[]
  const all = ArrayBuffer.isView(numbers[0]) ? [...(numbers[0] as Float32Array)] : numbers
  return all.length === columns * rows && all.every((each) => typeof each === 'number')
}
