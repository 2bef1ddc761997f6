/**
 * The code that computes a warp's normal at each pixel. The vertex stage passes the inputs of the warp, in the space of the offset, as
 * varyings; the fragment stage runs the same warp on their interpolated values, but computes only the normal.
 */
import {
  restoreLength,
  variationNames,
  withLength,
  type HostWarp,
  type Target,
} from '../../compile/hosts.js'
import type { Shader } from '../host.js'
import { inputUniforms } from '../sketch-uniforms.js'
import type { PixelCode, Varying } from './styles.js'

/** Returns the fragment stage's name of an input. */
export const varyingOfInput = (input: string) => `warpjetPixel_${input}`

/**
 * The names of inputs in the code. Inputs that differ by vertex or instance are varyings, except the normal, which is computed from a
 * varying; the others are uniforms.
 */
const names = {
  ...Object.fromEntries(
    ['position', 'normal', 'uv', 'color', 'instance', ...variationNames].map((input) => [
      input,
      varyingOfInput(input),
    ]),
  ),
  ...inputUniforms,
}

/** The varying for the normal and its length. Interpolation shortens the normal, so its length is interpolated separately. */
export const normalVarying = 'warpjetPixel_normalAndLength'

/** The expression for the normal with the length that it has at vertices. */
export const normalWithLength = restoreLength(normalVarying)

/**
 * Returns statements of the vertex stage that pass the inputs of the warp to pixels. `expressions` maps an input → its expression in the
 * vertex shader. `vec4` is the language's name of that type.
 */
export const passInputs = (
  pixel: PixelCode | undefined,
  expressions: Readonly<Record<string, string>>,
  vec4: string,
): string =>
  pixel?.varyings
    .map(({ input, name }) => {
      const value = expressions[input]!
      return `  ${name} = ${input === 'normal' ? withLength(value, vec4) : value};\n`
    })
    .join('') ?? ''

/** Writes the code of the fragment stage, without the uniforms that it declares. */
export function pixelTextOf(warp: HostWarp, target: Target) {
  const text = warp.fragmentText(target, ['normal'], { names })
  const inputs = [...text.attributes, ...text.uniforms.filter(({ name }) => name === 'instance')]
  const varyings = inputs.map(({ name, type }): Varying =>
    name === 'normal'
      ? { input: name, name: normalVarying, type: 'vec4' }
      : { input: name, name: varyingOfInput(name), type: type as Varying['type'] },
  )
  return { text, varyings }
}

/** Returns the names of variables that only the vertex stage has: the attributes that the shader declares, and built-in variables. */
function variablesOfVertices(base: Shader): string[] {
  const declared = base.vertSrc().matchAll(/^\s*(?:IN|in|attribute)\s+(?:\w+\s+)+(\w+)\s*;/gm)
  return [
    ...Array.from(declared, ([, name]) => name!),
    'gl_Position',
    'gl_VertexID',
    'gl_InstanceID',
  ]
}

/** Returns why the shader cannot run the code at each pixel; `undefined` if it can. */
export function obstacleFor(
  { text, uniforms, varyings }: PixelCode,
  base: Shader,
  {
    defs,
    isAfter,
    maxVaryings,
  }: { defs: string; isAfter: (hook: string) => boolean; maxVaryings: number },
): string | undefined {
  const { vertex, modified } = base.hooks
  const later = Object.keys(vertex).find(
    (name) => modified.vertex[name] && isAfter(name) && /normal/i.test(name + vertex[name]!),
  )
  if (later) return `the hook ${later.split(' ')[1]} of its shader changes normals after the warp`
  const vertexVariable = variablesOfVertices(base).find((name) =>
    new RegExp(`\\b${name}\\b`).test(defs),
  )
  if (vertexVariable) return `"defs" reads ${vertexVariable}, which only vertices have`
  const known = new Set(`${base.fragSrc()} ${defs}`.match(/\w+/g))
  for (const { name } of uniforms) known.add(name)
  const missing = text.parameters.find(({ name }) => !known.has(name))
  if (missing) return `its fragment shader does not declare ${missing.name}`
  if (varyings.length > maxVaryings)
    return `it passes ${varyings.length} values to pixels, of which this browser has ${maxVaryings} left`
  return undefined
}
