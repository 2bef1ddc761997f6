// `tslOffset`: makes an offset function from a function in TSL, for every host and for the CPU.
import type { Texture } from 'three'
import type { Node } from 'three/webgpu'
import type { Vec3, WarpInputs } from '../../../compile/hosts.js'
import { WarpError, describe } from '../../../errors/errors.js'
import { markLibraryFunction } from '../../../errors/operators.js'
import { readGenerated } from '../../../glsl-source/generated.js'
import { readOffset } from '../../../glsl-source/offset.js'
import { loopKinds, type LoopOptions } from '../../../options/iterations.js'
import { callback, oneOf } from '../../../options/kinds.js'
import { Place } from '../../../options/place.js'
import { object, type KindsOf } from '../../../options/schema.js'
import { three } from '../../values.js'
import { tsl, type AnyNode } from '../tsl.js'
import { plainBuilder } from './plain-builder.js'
import { functionName, readPosition } from './read-position.js'
import type { OuterValue, ReadNode } from './reading-builder.js'

export interface TslOffsetOptions extends LoopOptions {
  /**
   * Meaning of the function's result: `'offset'` is added to the position, `'position'` is the new position, as for a `positionNode`.
   * @default 'offset'
   */
  returns?: 'offset' | 'position'
}

/** An offset function for any host, with the uniforms of its nodes. */
export interface TslOffset {
  (inputs: Pick<WarpInputs, 'glsl' | 'position'>): Vec3
  /**
   * Maps the name of a uniform node, or `uniform0`, `uniform1` … → its current value, for the option `uniforms`:
   * `warp(mesh, wave, { uniforms: wave.uniforms })`.
   */
  readonly uniforms: Readonly<Record<string, () => number | readonly number[]>>
}

const place = new Place('tslOffset')
const optionsKind = object({
  returns: oneOf(['offset', 'position'], 'offset'),
  maxIterations: loopKinds.maxIterations,
} satisfies KindsOf<TslOffsetOptions>)

/**
 * Makes an offset function from a function in TSL: `tslOffset((position) => vec3(0, sin(position.x.add(time)), 0))`. The argument of that
 * function is the position, a node; it may also read `normalLocal`, `uv()`, `time`, uniforms and textures. The offset function works with
 * any host, and on the CPU for evaluation, bounds and so on. `time` is the input `millis` in seconds; the result's `uniforms` has the other
 * uniforms.
 *
 * A loop whose end only the shader knows runs until it ends; on the CPU it runs at most 256 iterations, and a vertex that needs more is
 * `NaN`. If it cannot stay a loop in the shader, it is cut off after 256 iterations, and a console warning says which loop that is. The
 * option `maxIterations` limits every such loop, on the CPU, too, and silences the warning.
 *
 * Throws a `WarpError` if the function reads something that offset functions do not have, such as `instanceIndex` or the camera.
 */
export function tslOffset(
  work: (position: Node<'vec3'>) => Node,
  options?: TslOffsetOptions,
): TslOffset {
  callback.read(work, place)
  const { returns, maxIterations } = optionsKind.read(options, place)
  const result = work(tsl.positionLocal as never) as unknown as AnyNode
  if (!(result as { isNode?: boolean } | undefined)?.isNode)
    throw place.part('the function').expected('a node that is a vec3', describe(result))
  const source = readPosition(place.method, plainBuilder(place.method), result)
  const uniformsOfNodes = new Uniforms()
  const bindings = [
    ...[...source.values].flatMap(([name, value]) => uniformsOfNodes.bind(name, value)),
    ...[...source.textures].map(([name, node]) => uniformsOfNodes.bindTexture(name, node)),
  ]
  const unknownNode = source.updated.find((node) => !uniformsOfNodes.has(node))
  if (unknownNode) throw unknownValueError(unknownNode)
  const read = readGenerated(place, () =>
    readOffset(place, 'glsl', source.text, { function: functionName, returns, maxIterations }),
  )
  if (read.cutOff) console.warn(`${place.method}: ${read.cutOff}`)
  const offset = markLibraryFunction((inputs: WarpInputs) => {
    const { glsl, position, normal, uv } = inputs
    const uniforms = Object.fromEntries(bindings.map(([name, bind]) => [name, bind(inputs)]))
    return read.offset({ glsl, position, normal, uv, uniforms } as never)
  })
  return Object.assign(offset as unknown as TslOffset, { uniforms: uniformsOfNodes.values })
}

