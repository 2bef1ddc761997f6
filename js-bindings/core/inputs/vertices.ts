// What a warp on the CPU is handed: arrays of vertices, uniforms, a box. Checked here, all in one sentence each.
import { WarpError, describe } from '../../errors/errors.js'
import { type VertexInput, drawInputs, vertexInputs } from './inputs.js'
import { finiteFloat, firstWrong, inWords, readNumbers } from '../../options/numbers.js'
import { checkOptions, isList } from '../../options/options.js'

/** Flat arrays, so many numbers a vertex. */
export interface Vertices {
  /** Three. */
  positions: ArrayLike<number>
  /** Three, usually of length 1. */
  normals?: ArrayLike<number>
  /** Two. */
  uvs?: ArrayLike<number>
  /** Four, red, green, blue and alpha from 0 to 1. */
  colors?: ArrayLike<number>
  /** Four, as in glTF: a direction, and 1 or -1 for the side of the bitangent. */
  tangents?: ArrayLike<number>
  /** Three each: how normals and uvs vary over the surface, as `surfaceVariation` of 'warpjet/mesh' gives it. An offset that
   * depends on them needs it for right normals; what is missing counts as 0. */
  normalXGradients?: ArrayLike<number>
  normalYGradients?: ArrayLike<number>
  normalZGradients?: ArrayLike<number>
  uGradients?: ArrayLike<number>
  vGradients?: ArrayLike<number>
}

/** By name: a number, or the numbers of a vector or, column by column, of a matrix. */
export type Uniforms = Readonly<Record<string, number | ArrayLike<number>>>

export interface Box {
  /** The least x, y and z. */
  min: ArrayLike<number>
  max: ArrayLike<number>
  /** The range of texture coordinates, if they are not from 0 to 1. */
  uvs?: { min: ArrayLike<number>; max: ArrayLike<number> }
}

/** The arrays of a mesh, by what the offset function calls them. */
export const arrayNames: Record<VertexInput, keyof Vertices> = {
  position: 'positions',
  normal: 'normals',
  uv: 'uvs',
  color: 'colors',
  tangent: 'tangents',
  normalXGradient: 'normalXGradients',
  normalYGradient: 'normalYGradients',
  normalZGradient: 'normalZGradients',
  uGradient: 'uGradients',
  vGradient: 'vGradients',
}

const sizes = Object.entries(arrayNames).map(([input, name]) => ({
  name,
  size: vertexInputs[input as VertexInput],
}))

/** Arrays that held finite numbers when they were checked, or that a warp wrote; others of the same kind can get longer. */
const checked = new WeakSet<Float32Array>()

/** What a warp has written is not checked when it comes back. */
export const noteChecked = (numbers: Float32Array) => void checked.add(numbers)

/** Lets `evaluate` accept numbers that are not finite, for hosts that draw such vertices all the same. Copies their arrays. */
export function allowNonFinite(mesh: Vertices): Vertices {
  const arrays = Object.entries(mesh).map(([name, numbers]: [string, ArrayLike<number>]) => {
    const isFinite = numbers instanceof Float32Array && checked.has(numbers)
    if (isFinite || firstWrong(numbers, finiteFloat) < 0) return [name, numbers] as const
    const copy = Float32Array.from(numbers)
    noteChecked(copy)
    return [name, copy] as const
  })
  return Object.fromEntries(arrays) as unknown as Vertices
}

/** How many vertices there are; throws for arrays that do not fit, or hold something else than finite
 * numbers when they come for the first time. */
export function checkVertices(method: string, mesh: unknown): number {
  if (typeof mesh !== 'object' || mesh === null || !('positions' in mesh))
    throw new WarpError(
      `${method}: a mesh with an array of positions was expected, but ${describe(mesh)} came.`,
    )
  if ('uniforms' in mesh)
    throw new WarpError(
      `${method}: uniforms stand beside the mesh, not in it, as in ${method}(mesh, { uniforms: { millis: 1200 } }).`,
    )
  const arrays = mesh as Record<string, unknown>
  let vertices = 0
  for (const { name, size } of sizes) {
    const numbers = arrays[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers))
      throw new WarpError(
        `${method}: ${name} must be a flat array of ${size} numbers a vertex, but is ${describe(numbers)}.`,
      )
    if (name === 'positions' && numbers.length % 3 !== 0)
      throw new WarpError(
        `${method}: positions must have three numbers a vertex, but has ${numbers.length} numbers.`,
      )
    if (name === 'positions') vertices = numbers.length / 3
    if (numbers.length !== vertices * size)
      throw new WarpError(
        `${method}: ${name} must have ${size} numbers a vertex, ${vertices * size} for these positions, but has ${numbers.length}.`,
      )
    const isFloats = numbers instanceof Float32Array
    if (isFloats && checked.has(numbers)) continue
    const wrong = firstWrong(numbers, finiteFloat)
    if (wrong >= 0)
      throw new WarpError(
        `${method}: ${name}[${wrong}], of vertex ${Math.floor(wrong / size)}, must be a finite number, but is ${inWords(numbers[wrong])}.`,
      )
    if (isFloats) noteChecked(numbers)
  }
  return vertices
}

/** Of options that hold nothing else than what is `known`. */
export function uniformsOf(
  method: string,
  options: unknown,
  known: readonly string[] = ['uniforms'],
): Uniforms | undefined {
  if (typeof options === 'object' && options !== null && !isList(options)) {
    for (const name in options)
      if (Object.hasOwn(options, name) && !known.includes(name))
        throw new WarpError(
          `${method}: there is no option "${name}"; if it is a uniform, write { uniforms: { ${name}: … } }.`,
        )
  } else checkOptions(method, options, known)
  return (options as { uniforms?: Uniforms } | undefined)?.uniforms
}

/** Refuses a uniform that is none of the inputs of a draw call and no parameter of the warp. */
export function checkUniforms(method: string, uniforms: unknown, parameters: ReadonlySet<string>) {
  if (uniforms === undefined) return
  if (typeof uniforms !== 'object' || uniforms === null || isList(uniforms))
    throw new WarpError(
      `${method}: uniforms must be an object, such as { millis: 1200 }, but is ${describe(uniforms)}.`,
    )
  for (const name in uniforms) {
    if (Object.hasOwn(drawInputs, name) || parameters.has(name)) continue
    if (!Object.hasOwn(uniforms, name)) continue
    const known = new Set([...Object.keys(drawInputs), ...parameters])
    throw new WarpError(
      `${method}: the warp has no uniform "${name}"; there are ${[...known].join(', ')}.`,
    )
  }
}

export type Range = readonly [low: number, high: number]

/** The range of each coordinate of a box. */
export function readRanges(method: string, name: string, box: unknown, count: number): Range[] {
  if (typeof box !== 'object' || box === null)
    throw new WarpError(
      `${method}: ${name} must be { min, max }, each of ${count} numbers, but is ${describe(box)}.`,
    )
  const { min, max } = box as Box
  const low = readNumbers(`${method}: ${name}.min`, min, count)
  const high = readNumbers(`${method}: ${name}.max`, max, count)
  return low.map((least, i) => {
    if (least <= high[i]!) return [least, high[i]!]
    throw new WarpError(
      `${method}: ${name}.min[${i}] is ${least}, above ${name}.max[${i}], which is ${high[i]}.`,
    )
  })
}
