// What goes into the vertex shaders of Babylon.js, which have the same names for a vertex in GLSL and in WGSL.
import { millisUniform, orientationName, outputs } from '../compile/host-names.js'
import { type KeptWarp, writeWarp } from '../compile/warp-text.js'
import { type Shape, imageShape, typeOf } from '../core/expression/shapes.js'
import type { Target } from '../core/module/kept-module.js'

/** One that the offset reads, as the shader calls it. */
export interface Labelled {
  label: string
  shape: Shape
}

/** What the buffer of uniforms has: matrices of 3 are 4 by 4 there, since WGSL lays them out with gaps. */
const sent = (shape: Shape) => (typeOf(shape) === 'mat3' ? 'mat4' : (typeOf(shape) as string))

const sizes: Record<string, number> = { float: 1, vec2: 2, vec3: 3, vec4: 4, mat4: 16 }

const sentName = (label: string) => `${label}Sent`

/** The uniforms for a plugin's `getUniforms`. If the warp may mirror all of space (`mirrors`), one of them says so to both stages. */
export function declarationsOf(uniforms: readonly Labelled[], isWGSL: boolean, mirrors: boolean) {
  const orientation = { name: orientationName, type: 'float' }
  const numbers = [
    { name: millisUniform, type: 'float' },
    ...(mirrors ? [orientation] : []),
    ...uniforms
      .filter(({ shape }) => shape !== imageShape)
      .map(({ label, shape }) => ({ name: sentName(label), type: sent(shape) })),
  ]
  return {
    ubo: numbers.map(({ name, type }) => ({ name, type, size: sizes[type]! })),
    // Where there are no buffers of uniforms.
    ...(!isWGSL && {
      vertex: numbers.map(declare).join(''),
      ...(mirrors && { fragment: declare(orientation) }),
    }),
  }
}

const declare = ({ name, type }: { name: string; type: string }) => `uniform ${type} ${name};\n`

/** What is used of the buffer of uniforms. */
interface Buffer {
  updateFloat(name: string, x: number): void
  updateFloat2(name: string, x: number, y: number): void
  updateFloat3(name: string, x: number, y: number, z: number): void
  updateFloat4(name: string, x: number, y: number, z: number, w: number): void
  updateMatrices(name: string, numbers: Float32Array): void
}

export function send(buffer: Buffer, label: string, numbers: number[]) {
  const name = sentName(label)
  const [x, y, z, w] = numbers as [number, number, number, number]
  if (numbers.length === 1) buffer.updateFloat(name, x)
  else if (numbers.length === 2) buffer.updateFloat2(name, x, y)
  else if (numbers.length === 3) buffer.updateFloat3(name, x, y, z)
  else if (numbers.length === 4) buffer.updateFloat4(name, x, y, z, w)
  else
    buffer.updateMatrices(
      name,
      Float32Array.from(numbers.length === 9 ? widened(numbers) : numbers),
    )
}

const widened = (n: number[]) => [
  ...[...n.slice(0, 3), 0, ...n.slice(3, 6), 0, ...n.slice(6), 0],
  ...[0, 0, 0, 1],
]

/**
 * The fragment code for a plugin's `getCustomCode`. If the warp mirrors all of space, the outer side of a triangle is the one
 * that the engine takes for the back. Babylon.js reads names that begin with `!` as regular expressions.
 */
export const fragmentCode = (isWGSL: boolean): Record<string, string> =>
  isWGSL
    ? {
        '!fragmentInputs\\.frontFacing': `(fragmentInputs.frontFacing == (uniforms.${orientationName} > 0.0))`,
      }
    : { '!\\bgl_FrontFacing\\b': `(gl_FrontFacing == (${orientationName} > 0.0))` }

/** For a plugin's `getCustomCode`. */
export function vertexCode(warp: KeptWarp, uniforms: readonly Labelled[], isWGSL: boolean) {
  const target: Target = isWGSL ? 'wgsl' : 'glsl300'
  const names = isWGSL ? { millis: `uniforms.${millisUniform}` } : {}
  const texts = [
    { normals: true, tangents: true },
    { normals: true, tangents: false },
    { normals: false, tangents: false },
  ].map((turned) => {
    const settings = { ...warp.settings, ...turned }
    return writeWarp({ ...warp, settings }, target, { names }).text
  })
  const readsColor = texts[0]!.attributes.some(({ name }) => name === 'color')
  const images = uniforms.filter(({ shape }) => shape === imageShape)
  const whereOn = (text: string) => `#ifdef WARPJET\n${text}\n#endif`
  return {
    CUSTOM_VERTEX_DEFINITIONS: [
      ...images.map(({ label }) =>
        isWGSL
          ? `var ${label}Sampler: sampler;\nvar ${label}: texture_2d<f32>;`
          : `uniform highp sampler2D ${label};`,
      ),
      whereOn(chosen(texts.map(({ declarations }) => declarations))),
    ].join('\n'),
    CUSTOM_VERTEX_UPDATE_NORMAL: whereOn(
      [
        '{',
        ...uniforms.filter(({ shape }) => shape !== imageShape).map((each) => local(each, isWGSL)),
        readsColor ? colorOfVertex[target] : '',
        missing('UV1', 'uvUpdated', 2, isWGSL),
        missing('NORMAL', 'normalUpdated', 3, isWGSL),
        chosen(texts.map(({ code }, i) => `${code}\n${results[i]}`)),
        '}',
      ].join('\n'),
    ),
  }
}

/** What a mesh may lack counts as 0. */
function missing(define: string, name: string, size: number, isWGSL: boolean) {
  const zero = isWGSL ? `let ${name} = vec${size}f(0.0);` : `vec${size} ${name} = vec${size}(0.0);`
  return `#ifndef ${define}\n${zero}\n#endif`
}

/** A uniform under the name that the text has for it. */
function local({ label, shape }: Labelled, isWGSL: boolean) {
  const type = typeOf(shape) as string
  const given = isWGSL ? `uniforms.${sentName(label)}` : sentName(label)
  const isNarrow = type === 'mat3'
  if (!isWGSL) return `${type} ${label} = ${isNarrow ? `mat3(${given})` : given};`
  const columns = [0, 1, 2].map((i) => `${given}[${i}].xyz`)
  return `let ${label} = ${isNarrow ? `mat3x3f(${columns.join(', ')})` : given};`
}

const colorOfVertex: Partial<Record<Target, string>> = {
  glsl300: `#ifdef VERTEXCOLOR
vec4 warpjetColor = colorUpdated;
#else
vec4 warpjetColor = vec4(1.0);
#endif`,
  wgsl: `#ifdef VERTEXCOLOR
let warpjetColor = colorUpdated;
#else
let warpjetColor = vec4f(1.0);
#endif`,
}

/** What the offset's inputs are called. */
export const names = {
  position: 'positionUpdated',
  normal: 'normalUpdated',
  uv: 'uvUpdated',
  color: 'warpjetColor',
  tangent: 'tangentUpdated',
  millis: millisUniform,
}

const moved = `positionUpdated = ${outputs.position};`
const turned = `normalUpdated = ${outputs.normal};`
const results = [
  `${moved} ${turned} tangentUpdated = ${outputs.tangent};`,
  `${moved} ${turned}`,
  moved,
]

/** By what the mesh has. */
const chosen = ([tangent, normal, position]: string[]) =>
  `#ifdef NORMAL\n#ifdef TANGENT\n${tangent}\n#else\n${normal}\n#endif\n#else\n${position}\n#endif`
