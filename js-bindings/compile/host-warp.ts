// `HostWarp`: everything that an adapter needs from a warp, so that the adapter contains only what is particular to its host.
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import { vertexInputs, type InputName } from '../core/inputs/inputs.js'
import { allowNonFinite, type Box, type Vertices } from '../core/inputs/vertices.js'
import { lazily } from '../core/module/lazily.js'
import { ResultSet } from '../core/module/result-set.js'
import { costOf, makePhases, makeProgram, type Program } from '../core/module/serialized-module.js'
import { inputsRead } from '../cpu/analyse-program.js'
import { bounds } from '../cpu/bounds.js'
import type { Bounds, CpuWarp } from '../cpu/cpu-warp.js'
import { createCpuWarp } from '../cpu/create-cpu-warp.js'
import type { Sink } from '../cpu/machine-code.js'
import { Pool } from '../cpu/pool.js'
import { positionsAlone } from '../cpu/results.js'
import { runOnVertices } from '../cpu/vertex-run.js'
import { warpProgram, type WarpProgram } from '../cpu/warp-program.js'
import type { Place } from '../options/place.js'
import { warpResults } from '../wasm/tables.js'
import { OffsetWarp, type DrawValues } from './offset-warp.js'
import { onSurface } from './recorded-warp.js'

type CpuResult = 'position' | 'offset'

/** The approximate number of instructions that `quickBounds` may run. */
const quickBudget = 20_000

/**
 * Phases, fronts and kinks limit how far apart samples may be: phases are the arguments of waves and noises in the warped position, and the normal that it
 * reads; fronts are the arguments of functions that change within a short part of their argument's range; at kinks, the slope jumps. Errors
 * of its functions name the call `place`. Default: the call that made the warp.
 */
export interface SurfacePhases {
  /** The number of floats per vertex, for each phase. */
  readonly sizes: readonly number[]
  /** The distance that each phase may move between samples. */
  readonly steps: readonly number[]
  /** 3 numbers per front: its profile and two parameters (src/eval/front.hpp). Each front has 1 float per vertex, after the phases. */
  readonly fronts: readonly number[]
  /** `true` if any front is neither a kink nor a cusp: the mesh is cut again when such a front moves. */
  readonly hasPeaksOrSteps: boolean
  /** `true` if any front is a kink: triangles that it passes through are divided more finely. */
  readonly hasKinks: boolean
  /** The number of floats per vertex, for all phases and fronts together. */
  readonly size: number
  /** Writes the numbers on which the phases depend, other than vertices, to the start of an array. Returns how many there are. */
  writeState(drawValues: DrawValues, to: number[], place?: Place): number
  /** Writes the phases of the first `count` vertices. */
  evaluate(
    vertices: Vertices,
    count: number,
    drawValues: DrawValues,
    into: Float32Array,
    place?: Place,
  ): void
}

/** The number of `Profile::Kink` (src/eval/front.hpp). Only that of a cusp is larger. */
const kinkProfile = 4

const noValues = new Float32Array()

export class HostWarp extends OffsetWarp {
  private readonly sinks = new Pool((): [Sink] => [{ values: noValues, results: [] }])
  private readonly onCpu = {
    position: lazily(() => createCpuWarp(this.programs('position'))),
    offset: lazily(() => createCpuWarp(this.programs('offset'))),
  }

  /** Returns the warp on the CPU, with the user's names. If `result` is `'offset'`, it evaluates offsets instead of warped positions. */
  cpu(result: CpuResult = 'position'): CpuWarp {
    return this.onCpu[result]()
  }

  /** True if the CPU can evaluate the warp; false if it calls a `glsl.fn` or reads an image. */
  get canRunOnCpu(): boolean {
    return this.positionProgram().program() !== undefined
  }

  /** True if the warp mirrors all of space, so that the back of a triangle is its outer side; `undefined` if that depends on uniforms. */
  get mirrors(): boolean | undefined {
    return this.positionProgram().mirrors()
  }

  /** Tests whether the warp mirrors all of space with these values. */
  isMirrored(drawValues: DrawValues): boolean {
    return this.positionProgram().isMirrored(this.place, drawValues as never)
  }

  /**
   * Returns bounds like `bounds` of `cpu(result)`, but much faster and, for some warps, wider, since hosts need bounds in each frame. For a
   * sum of octaves of noise, the bounds of `cpu()` take more than a tenth of a second and are not narrower.
   */
  quickBounds(result: CpuResult, box: Box, drawValues: DrawValues): Bounds {
    return bounds(
      this.cpu(result)[warpProgram],
      box,
      { uniforms: drawValues as never },
      quickBudget,
    )
  }

  /** Evaluates like `evaluate` of `cpu()`, but accepts vertices that are not finite, since hosts draw those too. */
  evaluate(vertices: Vertices, drawValues: DrawValues) {
    return this.cpu().evaluate(allowNonFinite(vertices), { uniforms: drawValues as never })
  }

