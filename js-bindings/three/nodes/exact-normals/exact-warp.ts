// The warp that is read from the code of a positionNode. It is compiled for normals, tangents, velocities and pixels like any other warp.
import type { Texture } from 'three'
import {
  type Expression,
  type HostText,
  type OffsetFunction,
  type Target,
} from '../../../compile/hosts.js'
import { markLibraryFunction } from '../../../errors/operators.js'
import { readGenerated } from '../../../glsl-source/generated.js'
import { readOffset, readPositionWithOthers } from '../../../glsl-source/offset.js'
import { Place } from '../../../options/place.js'
import type { Settings } from '../../settings.js'
import { ThreeWarp, type Stage } from '../../three-warp.js'
import { tsl, type AnyNode } from '../tsl.js'
import type { NodesByName } from '../uniforms.js'
import { functionName, sizeOfEffects, type PositionSource } from './read-position.js'

export interface ExactNodeSettings extends Settings {
  /** The option, or `untilEnd`. */
  maxIterations: number
}

/** The function that a warp is made of. */
interface ExactOffset {
  offset: OffsetFunction
  /** Returns the numbers of the effects, once the offset function was called. */
  others?: () => readonly Expression[]
  /** The message about a loop that is cut off before its end; empty if there is none. */
  cutOff: string
}

/** Returns the offset function of a positionNode. */
export function offsetOf(
  { language, text }: PositionSource,
  { method, maxIterations }: ExactNodeSettings,
): ExactOffset {
  const place = new Place(method)
  const read = readGenerated(place, () =>
    readOffset(place, language, text, {
      function: functionName,
      returns: 'position',
      maxIterations,
    }),
  )
  // The other inputs, such as millis, would be taken for uniforms of the source that have their names.
  const offset: OffsetFunction = markLibraryFunction(({ glsl, position, normal, uv, uniforms }) =>
    read.offset({ glsl, position, normal, uv, uniforms } as never),
  )
  return { offset, cutOff: read.cutOff }
}

/** An element of an array in the source, such as `warpjetOuter2.value[3]`. */
const elementName = /^(\w+?)(?:\.value)?\[(\d+)u?\]$/

const identifierOf = (name: string) => name.replace(elementName, '$1_$2')

/** Returns the offset function of a positionNode with its effects. */
function offsetWithEffectsOf(
  { language, effects }: PositionSource,
  { method, maxIterations }: ExactNodeSettings,
  text: string,
): ExactOffset {
  const place = new Place(method)
  const { read, cutOff } = readGenerated(place, () =>
    readPositionWithOthers(place, language, text, { function: functionName, maxIterations }),
  )
  let numbers: readonly Expression[] = []
  const offset: OffsetFunction = markLibraryFunction(({ glsl, position, normal, uv, uniforms }) => {
    const { offset, others } = read({ glsl, position, normal, uv, uniforms } as never)
    numbers = others.slice(0, sizeOfEffects(effects))
    return offset
  })
  return { offset, others: () => numbers, cutOff }
}

export class ExactWarp extends ThreeWarp {
  /** Always false: where the position mirrors triangles, three.js draws their backs, as it does without exact normals. */
  override get mirrors() {
    return false
  }

  override readonly isMirroredNow = () => false
  /** The message about a loop that is cut off before its end; empty if there is none. */
  readonly cutOff: string
  /** The names by which the source reads elements of arrays; they are not identifiers. */
  private readonly elements: readonly string[]

  /** `text` is the `textWithEffects` of the source. If it is passed, the shader code computes the effects, too. */
  constructor(source: PositionSource, settings: ExactNodeSettings, text?: string) {
    const types = new Map([...source.values].map(([name, { type }]) => [name, type]))
    const images = Object.fromEntries(
      [...source.textures].map(([name, node]) => [name, () => node.value as Texture]),
    )
    const { offset, others, cutOff } = text
      ? offsetWithEffectsOf(source, settings, text)
      : offsetOf(source, settings)
    super(offset, { ...settings, uniforms: images }, types, others)
    this.cutOff = cutOff
    this.elements = [...this.variableNames()].filter((name) => elementName.test(name))
    for (const name of this.elements) {
      const [, list] = elementName.exec(name)!
      types.set(identifierOf(name), source.values.get(list!)!.array!.elementType)
    }
  }

  override textFor(target: Target, stage: Stage, names: Record<string, string>): HostText {
    const text = renameDeclared(super.textFor(target, stage, names))
    if (this.elements.length === 0) return text
    return {
      ...text,
      code: this.elements.reduce(
        (code, name) => code.replaceAll(name, identifierOf(name)),
        text.code,
      ),
      parameters: text.parameters.map((each) => ({ ...each, name: identifierOf(each.name) })),
    }
  }

  /** Returns the nodes behind the names that the shader code reads. */
  outerNodes({ values }: PositionSource): NodesByName {
    const elements = this.elements.map((name) => {
      const [, list, index] = elementName.exec(name)!
      return [
        identifierOf(name),
        elementOf(values.get(list!)!.node, Number(index), values.get(list!)!.array!.elementType),
      ] as const
    })
    return Object.fromEntries([
      ...[...values]
        .filter(([, { array }]) => !array)
        .map(([name, { node }]) => [name, node] as const),
      ...elements,
    ])
  }
}

/** Matches the names of functions and constants that the code of a warp declares in WGSL and GLSL. */
const declared =
  /(?:^|\n)(?:fn|const|(?:const )?(?:(?:high|medium|low)p )?(?:void|float|u?int|bool|[iub]?vec[234]|mat[234]))\s+(\w+)\s*[(:=[]/g

/** Renames the functions and constants that the code declares, since another warp in the same shader may declare the same names. */
function renameDeclared(text: HostText): HostText {
  const names = [...text.declarations.matchAll(declared)].map(([, name]) => name!)
  if (names.length === 0) return text
  const pattern = new RegExp(`\\b(?:${names.join('|')})\\b`, 'g')
  const rename = (source: string) => source.replace(pattern, '$&_exact')
  return { ...text, code: rename(text.code), declarations: rename(text.declarations) }
}

/** Returns the node of an element, with the type of the array's elements: uniform arrays pad them to four numbers. */
function elementOf(list: AnyNode, index: number, type: string): AnyNode {
  const element = list.element(index)
  return /^vec4$/.test(type) ? tsl.vec4(element) : element
}
