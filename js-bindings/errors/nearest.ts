// Suggestions for unknown names.
import { WarpError } from './errors.js'

/**
 * Returns the Damerau-Levenshtein distance: the min number of edits that turn a into b, each of which inserts, deletes or changes a letter,
 * or swaps two neighbours.
 */
function distance(a: string, b: string) {
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)]
  for (let i = 1; i <= a.length; i++) {
    const row = [i]
    for (let j = 1; j <= b.length; j++) {
      const isSame = a[i - 1] === b[j - 1]
      let best = Math.min(
        rows[i - 1]![j]! + 1,
        row[j - 1]! + 1,
        rows[i - 1]![j - 1]! + (isSame ? 0 : 1),
      )
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1])
        best = Math.min(best, rows[i - 2]![j - 2]! + 1)
      row.push(best)
    }
    rows.push(row)
  }
  return rows[a.length]![b.length]!
}

/** Returns the name among `names` that is nearest to `name`; `undefined` if none is near. */
export function nearest(name: string, names: Iterable<string>): string | undefined {
  const word = name.toLowerCase()
  let best: string | undefined
  let minDistance = Math.max(1, Math.floor(name.length / 3)) + 0.5
  for (const candidate of names) {
    const candidateWord = candidate.toLowerCase()
    const isPrefix =
      word.length > 2 &&
      candidateWord.length > 2 &&
      (word.startsWith(candidateWord) || candidateWord.startsWith(word))
    const wordDistance = Math.min(distance(word, candidateWord), isPrefix ? 1.2 : Infinity)
    if (wordDistance < minDistance) [best, minDistance] = [candidate, wordDistance]
  }
  return best
}

/** Properties that JavaScript, promises, consoles, frameworks and tests read from any object. */
const probedNames = new Set([
  'then',
  'toJSON',
  'constructor',
  'prototype',
  'toString',
  'valueOf',
  'nodeType',
  'tagName',
  'inspect',
  'asymmetricMatch',
  'splice',
  'isReady',
  'gifProperties',
  'setAlpha',
  '__proto__',
  '$$typeof',
])

/** Makes an object for the end of a prototype chain. Reading a name that no object of the chain has throws a `WarpError`. */
export const throwingPrototype = (message: (name: string, object: object) => string): object =>
  new Proxy(
    {},
    {
      get(target, name, receiver) {
        if (
          typeof name === 'symbol' ||
          name in target ||
          probedNames.has(name) ||
          /^\d+$|^_/.test(name)
        )
          return Reflect.get(target, name, receiver)
        throw new WarpError(message(name, receiver as object))
      },
    },
  )

/** Suggests the nearest name, or returns `otherwise` if none is near. `synonyms` maps names of other libraries → names of this one. */
export function didYouMean(
  name: string,
  names: Iterable<string>,
  otherwise: string,
  synonyms: Readonly<Record<string, string>> = {},
) {
  const suggestion = Object.hasOwn(synonyms, name) ? synonyms[name] : nearest(name, names)
  return suggestion ? `did you mean ${suggestion}?` : otherwise
}
