// The operations of the graph, as the wasm lists them.
import { Place } from '../../options/place.js'
import { getCore } from '../../wasm/core.js'

export interface Operation {
  name: string
  /** Its number in the wasm. */
  number: number
  /** Vectors and matrices are made by functions only. */
  isMethod: boolean
  /** `false` for what only shader text calls. */
  isListed: boolean
  /** Its calls, for messages. */
  place: Place
}

let operations: ReadonlyMap<string, Operation> | undefined

/** Maps name → operation. The names are in the wasm, which so starts with the first warp. */
export const getOperations = (): ReadonlyMap<string, Operation> =>
  (operations ??= new Map(
    getCore()
      .operationNames()
      .split(' ')
      .map((word, number) => {
        const name = word.replace(/[+-]/, '')
        const isMethod = name === word
        return [name, { name, number, isMethod, isListed: word[0] !== '-', place: new Place(name) }]
      }),
  ))

/** The number of the operation of that name. */
export const operationNumber = (name: string): number => getOperations().get(name)!.number
