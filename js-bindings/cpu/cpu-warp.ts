// A warp on the CPU: the same graph that became shader text, on the vertices of a mesh.
import { WarpError } from '../checks/errors.js'
import { type Stream, boundProgram, inputsRead, runProgram } from '../wasm/evaluation.js'
import { type VertexInput, variationInputs, vertexInputs } from '../inputs/inputs.js'
import type { Program } from '../module/kept-module.js'
import { noteApproximation } from '../checks/notes.js'
import { readNumbers } from '../checks/numbers.js'
import { checkOptions } from '../checks/options.js'
import type { Variable } from '../expression/shapes.js'
import { withDeclared } from '../inputs/declared-uniforms.js'
import {
  type Box,
  type Range,
  type Uniforms,
  type Vertices,
  arrayNames,
  checkUniforms,
  checkVertices,
  readRanges,
  uniformsOf,
} from '../inputs/vertices.js'
import { type WarpProgram, warpProgram } from './warp-program.js'

/** Flat arrays in the order of the vertices that came. */
export interface WarpedVertices {
  /** Three numbers a vertex. */
  positions: Float32Array
  /** Three numbers a vertex, of length 1, or 0 where the warp collapses the surface; if normals came. */
  normals?: Float32Array
  /** Four numbers a vertex, the last one as it came; if normals and tangents came. */
  tangents?: Float32Array
}

export interface EvaluationOptions {
  /** Those left out have the values of `compileWarp`'s option `uniforms`; a function there is called each time. */
  uniforms?: Uniforms | undefined
}

/** What the warp is to know of one vertex; the numbers of each as in `Vertices`. */
export interface PointInputs
  extends Partial<Record<Exclude<VertexInput, 'position'>, ArrayLike<number>>>, EvaluationOptions {}

export interface WarpedPoint {
  position: number[]
  /** If a normal came. */
  normal?: number[]
  /** If a normal and a tangent came. */
  tangent?: number[]
}

export interface Foldover {
  /** 1 for each vertex where det(I + J) is not above 0, so that space is inside out there, or no number; 0 elsewhere. If
   * the offset depends on normal or uv, space is the thin layer around the surface where these stay the same along each
   * normal: its two sides have changed places there. */
  mask: Uint8Array
  /** How many those are. */
  count: number
}

/**
 * All throw a `WarpError` for arrays that do not fit, numbers that are not finite, a uniform or an attribute that the warp
 * reads and does not get, a uniform that it does not know, and a warp that calls a `glsl.fn` or `glsl.texture`, which only the GPU can run.
 * They compute in float32, as the GPU does, and change nothing that comes in. Where the offset function has no finite
 * value, such as the logarithm of a negative number, neither have the results.
 */
export interface CpuWarp {
  /** Moves vertices, any number, even none: it needs the results' memory and a few megabytes. */
  evaluate(mesh: Vertices, options?: EvaluationOptions): WarpedVertices
  /** Moves one vertex. */
  evaluateAt(position: ArrayLike<number>, inputs?: PointInputs): WarpedPoint
  /**
   * A box around all that the warp makes of `box`: never too small for what `evaluate` gives, and seldom much larger than
   * that. A GPU whose sine is less exact, as WebGPU allows to 2^-11, may go beyond by that part of a wave's height. It takes
   * from a tenth of a millisecond to some tens, for warps that are hard to bound. Where the offset depends on them, normals count as any numbers from -1 to 1, colors from 0 to 1, and texture coordinates from 0 to 1
   * unless `box.uvs` says otherwise. A side is infinite if the offset may be.
   */
  bounds(box: Box, options?: EvaluationOptions): { min: number[]; max: number[] }
  /** Where the warp turns the surface inside out. */
  foldover(mesh: Vertices, options?: EvaluationOptions): Foldover
  /** @internal */
  readonly [warpProgram]: WarpProgram
}

/** The results of the program, by number, as compile-warp.ts asks for them; a warp without normals has only the first three. */
const numbersOf = {
  positions: [0, 1, 2],
  normals: [3, 4, 5],
  tangents: [6, 7, 8, 9],
  determinant: [10],
}

type Result = keyof typeof numbersOf

