// `HostWarp`: what a host needs of a warp, so that its adapter only says where the host differs.
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { createCpuWarp } from '../cpu/create-cpu-warp.js'
import { warpProgram } from '../cpu/warp-program.js'
import { type Vertices, allowNonFinite } from '../core/inputs/vertices.js'
import { makeProgram } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { warpResults } from '../wasm/tables.js'
import { type DrawValues, OffsetWarp } from './offset-warp.js'
import { onSurface } from './recorded-warp.js'

export class HostWarp extends OffsetWarp {
  /** The warp on the CPU, under the user's names. With `'offset'` it gives how far a vertex moves, in place of where. */
  cpu(place: 'position' | 'offset' = 'position'): CpuWarp {
    const { module, settings, inputs, varies } = this.recorded
    const hasNormals = settings.normals && place === 'position'
    const program = () => makeProgram(module, this.cpuResults(place, hasNormals), this.known)
    return createCpuWarp({
      declared: this.uniforms.declared,
      valuesOfFrame: this.known && ((method, given) => this.frame(given, method)),
      program: lazily(() => {
        const made = program()
        const named = made?.inputs.map((each) => ({ ...each, name: this.userName(each.name) }))
        return made && { ...made, inputs: named! }
      }),
      directionProgram: lazily(() =>
        makeProgram(
          module,
          [warpResults.position, warpResults.direction].map(onSurface),
          this.known,
        ),
      ),
      // No function of the host decides it.
      orientationProgram: lazily(() => makeProgram(module, [warpResults.orientation], this.known)!),
      hasNormals,
      varies,
      // A host says it where the warp is made.
      isAccepted: settings.isAccepted || this.host !== undefined,
      // The tangent is first, for a shader may carry it in the place of another attribute.
      inputs: { tangent: inputs.tangent, ...(inputs as Record<string, number>) },
    })
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
    return this.whole().evaluate(allowNonFinite(vertices), { uniforms: given as never })
  }

  private readonly whole = lazily(() => this.cpu())
  private readonly running = () => this.whole()[warpProgram]

  /** In the order of numbersOf in cpu/results.ts. */
  private cpuResults(place: 'position' | 'offset', hasNormals: boolean): number[] {
    const { [place]: position, normal, tangent, determinant } = warpResults
    return (hasNormals ? [position, normal, tangent, determinant] : [position]).map(onSurface)
  }
}
