// `HostWarp`: what a host needs of a warp, so that its adapter only says where the host differs.
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { createCpuWarp } from '../cpu/create-cpu-warp.js'
import { type WarpProgram, warpProgram } from '../cpu/warp-program.js'
import { type Vertices, allowNonFinite } from '../core/inputs/vertices.js'
import { type Program, makeProgram } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { warpResults } from '../wasm/tables.js'
import { type DrawValues, OffsetWarp } from './offset-warp.js'
import { onSurface } from './recorded-warp.js'

type Place = 'position' | 'offset'

export class HostWarp extends OffsetWarp {
  private readonly onCpu = {
    position: lazily(() => createCpuWarp(this.programs('position'))),
    offset: lazily(() => createCpuWarp(this.programs('offset'))),
  }

  /** The warp on the CPU, under the user's names. With `'offset'` it gives how far a vertex moves, in place of where. */
  cpu(place: Place = 'position'): CpuWarp {
    return this.onCpu[place]()
  }

  /** `true` if the CPU can run it: not if it calls a `glsl.fn` or reads an image. */
  get runs(): boolean {
    return this.running().program() !== undefined
  }

  /** `true` if it mirrors all of space, so that the outer side of a triangle is its back; `undefined` if uniforms decide that. */
  get mirrors(): boolean | undefined {
    return this.running().mirrors()
  }

  /** Tests whether it mirrors all of space with these values. */
  isMirrored(given: DrawValues): boolean {
    return this.running().isMirrored(this.method, given as never)
  }

  /** Like `evaluate` of `cpu()`, but numbers that are not finite may be among the vertices, since hosts draw those too. */
  evaluate(vertices: Vertices, given: DrawValues) {
    return this.cpu().evaluate(allowNonFinite(vertices), { uniforms: given as never })
  }

  private running() {
    return this.cpu()[warpProgram]
  }

  private programs(place: Place): WarpProgram {
    const { settings, inputs, varies } = this.recorded
    const hasNormals = settings.normals && place === 'position'
    const { normal, tangent, determinant, direction, orientation } = warpResults
    // In the order of numbersOf in cpu/results.ts.
    const results = hasNormals ? [normal, tangent, determinant] : []
    return {
      declared: this.uniforms.declared,
      valuesOfFrame: this.known && ((method, given) => this.frame(given, method)),
      program: lazily(() => this.withUserNames(this.program(warpResults[place], ...results))),
      directionProgram: lazily(() => this.program(warpResults.position, direction)),
      // No function of the host decides it.
      orientationProgram: lazily(() => this.program(orientation)!),
      hasNormals,
      varies,
      // A host says it where the warp is made.
      isAccepted: settings.isAccepted || this.host !== undefined,
      // The tangent is first, for a shader may carry it in the place of another attribute.
      inputs: { tangent: inputs.tangent, ...(inputs as Record<string, number>) },
    }
  }

  private program(...results: number[]): Program | undefined {
    return makeProgram(this.recorded.module, results.map(onSurface), this.known)
  }

  private withUserNames(program: Program | undefined): Program | undefined {
    const inputs = program?.inputs.map((each) => ({ ...each, name: this.userName(each.name) }))
    return program && { ...program, inputs: inputs! }
  }
}
