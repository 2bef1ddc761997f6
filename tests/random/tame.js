// Keeps random expressions within domains: computes their values at the points, and wraps them if necessary.
import { seededRandom } from '../warps/random.js'
import { number, node as plainNode } from './ast.js'
import { apply } from './plain.js'
import { isCondition } from './shapes.js'

/** Maps a domain → whether a number is in it, at some distance from its edges. */
const domains = {
  any: () => true,
  positive: (x) => x > 0.05,
  negative: (x) => x < -0.05,
  above1: (x) => x > 1.05,
  nonzero: (x) => Math.abs(x) > 0.2,
  unit: (x) => Math.abs(x) < 0.95,
  small: (x) => Math.abs(x) < 3,
}

/** Expressions with larger values or slopes are squashed. */
const maxValue = 20
const maxSlope = 12
const step = 1e-4

/** Returns a function that wraps an expression if its values are not moderate, or not in a domain. */
export function createTamer({ points, random, make, allowed }) {
  // Evaluates at each point, and at one nearby.
  const nearbyRandom = seededRandom(Math.floor(1e9 * random()) + 1)
  const nearby = points.map((point) =>
    Object.fromEntries(
      Object.entries(point).map(([name, value]) => [
        name,
        value.map((x) => x + step * (nearbyRandom() < 0.5 ? -1 : 1) * (0.5 + nearbyRandom())),
      ]),
    ),
  )
  const allPoints = [...points, ...nearby]
  const valueCache = new WeakMap()

  /** Returns the values of a node at all points, from those of its arguments. */
  function valuesOf(node) {
    if (!valueCache.has(node)) valueCache.set(node, compute(node))
    return valueCache.get(node)
  }
  function compute(node) {
    if (node.op === 'input') return allPoints.map((point) => point[node.name])
    if (node.op === 'number') return allPoints.map(() => [node.value])
    const lists = node.args.map(valuesOf)
    return allPoints.map((_, i) =>
      apply(
        node,
        lists.map((values) => values[i]),
      ),
    )
  }

  const constant = (low, high) => number(Number((low + (high - low) * random()).toFixed(2)))
  /** Calls one of the candidates whose operations are allowed. */
  function choose(...candidates) {
    const usable = candidates.filter(([names]) => names.split(' ').every(allowed))
    return usable[Math.floor(random() * usable.length)][1]()
  }
  const call = (op, first, ...others) => make(op, first.shape, [first, ...others])

  const wrappers = {
    positive: (x) =>
      choose(
        ['abs add', () => call('add', call('abs', x), constant(0.1, 1))],
        ['pow add', () => call('add', call('pow', x, number(2)), constant(0.1, 1))],
        ['sin exp', () => call('exp', call('sin', x))],
        ['cos add', () => call('add', call('cos', x), constant(1.2, 2))],
      ),
    negative: (x) => call('neg', wrappers.positive(x)),
    above1: (x) => call('add', wrappers.positive(x), number(1)),
    nonzero: (x) => call('add', wrappers.positive(x), constant(0.1, 0.5)),
    unit: (x) =>
      choose(
        ['sin mult', () => call('mult', call('sin', x), constant(0.3, 0.9))],
        ['tanh mult', () => call('mult', call('tanh', x), constant(0.3, 0.9))],
        ['abs add div', () => call('div', x, call('add', call('abs', x), constant(1.1, 2)))],
        ['atan mult', () => call('mult', call('atan', x), constant(0.3, 0.6))],
        ['clamp', () => call('clamp', x, constant(-0.9, -0.2), constant(0.2, 0.9))],
      ),
    small: (x) => call('mult', wrappers.unit(x), constant(1, 3)),
  }

  const isInDomain = (node, domain) => valuesOf(node).every((value) => value.every(domains[domain]))

  /** Returns whether a node has bounded values, and a moderate slope at half of the points or more. */
  function isModerate(node) {
    const values = valuesOf(node)
    if (!values.flat().every((x) => Math.abs(x) <= maxValue)) return false
    const steep = points.filter((_, i) =>
      values[i].some((x, k) => Math.abs(x - values[i + points.length][k]) > maxSlope * step),
    )
    return steep.length <= points.length / 2
  }

  /** Scales an expression down to values of about 1, or replaces it if it has no finite values. */
  function squash(node) {
    const size = Math.max(...valuesOf(node).flat().map(Math.abs))
    const factor = number(Number((1 / size).toPrecision(2)))
    if (!isFinite(size) || !(factor.value > 0)) return withoutNaN(node)
    return call('mult', node, factor)
  }
  /** Replaces an expression that has no finite values by constants. This is needed only if the domains above have a gap. */
  const withoutNaN = (node) => {
    if (node.shape === 'float') return constant(-1, 1)
    const parts = Array.from({ length: node.size }, () => constant(-1, 1))
    return plainNode(node.shape, node.shape, parts, { form: 'builder' })
  }

  const lengthsOf = (node) => valuesOf(node).map((value) => Math.hypot(...value))
  /** Returns the vector, or a moved one that is not near zero. */
  function direction(node) {
    if (lengthsOf(node).every((length) => length > 0.3)) return node
    const tries = [1, -1, 2, -2, 3, -3, 4, 5].map((shift) => call('add', node, number(shift)))
    return tries.find((moved) => lengthsOf(moved).every((length) => length > 0.3)) ?? tries.at(-1)
  }

  /** Makes a matrix that is dominated by its diagonal. */
  function invertible(node) {
    const scaled = call('mult', node, number(0.2))
    const { shape } = node
    const diagonal = plainNode(shape, shape, [constant(2, 3)], { form: 'builder' })
    const size = Math.max(...valuesOf(node).flat().map(Math.abs))
    const factor =
      size > 2 ? call('mult', scaled, number(Number((2 / size).toPrecision(2)))) : scaled
    return make('add', shape, [factor, diagonal])
  }

  return function tame(node, domain) {
    if (isCondition(node.shape)) return node
    let tamed = isModerate(node) ? node : squash(node)
    if (domain === 'direction') tamed = direction(tamed)
    else if (domain === 'invertible') tamed = invertible(tamed)
    else if (!isInDomain(tamed, domain)) tamed = wrappers[domain](tamed)
    return tamed
  }
}
