// Describes what surrounds a function in its script.
import { binderOf, definitionIn, pathTo } from './definitions.js'
import { namesAround, type Place } from './resolve.js'
import { assignedIn, walk } from './scopes.js'
import { placesOf, programsWith } from './sources.js'
import type { Tree } from './tree.js'

export interface Surroundings {
  /** The names that are bound around the function and so are not globals; `undefined` if no script contains the function. */
  bound: ReadonlySet<string> | undefined
  isStrict: boolean
  /** The parameter through which an enclosing function gets the sketch from p5. */
  sketchName: string | undefined
  /** Returns the function that is bound to a name around this function and never reassigned. */
  functionOf(name: string): Definition | undefined
  /** Returns the scripts that may assign a variable of the page. */
  programs(name: string): Tree[]
}

export interface Definition {
  text: string
  source: string
  tree: Tree
  surroundings: Surroundings
}

const unknownSurroundings: Surroundings = {
  bound: undefined,
  isStrict: false,
  sketchName: undefined,
  functionOf: () => undefined,
  programs: (name) => programsWith(name, undefined),
}

/**
 * Describes the surroundings of a function with the given source code. If several functions of the page have the same code, a name
 * counts as bound if it is bound around one of them.
 */
export function surroundingsOf(text: string): Surroundings {
  const places = placesOf(text)
  if (!places.length) return unknownSurroundings
  const all = places.map(surroundingsAt)
  return all.length === 1
    ? all[0]!
    : {
        bound: new Set(all.flatMap(({ bound }) => [...bound!])),
        isStrict: all.every(({ isStrict }) => isStrict),
        sketchName: all.every(({ sketchName }) => sketchName === all[0]!.sketchName)
          ? all[0]!.sketchName
          : undefined,
        functionOf: () => undefined,
        programs: (name) => all.flatMap((each) => each.programs(name)),
      }
}

function surroundingsAt(place: Place): Surroundings {
  const path = pathTo(place)
  return {
    bound: namesAround(place),
    isStrict: place.isModule || path.some(isStrictIn),
    sketchName: sketchNameIn(place, path),
    functionOf: (name) => findFunction(place, path, name),
    programs: (name) => programsWith(name, place),
  }
}

const isStrictIn = (node: Tree): boolean =>
  /^Class/.test(node.type) ||
  [node.body?.body ?? node.body].flat().some((each?: Tree) => each?.directive === 'use strict')

/** Returns the parameter `p` of an enclosing `new p5((p) => …)`, which p5 calls with the sketch. */
function sketchNameIn({ program }: Place, path: Tree[]): string | undefined {
  let found: string | undefined
  walk(program, (node) => {
    if (node.type !== 'NewExpression') return
    if ((node.callee.name ?? node.callee.property?.name) !== 'p5') return
    const [argument] = node.arguments as Tree[]
    const sketch = argument?.type === 'Identifier' ? definitionIn(program, argument.name) : argument
    const [first] = sketch?.params ?? []
    if (first?.type !== 'Identifier' || !path.includes(sketch!)) return
    if (binderOf(path, first.name) === sketch && !assignedIn([sketch!.body]).has(first.name))
      found = first.name
  })
  return found
}

function findFunction(place: Place, path: Tree[], name: string): Definition | undefined {
  const binder = binderOf(path, name)
  const tree = binder && definitionIn(binder, name)
  if (!tree || tree.async || tree.generator) return undefined
  const { start, end } = tree
  const { text } = place
  // Reading a function that calls itself would never end.
  if (start <= place.start && end >= place.end) return undefined
  return {
    text: text.slice(start, end),
    source: text,
    tree,
    surroundings: surroundingsAt({ ...place, start, end }),
  }
}
