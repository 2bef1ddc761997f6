// `HostWarp`: everything that an adapter needs from a warp, so that it contains only what is particular to its host.
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import { vertexInputs, type InputName } from '../core/inputs/inputs.js'
import { allowNonFinite, type Box, type Vertices } from '../core/inputs/vertices.js'
import { lazily } from '../core/module/lazily.js'
import { ResultSet } from '../core/module/result-set.js'
import { costOf, makePhases, makeProgram, type Program } from '../core/module/serialized-module.js'
import { bounds } from '../cpu/bounds.js'
import type { Bounds, CpuWarp } from '../cpu/cpu-warp.js'
import { createCpuWarp } from '../cpu/create-cpu-warp.js'
import { positionsAlone } from '../cpu/results.js'
import { runOnVertices } from '../cpu/vertex-run.js'
import { warpProgram, type WarpProgram } from '../cpu/warp-program.js'
import { warpResults } from '../wasm/tables.js'
import { OffsetWarp, type DrawValues } from './offset-warp.js'
import { onSurface } from './recorded-warp.js'

type CpuResult = 'position' | 'offset'

/** The approximate number of instructions that `quickBounds` may run. */
const quickBudget = 20_000

/** The points at which waves and noises of the warped position are evaluated; they say how far apart samples may be. */
export interface SurfacePhases {
  /** The numbers per vertex of each phase. */
  readonly sizes: readonly number[]
  /** The distance that each phase may move between samples. */
  readonly steps: readonly number[]
  /** The numbers per vertex of all phases. */
  readonly size: number
  /** Writes the phases of the first `count` vertices. */
  evaluate(vertices: Vertices, count: number, given: DrawValues, into: Float32Array): void
}

export class HostWarp extends OffsetWarp {
  private readonly onCpu = {
    position: lazily(() => createCpuWarp(this.programs('position'))),
    offset: lazily(() => createCpuWarp(this.programs('offset'))),
  }

  /** Returns the warp on the CPU, with the user's names. With `'offset'` it returns offsets instead of warped positions. */
  cpu(result: CpuResult = 'position'): CpuWarp {
    return this.onCpu[result]()
  }

  /** `true` if the CPU can evaluate it; `false` if it calls a `glsl.fn` or reads an image. */
  get canRunOnCpu(): boolean {
    return this.running().program() !== undefined
  }

  /** `true` if it mirrors all of space, so that the back of a triangle is its outer side; `undefined` if that depends on uniforms. */
  get mirrors(): boolean | undefined {
    return this.running().mirrors()
  }

  /** Tests whether it mirrors all of space with these values. */
  isMirrored(given: DrawValues): boolean {
    return this.running().isMirrored(this.place, given as never)
  }

  /**
   * Like `bounds` of `cpu(result)`, but wider for some warps and much faster, since hosts need bounds in each frame. For a sum of octaves
   * of noise, those of `cpu()` take more than a tenth of a second and are not narrower.
   */
  quickBounds(result: CpuResult, box: Box, given: DrawValues): Bounds {
    return bounds(this.cpu(result)[warpProgram], box, { uniforms: given as never }, quickBudget)
  }

  /** Like `evaluate` of `cpu()`, but accepts vertices that are not finite, since hosts draw those too. */
  evaluate(vertices: Vertices, given: DrawValues) {
    return this.cpu().evaluate(allowNonFinite(vertices), { uniforms: given as never })
  }

  /** Estimates the operations on single floats in the warped position of a vertex. */
  readonly operations = lazily(
    () => costOf(this.recorded.module, [onSurface(warpResults.position)]).operations,
  )

  /** Returns the values with those of functions among the uniforms, so that several evaluations use the same ones. */
  withUniformsNow(given: DrawValues): DrawValues {
    return snapshotUniforms(this.place, this.uniforms.declared, given)!
  }

  /** Writes the warped positions of the first `count` vertices into an array, and computes nothing else. */
  evaluatePositions(vertices: Vertices, count: number, given: DrawValues, into: Float32Array) {
    this.runOn(this.running(), vertices, count, given, positionsAlone, into)
  }

  /** Returns the phases of the warped position; `undefined` if it has none, or if only the GPU can evaluate it. */
  readonly surfacePhases = lazily((): SurfacePhases | undefined => {
    const { module, inputs } = this.recorded
    const varying = Object.keys(vertexInputs).map((name) => inputs[name as InputName])
    const made = this.canRunOnCpu ? makePhases(module, [warpResults.position], varying) : undefined
    if (!made) return undefined
    const sizes = made.phases.map((each) => each.size)
    const steps = made.phases.map((each) => each.step)
    const size = sizes.reduce((sum, each) => sum + each, 0)
    const results = new ResultSet(Array.from({ length: size }, (_, i) => i))
    const program = this.withUserNames(made.program)
    const running: WarpProgram = {
      ...this.programs('position'),
      // Frame constants are those of the shader code, which phases are not part of.
      frameConstants: undefined,
      program: () => program,
    }
    const evaluate: SurfacePhases['evaluate'] = (vertices, count, given, into) =>
      this.runOn(running, vertices, count, given, results, into)
    return { sizes, steps, size, evaluate }
  })

  private runOn(
    program: WarpProgram,
    vertices: Vertices,
    count: number,
    given: DrawValues,
    results: ResultSet,
    into: Float32Array,
  ) {
    const sinks = [{ values: into, results: results.numbers }]
    runOnVertices(program, this.place, vertices, count, given as never, results, sinks)
  }

  private running() {
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
      frameConstants: this.isFrameConstant && ((place, given) => this.frame(given, place)),
      program: lazily(() => this.withUserNames(this.program(warpResults[result], ...results))),
      directionProgram: lazily(() => this.program(warpResults.position, direction)),
      // It calls no function of the host, so that there is always a program.
      orientationProgram: lazily(() => this.program(orientation)!),
      hasNormals,
      varies,
      // A host warns when the warp is made.
      isAccepted: settings.isAccepted || this.host !== undefined,
      // The tangent is first: a shader may read it from the attribute of another input.
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
