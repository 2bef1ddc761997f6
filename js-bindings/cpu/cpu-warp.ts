// A warp on the CPU: the same graph that became shader text, on the vertices of a mesh.
import { WarpError } from '../errors/errors.js'
import { boundProgram, inputsRead } from '../wasm/evaluation.js'
import type { Sink } from '../wasm/machine-code.js'
import { runProgram } from '../wasm/run-program.js'
import { type VertexInput, variationInputs, vertexInputs } from '../core/inputs/inputs.js'
import type { Program } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { noteApproximation } from '../errors/notes.js'
import { runInDouble } from './double.js'
import { type Moved, type Triple, inverse } from './inverse.js'
import { readNumbers } from '../options/numbers.js'
import { checkOptions } from '../options/options.js'
import {
  type Box,
  type Range,
  type Uniforms,
  type Vertices,
  arrayNames,
  checkVertices,
  readRanges,
  uniformsOf,
} from '../core/inputs/vertices.js'
import { type Origin, keep, originsOf, readingOf } from './origins.js'
import { copyOverwritten } from './overlaps.js'
import { type WarpedVertices, leaveSinks, numbersOf, takeSinks, wanted } from './results.js'
import { type RunningProgram, type WarpProgram, warpProgram } from './warp-program.js'

export interface EvaluationOptions {
  /** Those left out have the values of `compileWarp`'s option `uniforms`; a function there is called each time. */
  uniforms?: Uniforms | undefined
}

