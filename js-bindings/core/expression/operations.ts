// The operations of the graph, as the wasm lists them.
import { Place } from '../../options/place.js'
import { core } from '../../wasm/core.js'

export interface Operation {
  name: string
  /** Its number in the wasm. */
  number: number
  /** Vectors and matrices are made by functions only. */
  isMethod: boolean
  /** `false` for what only shader text calls. */
  isListed: boolean
  /** Whether its result is a condition: that of a comparison, or of logic. */
  isCondition: boolean
  /** Its calls, for messages. */
  place: Place
}

let operations: ReadonlyMap<string, Operation> | undefined

/** Maps name → operation. The names are in the wasm, which so starts with the first warp. */
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

/** The operation of that name, which must exist. */
export const operationNamed = (name: string): Operation => getOperations().get(name)!

const conditions = new Set(['lt', 'le', 'gt', 'ge', 'eq', 'ne', 'and', 'or', 'not'])