/** A name in the source, and a function that returns its value when the offset function is called. */
type Binding = [name: string, bind: (inputs: WarpInputs) => unknown]

interface UniformNode extends ReadNode {
  isUniformNode?: boolean
  name?: string | null
}

interface ElementNode extends ReadNode {
  node: ReadNode & { array?: unknown[] }
  indexNode: AnyNode & { value?: unknown }
}

class Uniforms {
  readonly values: Record<string, () => number | readonly number[]> = {}
  private readonly nodes = new Set<unknown>([tsl.time])

  /** Tests whether the current value of a node is known without a renderer. */
  has(node: ReadNode): boolean {
    return this.nodes.has(node)
  }

  bind(name: string, { node: outer, array }: OuterValue): Binding[] {
    if ((outer as unknown) === tsl.time)
      return [[name, ({ millis }) => (millis as unknown as { div(x: number): unknown }).div(1000)]]
    if (array) {
      const list = outer as ElementNode['node']
      if (!list.array) throw unknownValueError(list)
      this.nodes.add(list)
      return list.array.map((_, i) =>
        this.uniform(`${name}[${i}]`, undefined, () => padToFour(numbersOf(list.array![i]))),
      )
    }
    const element = outer as ElementNode
    const { indexNode, node } = element
    const index = indexNode?.value
    if (node?.array && typeof index === 'number') {
      this.nodes.add(node)
      return [this.uniform(name, undefined, () => numbersOf(node.array![index]))]
    }
    const uniform = outer as UniformNode & { value?: unknown }
    if (!('value' in uniform) || isUpdatedByThree(uniform)) throw unknownValueError(uniform)
    return [this.uniform(name, uniform.name, () => numbersOf(uniform.value))]
  }

  bindTexture(name: string, node: { value: Texture }): Binding {
    this.nodes.add(node)
    return this.uniform(name, undefined, () => node.value as never)
  }

  private uniform(
    name: string,
    nodeName: string | null | undefined,
    read: () => number | readonly number[],
  ): Binding {
    const isUsableName = nodeName && /^[a-z]\w*$/i.test(nodeName) && !(nodeName in this.values)
    let number = Object.keys(this.values).length
    while (`uniform${number}` in this.values) number++
    const label = isUsableName ? nodeName : `uniform${number}`
    this.values[label] = read
    return [name, ({ uniforms }) => uniformOf(uniforms, label)]
  }
}

function uniformOf(uniforms: object, label: string): unknown {
  if (label in uniforms) return (uniforms as Record<string, unknown>)[label]
  throw new WarpError(
    `${place.method}: the function reads uniforms of TSL, which the warp does not have; pass the option { uniforms: offset.uniforms }, where offset is the result of tslOffset.`,
  )
}

/** Returns the numbers of a value: of a number, or of a vector, colour or matrix of three.js. */
function numbersOf(value: unknown): number | readonly number[] {
  if (typeof value === 'boolean') return Number(value)
  return three.values!.toNumbers(value) as number | readonly number[]
}

/** Pads to four numbers, as three.js does for the elements of an array of uniforms. */
const padToFour = (value: number | readonly number[]) => {
  const numbers = [value].flat()
  return numbers.length < 4 ? [...numbers, 0, 0, 0].slice(0, 4) : numbers
}

const isUpdatedByThree = ({ updateType }: ReadNode) =>
  updateType !== undefined && updateType !== 'none'

function unknownValueError(node: ReadNode): WarpError {
  const { type } = node as unknown as { type: string }
  return place.error(
    `the function reads ${/^[AEIO]/.test(type) ? 'an' : 'a'} ${type} that three.js computes as it draws; expected a function of position, normalLocal, uv(), time, uniform() and texture().`,
  )
}