export interface EvaluateOptions extends EvaluationOptions {
  /**
   * Arrays of yours that receive the results. Each must be at least as long as its result; missing ones are created. The same
   * arrays are returned, in this object if it holds no others. They may be inputs or share memory with inputs, but two results
   * that share memory throw a `WarpError`. Calls that reuse the arrays create no garbage, unless a uniform's function does, or a
   * result would overwrite an input that has yet to be read, which is copied first.
   */
  out?: Partial<WarpedVertices> | undefined
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

export interface InverseOptions
  extends Partial<Record<'normal' | 'uv' | 'color', ArrayLike<number>>>, EvaluationOptions {
  /** Where the search starts; the point itself unless given. Give where the point came from a moment ago. */
  near?: ArrayLike<number> | undefined
}

export interface WarpInverse {
  /** The place that the warp brings the point from: if there are several, the one that the way from `near` leads to. */
  position: number[]
  /** Whether space is inside out there, det(I + J) not above 0. Then other places come to the point too, which are found from
   * another `near`, unless the warp mirrors all of space or the point lies just on a crease. Where it is false others may
   * come there as well: of three layers of a fold only the one in the middle is inside out. */
  isFolded: boolean
}

/** Bounds of x, y and z, without NaN. `min` is above `max` for a coordinate that is NaN everywhere. */
export interface Bounds {
  min: number[]
  max: number[]
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
  /**
   * Moves vertices, any number, even none: it needs the results' memory, unless `out` has it, and a few megabytes. Numbers of
   * a Float32Array are checked when it comes for the first time; what is written into it later is the caller's care.
   */
  evaluate(mesh: Vertices, options?: EvaluateOptions): WarpedVertices
  /** Moves one vertex. */
  evaluateAt(position: ArrayLike<number>, inputs?: PointInputs): WarpedPoint
  /**
   * A box around all that the warp makes of `box`: never too small for what `evaluate` gives, and seldom much larger than
   * that. A GPU whose sine is less exact, as WebGPU allows to 2^-11, may go beyond by that part of a wave's height. It takes
   * from a tenth of a millisecond to some tens, for warps that are hard to bound. Where the offset depends on them, normals count as any numbers from -1 to 1, colors from 0 to 1, and texture coordinates from 0 to 1
   * unless `box.uvs` says otherwise. A side is infinite if the offset may be.
   *
   * The bounds of each coordinate contain all of its values except NaN: for sqrt(x) with x from -1 to 1, which is NaN on one
   * half, they are 0 and 1. So finite bounds do not guarantee that each vertex has a finite position. If a coordinate is NaN
   * everywhere, its `min` is Infinity and its `max` is -Infinity, as for an empty box.
   */
  bounds(box: Box, options?: EvaluationOptions): Bounds
  /**
   * Where the warp brings a point from, such as what of a calm sea is under a boat: evaluateAt of `position` is the point, up
   * to float32. In double, the warp moves `position` to within 1e-9 of the point's distance from the origin, plus at most 1e-10
   * for rounding. It is one place, and says whether that is in a fold; `undefined` if the search meets none, which proves
   * nothing of places that it does not come near. In double, by Newton's method with the exact Jacobian, each
   * step halved until it leads closer, and the way to the point taken in pieces where that fails. Normals and the like
   * count as constant. A warp compiled with `normals: false` has no Jacobian, and throws.
   */
  inverseAt(point: ArrayLike<number>, options?: InverseOptions): WarpInverse | undefined
  /** Where the warp turns the surface inside out. */
  foldover(mesh: Vertices, options?: EvaluationOptions): Foldover
  /** @internal */
  readonly [warpProgram]: RunningProgram
}

/** Of the program of directions: the position, and what becomes of the direction. */
const positionAndDirection = [0, 1, 2, 3, 4, 5]

const orientation = [0]

const pointOptions = [
  ...Object.keys(vertexInputs).filter((name) => name !== 'position'),
  'uniforms',
]

const evaluateOptions = ['uniforms', 'out']

const unitVectors: readonly Triple[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

export function createCpuWarp(warp: WarpProgram): CpuWarp {
  /** Into sinks of the results that are wanted. */
  function run(
    method: string,
    mesh: Vertices,
    vertices: number,
    uniforms: Uniforms | undefined,
    numbers: readonly number[],
    sinks: readonly Sink[],
  ) {
    const program = programOf(method, warp)
    const reading = readingOf(warp, program, numbers)
    const origins = originsOf(method, warp, reading, uniforms)
    for (const origin of origins) takeVertices(method, origin, mesh)
    copyOverwritten(origins, sinks, vertices)
    if (vertices > 0) runProgram(program, numbers, vertices, origins, sinks)
    keep(reading, origins)
  }

  function takeVertices(method: string, origin: Origin, mesh: Vertices) {
    const { input, isRead } = origin
    if (!input || !isRead) return
    const values = mesh[arrayNames[input]]
    if (values) {
      origin.values = values
      origin.size = vertexInputs[input]
      origin.isUniform = false
      return
    }
    if (input in variationInputs) {
      if (!warp.isAccepted) noteApproximation(method, 'surfaceVariation(mesh) of warpjet/mesh')
      return
    }
    const name = method === 'evaluateAt' ? input : arrayNames[input]
    throw new WarpError(
      `${method}: the warp reads the ${input} of each vertex, but no "${name}" came.`,
    )
  }

  function turned(mesh: Vertices) {
    if (!warp.hasNormals || !mesh.normals) return wanted.place
    return mesh.tangents ? wanted.frame : wanted.surface
  }

  function isMirrored(method: string, uniforms: Uniforms | undefined) {
    if (!warp.hasNormals) return false
    const program = warp.orientationProgram()
    const reading = readingOf(warp, program, orientation)
    const origins = originsOf(method, warp, reading, uniforms)
    const numbers = origins.flatMap((origin) => origin.numbers)
    keep(reading, origins)
    return runInDouble(program, numbers, 1)[0]! < 0
  }

  function mirrors() {
    if (!warp.hasNormals) return false
    const program = warp.orientationProgram()
    if (inputsRead(program, orientation).includes(true)) return undefined
    const inputs = program.inputs.flatMap(({ shape }) => Array<number>(shape[0] * shape[1]).fill(0))
    return runInDouble(program, inputs, 1)[0]! < 0
  }

  return {
    [warpProgram]: { ...warp, isMirrored, mirrors: lazily(mirrors) },

    evaluate(mesh, options) {
      const uniforms = uniformsOf('evaluate', options, evaluateOptions)
      const out = options?.out
      checkOptions('evaluate: out', out, wanted.frame.names)
      const vertices = checkVertices('evaluate', mesh)
      const results = turned(mesh)
      const sinks = takeSinks(results, vertices, out)
      run('evaluate', mesh, vertices, uniforms, results.numbers, sinks)
      return leaveSinks(results, sinks, out)
    },

    evaluateAt(position, inputs = {}) {
      checkOptions('evaluateAt', inputs ?? null, pointOptions)
      const vertex: Vertices = { positions: readNumbers('evaluateAt: the position', position, 3) }
      for (const key of Object.keys(inputs)) {
        const name = key as VertexInput
        const value = inputs[key as 'normal']
        if (key === 'uniforms' || value === undefined) continue
        vertex[arrayNames[name]] = readNumbers(`evaluateAt: the ${key}`, value, vertexInputs[name])
      }
      const { numbers, point } = turned(vertex)
      run('evaluateAt', vertex, 1, inputs.uniforms, numbers, point)
      const [positions, normals, tangents] = point
      return {
        position: Array.from(positions!.values),
        ...(normals && { normal: Array.from(normals.values) }),
        ...(tangents && { tangent: Array.from(tangents.values) }),
      }
    },

    inverseAt(point, options = {}) {
      checkOptions('inverseAt', options ?? null, ['near', 'normal', 'uv', 'color', 'uniforms'])
      const target = readNumbers('inverseAt: the point', point, 3) as Triple
      const near = readNumbers('inverseAt: near', options.near ?? target, 3) as Triple
      refuseWithoutNormals('inverseAt', warp)
      const program = programOf('inverseAt', warp, warp.directionProgram)
      const reading = readingOf(warp, program, positionAndDirection)
      const origins = originsOf('inverseAt', warp, reading, options.uniforms)
      const shared = origins.map(({ input, isRead, numbers }) => {
        if (!input || !isRead || input === 'position' || input === 'tangent') return numbers
        if (input in variationInputs) return numbers
        const value = options[input as 'normal']
        if (value) return readNumbers(`inverseAt: the ${input}`, value, vertexInputs[input])
        throw new WarpError(
          `inverseAt: the warp reads the ${input} of each vertex, but no "${input}" came.`,
        )
      })
      const given = (place: Triple, direction: Triple) =>
        origins.flatMap(({ input }, i) => {
          if (input === 'position') return place
          return input === 'tangent' ? [...direction, 1] : shared[i]!
        })
      const moved = (place: Triple): Moved => {
        const runs = unitVectors.map((direction) =>
          runInDouble(program, given(place, direction), 6),
        )
        return {
          position: runs[0]!.slice(0, 3) as Triple,
          columns: runs.map((run) => run.slice(3)) as Moved['columns'],
        }
      }
      return inverse(moved, target, near)
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
      const reading = readingOf(warp, program, numbersOf.positions)
      const given = originsOf('bounds', warp, reading, uniforms).flatMap(
        ({ input, numbers }) =>
          // What turns the normal does not move the vertex.
          (input && ranges[input]) ?? numbers.map((x): Range => [x, x]),
      )
      const found = boundProgram(program, given, numbersOf.positions)
      return { min: found.map(([low]) => low), max: found.map(([, high]) => high) }
    },

    foldover(mesh, options) {
      const uniforms = uniformsOf('foldover', options)
      refuseWithoutNormals('foldover', warp)
      const vertices = checkVertices('foldover', mesh)
      const values = new Float32Array(vertices)
      const sinks = [{ values, results: numbersOf.determinant }]
      run('foldover', mesh, vertices, uniforms, numbersOf.determinant, sinks)
      const mask = Uint8Array.from(values, (value) => Number(!(value > 0)))
      return { mask, count: mask.reduce((sum, folded) => sum + folded, 0) }
    },
  }
}

function refuseWithoutNormals(method: string, { hasNormals }: WarpProgram) {
  if (!hasNormals)
    throw new WarpError(
      `${method}: the warp was compiled with "normals: false", which leaves out its derivatives; compile it without.`,
    )
}

function programOf(method: string, warp: WarpProgram, make = warp.program): Program {
  const program = make()
  if (program) return program
  throw new WarpError(
    `${method}: this warp calls a function of glsl.fn or reads an image by glsl.texture, which only the GPU can do.`,
  )
}