export function createCpuWarp(warp: WarpProgram): CpuWarp {
  function run<Name extends Result>(
    method: string,
    mesh: Vertices,
    uniforms: Uniforms | undefined,
    wanted: readonly Name[],
  ): Record<Name, Float32Array> {
    const program = programOf(method, warp)
    const vertices = checkVertices(method, mesh)
    const numbers = wanted.flatMap((name) => numbersOf[name])
    const streams = originsOf(method, warp, program, numbers, uniforms).map((origin): Stream => {
      const { input, isRead, values: shared } = origin
      const common = { values: shared, size: shared.length, isUniform: true }
      if (!input || !isRead) return common
      const values = mesh[arrayNames[input]]
      if (values) return { values, size: vertexInputs[input], isUniform: false }
      if (input in variationInputs) {
        if (!warp.isAccepted) noteApproximation(method, 'surfaceVariation(mesh) of warpjet/mesh')
        return common
      }
      const name = method === 'evaluateAt' ? input : arrayNames[input]
      throw new WarpError(
        `${method}: the warp reads the ${input} of each vertex, but no "${name}" came.`,
      )
    })
    const sinks = wanted.map((name) => ({
      values: new Float32Array(vertices * numbersOf[name].length),
      results: numbersOf[name],
    }))
    if (vertices > 0) runProgram(program, vertices, streams, sinks)
    return Object.fromEntries(wanted.map((name, i) => [name, sinks[i]!.values])) as never
  }

  function turned(mesh: Vertices): Result[] {
    if (!warp.hasNormals || !mesh?.normals) return ['positions']
    return mesh.tangents ? ['positions', 'normals', 'tangents'] : ['positions', 'normals']
  }

  return {
    [warpProgram]: warp,

    evaluate: (mesh, options) =>
      run('evaluate', mesh, uniformsOf('evaluate', options), turned(mesh)),

    evaluateAt(position, inputs = {}) {
      const known = Object.keys(vertexInputs).filter((name) => name !== 'position')
      checkOptions('evaluateAt', inputs ?? null, [...known, 'uniforms'])
      readNumbers('evaluateAt: the position', position, 3)
      const mesh: Record<string, number[]> = {}
      for (const [name, value] of Object.entries({ ...inputs, position }))
        if (name in vertexInputs && value !== undefined)
          mesh[arrayNames[name as VertexInput]] = readNumbers(
            `evaluateAt: the ${name}`,
            value,
            vertexInputs[name as VertexInput],
          )
      const vertex = mesh as unknown as Vertices
      const { positions, normals, tangents } = run(
        'evaluateAt',
        vertex,
        inputs.uniforms,
        turned(vertex),
      ) as WarpedVertices
      return {
        position: [...positions],
        ...(normals && { normal: [...normals] }),
        ...(tangents && { tangent: [...tangents] }),
      }
    },

    bounds(box, options) {
      const uniforms = uniformsOf('bounds', options)
      const program = programOf('bounds', warp)
      const ranges: Partial<Record<VertexInput, Range[]>> = {
        position: readRanges('bounds', 'box', box, 3),
        normal: Array<Range>(3).fill([-1, 1]),
        uv: box.uvs ? readRanges('bounds', 'box.uvs', box.uvs, 2) : Array<Range>(2).fill([0, 1]),
        color: Array<Range>(4).fill([0, 1]),
      }
      const given = originsOf('bounds', warp, program, numbersOf.positions, uniforms).flatMap(
        ({ input, values }) =>
          // What turns the normal does not move the vertex.
          (input && ranges[input]) ?? values.map((x): Range => [x, x]),
      )
      const found = boundProgram(program, given, numbersOf.positions)
      return { min: found.map(([low]) => low), max: found.map(([, high]) => high) }
    },

    foldover(mesh, options) {
      const uniforms = uniformsOf('foldover', options)
      if (!warp.hasNormals)
        throw new WarpError(
          'foldover: the warp was compiled with "normals: false", which leaves out its derivatives; compile it without.',
        )
      const { determinant } = run('foldover', mesh, uniforms, ['determinant'])
      const mask = Uint8Array.from(determinant, (value) => Number(!(value > 0)))
      return { mask, count: mask.reduce((sum, folded) => sum + folded, 0) }
    },
  }
}

function programOf(method: string, warp: WarpProgram): Program {
  const program = warp.program()
  if (program) return program
  throw new WarpError(
    `${method}: this warp calls a function of glsl.fn or reads an image by glsl.texture, which only the GPU can do.`,
  )
}

/** Where a program's input comes from. */
interface Origin {
  /** If it differs by vertex, which it is. */
  input?: VertexInput
  /** Whether the results depend on it. */
  isRead: boolean
  /** The numbers that all vertices share; zeros if it differs by vertex, or is not read and may be missing. */
  values: number[]
}

/** The program's inputs in order, the uniforms checked. */
function originsOf(
  method: string,
  { declared, inputs }: WarpProgram,
  program: Program,
  wanted: readonly number[],
  given: Uniforms | undefined,
): Origin[] {
  // The first of two inputs that are one.
  const names = new Map(
    Object.entries(inputs)
      .reverse()
      .map(([input, number]) => [number, input]),
  )
  const nameOf = (variable: Variable) => names.get(variable.number)
  const parameters = program.inputs.filter((variable) => !nameOf(variable))
  checkUniforms(method, given, [...declared.keys(), ...parameters.map(({ name }) => name)])
  const uniforms = withDeclared(method, declared, given, parameters)
  const read = inputsRead(program, wanted)
  return program.inputs.map((variable, i) => {
    const isRead = read[i]!
    const size = variable.shape[0] * variable.shape[1]
    const values = Array<number>(size).fill(0)
    const name = nameOf(variable) ?? variable.name
    if (nameOf(variable) && name in vertexInputs)
      return { input: name as VertexInput, isRead, values }
    const value = uniforms[name]
    if (value !== undefined)
      return { isRead, values: readNumbers(`${method}: the uniform "${name}"`, value, size) }
    if (!isRead) return { isRead, values }
    throw new WarpError(
      `${method}: the warp reads "${name}"; give it a value in the uniforms, as in { ${JSON.stringify(name)}: ${size === 1 ? 0 : `[${values}]`} }.`,
    )
  })
}
