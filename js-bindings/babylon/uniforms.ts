// The uniforms of a warp in shaders of Babylon.js: their names and types in the shader, and how their values are sent.
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import { shaderNames, type HostUniform, type HostWarp } from '../compile/hosts.js'

export interface ShaderParts {
  warp: HostWarp
  /** The names of the warp's frame constants, each a vec4 that the CPU computes once per frame. */
  frame: readonly string[]
}

/** A uniform as the shader declares it. */
export interface SentUniform {
  name: string
  type: string
}

/** A mat3 is sent as a mat4, since WGSL pads its columns. */
const sentType = (type: string) => (type === 'mat3' ? 'mat4' : type)

export const sentName = (label: string) => `${label}Sent`

/**
 * Returns all uniforms except images, and the frame constants. The warp's code reads them by label; the shader declares `sentName(label)`.
 */
const numericUniforms = ({ warp, frame }: ShaderParts): Pick<HostUniform, 'label' | 'type'>[] => [
  ...warp.uniforms.inShader.filter(({ image }) => !image),
  ...frame.map((label) => ({ label, type: 'vec4' as const })),
]

/** The uniform of both stages that is -1 if the warp mirrors all of space, and otherwise 1. */
export const orientationUniform: SentUniform = { name: shaderNames.orientation, type: 'float' }

/** Returns the uniforms that the shader declares, except images. */
export const sentUniforms = (parts: ShaderParts): SentUniform[] => [
  { name: shaderNames.millis, type: 'float' },
  ...numericUniforms(parts).map(({ label, type }) => ({
    name: sentName(label),
    type: sentType(type),
  })),
]

/** Sends the current values of all uniforms except images. */
export function sendUniforms(
  { warp }: ShaderParts,
  inputs: { millis: number },
  setter: NumberSetter,
) {
  setter.updateFloat(shaderNames.millis, inputs.millis)
  for (const { label, numbers, image } of warp.uniforms.inShader)
    if (!image) sendNumbers(setter, label, numbers())
  for (const [label, numbers] of Object.entries(warp.frame(inputs)))
    sendNumbers(setter, label, numbers)
}

/** Sets uniforms by name. A UniformBuffer of Babylon.js is one; passes.ts makes others, for effects without a buffer. */
export interface NumberSetter {
  updateFloat(name: string, x: number): unknown
  updateFloat2(name: string, x: number, y: number): unknown
  updateFloat3(name: string, x: number, y: number, z: number): unknown
  updateFloat4(name: string, x: number, y: number, z: number, w: number): unknown
  updateMatrices(name: string, numbers: Float32Array): unknown
}

function sendNumbers(setter: NumberSetter, label: string, numbers: readonly number[]) {
  const name = sentName(label)
  const [x, y, z, w] = numbers as [number, number, number, number]
  if (numbers.length === 1) setter.updateFloat(name, x)
  else if (numbers.length === 2) setter.updateFloat2(name, x, y)
  else if (numbers.length === 3) setter.updateFloat3(name, x, y, z)
  else if (numbers.length === 4) setter.updateFloat4(name, x, y, z, w)
  else
    setter.updateMatrices(
      name,
      Float32Array.from(numbers.length === 9 ? withFourthRow(numbers) : numbers),
    )
}

const withFourthRow = (n: readonly number[]) => [
  ...[...n.slice(0, 3), 0, ...n.slice(3, 6), 0, ...n.slice(6), 0],
  ...[0, 0, 0, 1],
]

/** Declares local variables with the names and types that the uniforms have in the warp's code. */
export const localUniforms = (parts: ShaderParts, isWGSL: boolean) =>
  numericUniforms(parts).map((uniform) => localUniform(uniform, isWGSL))

function localUniform({ label, type }: Pick<HostUniform, 'label' | 'type'>, isWGSL: boolean) {
  const sent = isWGSL ? `uniforms.${sentName(label)}` : sentName(label)
  const isMat3 = type === 'mat3'
  if (!isWGSL) return `${type} ${label} = ${isMat3 ? `mat3(${sent})` : sent};`
  const columns = [0, 1, 2].map((i) => `${sent}[${i}].xyz`)
  return `let ${label} = ${isMat3 ? `mat3x3f(${columns.join(', ')})` : sent};`
}

const wgslTypes: Record<string, string> = {
  float: 'f32',
  vec2: 'vec2f',
  vec3: 'vec3f',
  vec4: 'vec4f',
  mat4: 'mat4x4f',
}

export const declareUniform = ({ name, type }: SentUniform, isWGSL: boolean) =>
  isWGSL ? `uniform ${name}: ${wgslTypes[type]};` : `uniform ${type} ${name};`

export const declareAttribute = (name: string, size: 2 | 3 | 4, isWGSL: boolean) =>
  isWGSL ? `attribute ${name}: vec${size}f;` : `attribute vec${size} ${name};`

/** Returns the current images of a warp, with their names in the shader. */
export const texturesOf = ({ warp }: ShaderParts) =>
  warp.uniforms.inShader.flatMap(({ label, image }): [string, BaseTexture][] =>
    image ? [[label, image() as BaseTexture]] : [],
  )

/** Declares the images of a warp. */
export const declareImages = ({ warp }: ShaderParts, isWGSL: boolean) =>
  warp.uniforms.inShader
    .filter(({ image }) => image)
    .map(({ label }) => declareImage(label, isWGSL))

const declareImage = (label: string, isWGSL: boolean) =>
  isWGSL
    ? `var ${label}Sampler: sampler;\nvar ${label}: texture_2d<f32>;`
    : `uniform highp sampler2D ${label};`
