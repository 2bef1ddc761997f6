/** Numbers that change when the arrays of a mesh that is divided do. */
import type { Mesh } from 'three'
import { versionOf } from '../attribute.js'
import { fillOf } from '../surface.js'
import type { ThreeWarp } from '../three-warp.js'
import { isOfInstances } from './base.js'

/** Numbers that change when the arrays of the base do. */
export function baseState(warp: ThreeWarp, object: Mesh): number[] {
  const { geometry, material } = object
  const { index, groups, drawRange, attributes, morphAttributes } = geometry
  return [
    numberOf(geometry),
    ...Object.values(attributes)
      .filter((attribute) => !isOfInstances(attribute))
      .flatMap((attribute) => [numberOf(attribute), versionOf(attribute)]),
    ...(index ? [numberOf(index), index.version] : []),
    ...Object.values(morphAttributes).map(({ length }) => length),
    ...[drawRange.start, drawRange.count],
    ...(Array.isArray(material)
      ? groups.flatMap(({ start, count, materialIndex }) => [start, count, materialIndex ?? -1])
      : [-2]),
    ...(warp.reads('color')
      ? [Number([material].flat()[0]!.vertexColors), ...fillOf(material)]
      : []),
  ]
}

const numbers = new WeakMap<object, number>()
let last = 0

/** A number that no other object has. */
function numberOf(object: object): number {
  let number = numbers.get(object)
  if (!number) numbers.set(object, (number = ++last))
  return number
}