  /** Estimates the operations on single floats in the warped position of a vertex. */
  readonly operations = lazily(
    () => costOf(this.recorded.module, [onSurface(warpResults.position)]).operations,
  )

  /**
   * Calls the uniforms that are functions, and returns `drawValues` with their current values, so that several evaluations use the same
   * values. Errors name the call `place`. Default: the call that made the warp.
   */
  withUniformsNow(drawValues: DrawValues, place = this.place): DrawValues {
    return snapshotUniforms(place, this.uniforms.declared, drawValues)!
  }

  /**
   * Writes the warped positions of the first `count` vertices into an array, and computes nothing else. Errors name the call `place`.
   * Default: the call that made the warp.
   */
  evaluatePositions(
    vertices: Vertices,
    count: number,
    drawValues: DrawValues,
    into: Float32Array,
    place = this.place,
  ) {
    this.runOn(this.positionProgram(), place, vertices, count, drawValues, positionsAlone, into)
  }

  /** Returns the phases of the warped position; `undefined` if it has none, or if only the GPU can evaluate it. */
  readonly surfacePhases = lazily((): SurfacePhases | undefined => {
    const { module, inputs } = this.recorded
    const varying = Object.keys(vertexInputs).map((name) => inputs[name as InputName])
    const madePhases = this.canRunOnCpu
      ? makePhases(module, [warpResults.position], varying)
      : undefined
    if (!madePhases) return undefined
    const sizes = madePhases.phases.map((each) => each.size)
    const steps = madePhases.phases.map((each) => each.step)
    const { fronts } = madePhases
    const profiles = fronts.filter((_, i) => i % 3 === 0)
    const size = sizes.reduce((sum, each) => sum + each, fronts.length / 3)
    const results = new ResultSet(Array.from({ length: size }, (_, i) => i))
    const program = this.withUserNames(madePhases.program)
    const phaseProgram: WarpProgram = {
      ...this.programs('position'),
      // Frame constants belong to the shader code, which does not compute phases.
      frameConstants: undefined,
      program: () => program,
    }
    const isRead = inputsRead(madePhases.program, results.numbers)
    const inputsOfPhases = this.nameInputs(madePhases.program.inputs.filter((_, i) => isRead[i]))
    return {
      sizes,
      steps,
      fronts,
      hasPeaksOrSteps: profiles.some((profile) => profile < kinkProfile),
      hasKinks: profiles.includes(kinkProfile),
      size,
      writeState: (drawValues, to, place = this.place) =>
        this.writeNumbers(inputsOfPhases, drawValues, to, place),
      evaluate: (vertices, count, drawValues, into, place = this.place) =>
        this.runOn(phaseProgram, place, vertices, count, drawValues, results, into),
    }
  })

  /** Creates no garbage if the inputs are numbers. */
  private runOn(
    program: WarpProgram,
    place: Place,
    vertices: Vertices,
    count: number,
    drawValues: DrawValues,
    results: ResultSet,
    into: Float32Array,
  ) {
    const sinks = this.sinks.take()
    const [sink] = sinks
    sink.values = into
    sink.results = results.numbers
    runOnVertices(program, place, vertices, count, drawValues as never, results, sinks)
    sink.values = noValues
    this.sinks.giveBack(sinks)
  }

  private positionProgram() {
    return this.cpu()[warpProgram]
  }

  private programs(result: CpuResult): WarpProgram {
    const { settings, inputs, varies } = this.recorded
    const hasNormals = settings.normals && result === 'position'
    const { normal, tangent, determinant, direction, orientation } = warpResults
    // In the order of resultNumbers in cpu/results.ts.
    const results = hasNormals ? [normal, tangent, determinant] : []
    return {
      declared: this.uniforms.declared,
      frameConstants:
        this.isFrameConstant && ((place, drawValues) => this.frame(drawValues, place)),
      program: lazily(() => this.withUserNames(this.program(warpResults[result], ...results))),
      directionProgram: lazily(() => this.program(warpResults.position, direction)),
      // The orientation calls no function of the host, so there is always a program.
      orientationProgram: lazily(() => this.program(orientation)!),
      hasNormals,
      varies,
      // A host has warned when the warp was made.
      isAccepted: settings.isAccepted || this.host !== undefined,
      // A shader may read the tangent and another input from one attribute. Then the first of the two counts (see cpu/origins.ts), so the
      // tangent is first.
      inputs: { tangent: inputs.tangent, ...(inputs as Record<string, number>) },
    }
  }

  private program(...results: number[]): Program | undefined {
    return makeProgram(this.recorded.module, results.map(onSurface), this.isFrameConstant)
  }

  private withUserNames(program: Program | undefined): Program | undefined {
    const inputs = program?.inputs.map((each) => ({ ...each, name: this.userName(each.name) }))
    return program && { ...program, inputs: inputs! }
  }
}
