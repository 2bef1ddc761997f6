// What was meant by a name that is not there.
import { WarpError } from './errors.js'

/** The fewest letters to put in, take out, change or swap with the next. */
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

/** The name among `names` that is nearest to `name`, if any is near. */
export function nearest(name: string, names: Iterable<string>): string | undefined {
  const word = name.toLowerCase()
  let found: string | undefined
  let least = Math.max(1, Math.floor(name.length / 3)) + 0.5
  for (const each of names) {
    const known = each.toLowerCase()
    const isPart =
      word.length > 2 && known.length > 2 && (word.startsWith(known) || known.startsWith(word))
    const far = Math.min(distance(word, known), isPart ? 1.2 : Infinity)
    if (far < least) [found, least] = [each, far]
  }
  return found
}

/** Asked for by JavaScript, promises, consoles, frameworks and tests, of whatever object they meet. */
const asked = new Set([
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

/**
 * The end of a chain of prototypes: asked for a name that no object before it has, throws a `WarpError`, which `refuse` words.
 */
export const refusing = (refuse: (name: string, object: object) => string): object =>
  new Proxy(
    {},
    {
      get(target, name, receiver) {
        if (typeof name === 'symbol' || name in target || asked.has(name) || /^\d+$|^_/.test(name))
          return Reflect.get(target, name, receiver)
        throw new WarpError(refuse(name, receiver as object))
      },
    },
  )

/** `meant`: words of other trades, with what is meant here. */
export function didYouMean(
  name: string,
  names: Iterable<string>,
  otherwise: string,
  meant: Readonly<Record<string, string>> = {},
) {
  const near = Object.hasOwn(meant, name) ? meant[name] : nearest(name, names)
  return near ? `did you mean ${near}?` : otherwise
}
