/** Normals at each pixel on WebGPU; see pixel-code.ts. Varyings are globals of both stages. */
import type { Declared } from '../../compile/hosts.js'
import type { Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { normalVarying, normalWithLength, varyingOfInput } from './pixel-code.js'
import type { PixelCode } from './styles.js'

/** WGSL types of inputs and of the option `uniforms`. */
export const wgslTypes: Partial<Record<Declared['type'], string>> = {
  float: 'f32',
  vec2: 'vec2<f32>',
  vec3: 'vec3<f32>',
  vec4: 'vec4<f32>',
  mat2: 'mat2x2<f32>',
  mat3: 'mat3x3<f32>',
  mat4: 'mat4x4<f32>',
  sampler2D: 'texture_2d<f32>',
}

export const pixelVaryings = (pixel: PixelCode | undefined) =>
  pixel?.varyings.map(({ name, type }) => `${name}: ${wgslTypes[type]}`) ?? []

/**
 * Returns statements that define the inputs of the code: they restore the length of the normal, which interpolation shortens, and round
 * the number of the instance, which interpolation makes inexact.
 */
export function readInputs({ varyings }: PixelCode): string {
  const names = new Set(varyings.map(({ name }) => name))
  const [normal, instance] = ['normal', 'instance'].map(varyingOfInput)
  return [
    names.has(normalVarying) && `  let ${normal} = ${normalWithLength};\n`,
    names.has(instance!) && `  let ${instance} = round(${instance});\n`,
  ]
    .filter(Boolean)
    .join('')
}

/**
 * Returns an expression for a normal in view space, from a normal in the space of the offset. With a hook for world space, p5 has two
 * matrices.
 */
export function toView(normal: string, space: WarpSpace, { hooks }: Shader): string {
  const world = 'Vertex getWorldInputs'
  if (space === 'camera') return normal
  if (space === 'world') return `camera.uCameraNormalMatrix * ${normal}`
  return hooks.modified.vertex[world]
    ? `camera.uCameraNormalMatrix * (model.uModelNormalMatrix * ${normal})`
    : `model.uNormalMatrix * ${normal}`
}
