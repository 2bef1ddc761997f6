/** The uniforms of a warp: the addon's own, which carry the inputs that change per draw, and the sketch's from `defs`. */
import type { Shape, Variable } from '../compilation.js'
import { WarpError, describe } from '../errors.js'
import { type Canvas, type Shader, type Uniform, sketchOf } from './host.js'

/** Values by uniform name, as p5's `setUniform` takes them; a p5.Vector will do for a list of numbers. */
export type WarpUniforms = Record<string, unknown>

interface Input {
  uniform: string
  type: string
  read: (canvas: Canvas) => number | number[]
}

const inputs: Record<string, Input> = {
  millis: {
    uniform: 'uWarpjetMillis',
    type: 'float',
    read: (canvas) => sketchOf(canvas).millis(),
  },
  mouse: {
    uniform: 'uWarpjetMouse',
    type: 'vec2',
    read: (canvas) => [sketchOf(canvas).mouseX, sketchOf(canvas).mouseY],
  },
  size: {
    uniform: 'uWarpjetSize',
    type: 'vec2',
    read: (canvas) => [canvas.width, canvas.height],
  },
  pixelDensity: {
    uniform: 'uWarpjetPixelDensity',
    type: 'float',
    read: (canvas) => canvas.pixelDensity(),
  },
}

/** Input name → uniform name, for `compileWarp`. */
export const inputUniforms = Object.fromEntries(
  Object.entries(inputs).map(([name, { uniform }]) => [name, uniform]),
)

/** The inputs among the `uniforms` of a compiled warp, where the sketch's own parameters are too. */
const inputsAmong = (names: string[]) =>
  Object.keys(inputs).flatMap((name) => (names.includes(name) ? inputs[name]! : []))

export const uniformDeclarations = (names: string[]) =>
  inputsAmong(names)
    .map(({ type, uniform }) => `uniform ${type} ${uniform};`)
    .join('\n')

/** A parameter that neither p5 nor `defs` declares would break the shader, and p5 would print all of it. */
export function refuseUndeclared(parameters: readonly Variable[], shader: Shader, defs: string) {
  const declared = new Set(`${shader.vertSrc()} ${defs}`.match(/\w+/g))
  for (const { name, shape } of parameters) {
    if (/^(?!gl_)[A-Za-z_]\w*$/.test(name) && !declared.has(name))
      throw new WarpError(
        `createWarp: the warp reads "${name}", which nothing declares; add the option { defs: "uniform ${typeOf(shape)} ${name};" }.`,
      )
  }
}

const typeOf = ([columns, rows]: Shape) =>
  columns === 0 ? 'sampler2D' : columns > 1 ? `mat${columns}` : rows > 1 ? `vec${rows}` : 'float'

export function setInputs(shader: Shader, names: string[], canvas: Canvas) {
  for (const { uniform, read } of inputsAmong(names)) shader.setUniform(uniform, read(canvas))
}

/** Sets the sketch's own uniforms. One that `defs` declares but the warp never reads does not reach the shader. */
export function setUniforms(shader: Shader, uniforms: WarpUniforms, defs: string) {
  for (const [name, value] of Object.entries(uniforms)) {
    const uniform = shader.uniforms[name]
    if (uniform) shader.setUniform(name, readValue(name, value, uniform))
    else if (!defs.match(/\w+/g)?.includes(name))
      throw new WarpError(
        `The warp has no uniform "${name}"; createWarp's option "defs" must declare it: { defs: "uniform float ${name};" }.`,
      )
  }
}

const mat2 = 0x8b5a
const sampler2D = 0x8b5e

/** Of the matrices, by WebGL's number. */
const matrixSizes: Record<number, number> = { [mat2]: 4, 0x8b5b: 9, 0x8b5c: 16 }

function readValue(name: string, value: unknown, { type, isArray: isList = false }: Uniform) {
  if (type === mat2 && !isList)
    throw new WarpError(
      `The warp's uniform "${name}" is a mat2, which this p5 cannot set; declare a mat3, or use p5 2.`,
    )
  if (type === sampler2D) {
    // Images, graphics, framebuffers and videos have a width, as their textures do.
    if (typeof value === 'object' && value !== null && 'width' in value) return value
    throw new WarpError(
      `The warp's uniform "${name}" must be an image, such as one of loadImage or createGraphics, but is ${describe(value)}.`,
    )
  }
  const wrong =
    value === undefined || value === null || Number.isNaN(value) || typeof value === 'string'
  if (wrong || (isList && typeof value !== 'object'))
    throw new WarpError(
      `The warp's uniform "${name}" must be ${isList ? 'an array of numbers' : 'a number'}, but is ${describe(value)}.`,
    )
  const size = matrixSizes[type ?? 0]
  if (size && Array.isArray(value) && !(value.length === size && value.every(Number.isFinite)))
    throw new WarpError(
      `The warp's uniform "${name}" must be an array of ${size} numbers, column by column, but is ${describe(value)}.`,
    )
  return isList ? listOf(value as object) : value
}

/** p5 1.11 takes neither its own vectors nor its own colours as the value of a uniform. */
function listOf(value: object): unknown {
  if ('x' in value && 'y' in value && 'z' in value) return [value.x, value.y, value.z]
  return '_array' in value ? value._array : value
}
