/** Finds out whether the arrays of a divided mesh have changed. */
import type { Mesh } from 'three'
import { versionOf } from '../attribute.js'
import { fillOf } from '../surface.js'
import type { ThreeWarp } from '../three-warp.js'
import { isOfInstances } from './base.js'

/** Returns numbers that change when the arrays of the base change. */
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

/** Returns the number of an object, which no other object has. */
function numberOf(object: object): number {
  let number = numbers.get(object)
  if (!number) numbers.set(object, (number = ++last))
  return number
}
