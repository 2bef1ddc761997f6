// The operations of the graph, which the wasm lists.
import { Place } from '../../options/place.js'
import { core } from '../../wasm/core.js'

export interface Operation {
  name: string
  /** The number in the wasm. */
  number: number
  /** True if expressions have the operation as a method; constructors of vectors and matrices are functions only. */
  isMethod: boolean
  /** False for an operation that only GLSL source needs. */
  isListed: boolean
  /** True if the result is a condition: for comparisons and logical operations. */
  isCondition: boolean
  /** The call, for messages. */
  place: Place
}

let operations: ReadonlyMap<string, Operation> | undefined

/** Maps name → operation. The first call starts the wasm, which has the names. */
export const getOperations = (): ReadonlyMap<string, Operation> => (operations ??= readOperations())

function readOperations() {
  const instance = core.get()
  const flags = instance.operationFlags()
  return new Map(
    instance.operationNames().map((name, number) => {
      const isMethod = (flags[number]! & 1) !== 0
      const isListed = (flags[number]! & 2) !== 0
      const isCondition = conditions.has(name)
      return [name, { name, number, isMethod, isListed, isCondition, place: new Place(name) }]
    }),
  )
}

/** Returns the operation of a name, which must exist. */
export const operationNamed = (name: string): Operation => getOperations().get(name)!

const conditions = new Set(['lt', 'le', 'gt', 'ge', 'eq', 'ne', 'and', 'or', 'not'])
