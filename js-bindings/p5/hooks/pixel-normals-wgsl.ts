/** Normals at each pixel on WebGPU; see pixel-code.ts. Varyings are globals of both stages. */
import type { Declared } from '../../compile/hosts.js'
import type { Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { nameOfPixel, normalVarying } from './pixel-code.js'
import type { PixelCode } from './styles.js'

const types: Partial<Record<Declared['type'], string>> = {
  float: 'f32',
  vec2: 'vec2<f32>',
  vec3: 'vec3<f32>',
  vec4: 'vec4<f32>',
}

export const pixelVaryings = (pixel: PixelCode | undefined) =>
  pixel?.varyings.map(({ name, type }) => `${name}: ${types[type]}`) ?? []

/** Returns statements that pass the inputs of the warp to pixels. `names` are the vertex shader's expressions for them. */
export const passInputs = (
  pixel: PixelCode | undefined,
  names: Readonly<Record<string, string>>,
): string =>
  pixel?.varyings
    .map(({ input, name }) => {
      const value = names[input]!
      return `  ${name} = ${input === 'normal' ? `vec4<f32>(${value}, length(${value}))` : value};\n`
    })
    .join('') ?? ''

/**
 * Returns statements that define the inputs of the code: interpolation shortens a normal and rounds the number of an instance.
 */
export function readInputs({ varyings }: PixelCode): string {
  const names = new Set(varyings.map(({ name }) => name))
  const [normal, instance] = ['normal', 'instance'].map(nameOfPixel)
  return [
    names.has(normalVarying) &&
      `  let ${normal} = ${normalVarying}.xyz * (${normalVarying}.w / max(length(${normalVarying}.xyz), 1e-30));\n`,
    names.has(instance!) && `  let ${instance} = round(${instance});\n`,
  ]
    .filter(Boolean)
    .join('')
}

/** Returns the transform of normals from the space of the offset to view space. With a hook for world space, p5 has two matrices. */
export function toView(normal: string, space: WarpSpace, { hooks }: Shader): string {
  const world = 'Vertex getWorldInputs'
  if (space === 'camera') return normal
  if (space === 'world') return `camera.uCameraNormalMatrix * ${normal}`
  return hooks.modified.vertex[world]
    ? `camera.uCameraNormalMatrix * (model.uModelNormalMatrix * ${normal})`
    : `model.uNormalMatrix * ${normal}`
}
