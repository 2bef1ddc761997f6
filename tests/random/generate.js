// Generates random well-typed expressions, the same ones for the same seed. Each node is evaluated when it is made, at the points
// of the test: values that leave the domain of the operation, or grow too large, are wrapped in an operation that limits them.
import { seededRandom } from '../warps/random.js'
import { depthOf, inputNode, inputs, node, number } from './ast.js'
import { signaturesFor } from './operations.js'
import { isMatrix, matrixShapes, sizeOf, vectorShapes } from './shapes.js'
import { createTamer } from './tame.js'

/** The number of consecutive seeds that have the same points, so that they can share a shader. */
export const blockSize = 40
export const pointCount = 6

const maxDepth = 12
/**
 * The shapes of results, by frequency: matrices are seldom the result, since they have many numbers, but frequent inside of expressions.
 */
const rootShapes = [
  ...Array(6).fill('float'),
  ...Array(4).fill(vectorShapes).flat(),
  ...matrixShapes,
  'bool',
]

/** Returns a random generator. Mixes the seeds, since Park and Miller's generator starts with similar numbers for neighbouring seeds. */
export function randomOf(seed) {
  const random = seededRandom(((seed + 1) * 7919 * 65537) % 2147483647)
  for (let i = 0; i < 5; i++) random()
  return random
}

/**
 * Returns the points of a block of seeds: values of every input, from -2 to 2, as float32 numbers. Those of the last point are
 * mostly at kinks and jumps.
 */
export function pointsOf(seed) {
  const random = randomOf(1e6 + Math.floor(seed / blockSize))
  const anywhere = () => Math.fround(4 * random() - 2)
  const special = () => [-1, -0.5, 0, 0, 1, 2, anywhere()][Math.floor(7 * random())]
  const point = (pick) =>
    Object.fromEntries(
      inputs.map(({ name, shape }) => [name, Array.from({ length: sizeOf(shape) }, pick)]),
    )
  return Array.from({ length: pointCount }, (_, i) =>
    point(i < pointCount - 1 ? anywhere : special),
  )
}

/** Returns a constant with few digits. */
function randomConstant(random) {
  const kind = random()
  const value = 6 * random() - 3
  if (kind < 0.4) return Math.round(value) || 0
  return Number(value.toFixed(kind < 0.6 ? 1 : 3))
}

/**
 * Returns the case of a seed, { seed, points, root }. `allowed(name)` may exclude operations. Without `isTame`, operations get
 * any operands, also outside their domains.
 */
export function randomCase(seed, allowed = () => true, isTame = true) {
  const random = randomOf(seed)
  const points = pointsOf(seed)
  const pick = (list) => list[Math.floor(list.length * random())]
  const form = () => ({ form: random() < 0.6 ? 'method' : 'builder' })
  const make = (op, shape, args, more) => node(op, shape, args, { ...form(), ...more })
  const tame = isTame ? createTamer({ points, random, make, allowed }) : (node) => node

  function pickSignature(shape) {
    const signatures = signaturesFor(shape).filter(({ op }) => allowed(op))
    let place = random() * signatures.reduce((sum, { weight }) => sum + weight, 0)
    return signatures.find(({ weight }) => (place -= weight) < 0)
  }

  /** Returns an input, a part of one, or a constant, as an expression of `shape`. */
  function leaf(shape, mayBeConstant) {
    if (shape === 'float' && mayBeConstant && random() < 0.4)
      return number(randomConstant(random), random() < 0.8)
    const input = pick(inputs.filter((input) => input.shape === shape))
    if (shape === 'float' && random() < 0.4) return swizzle(leaf(pick(vectorShapes)), shape)
    if (shape === 'float') return inputNode(input)
    if (!isMatrix(shape) && mayBeConstant && random() < 0.2)
      return make(
        shape,
        shape,
        Array.from({ length: sizeOf(shape) }, () => number(randomConstant(random))),
      )
    return inputNode(input)
  }

  function swizzle(argument, shape) {
    const letters = pick(['xyzw', 'xyzw', 'rgba', 'stpq']).slice(0, argument.size)
    const selectedLetters = Array.from({ length: sizeOf(shape) }, () => pick([...letters])).join('')
    return node('swizzle', shape, [argument], { letters: selectedLetters })
  }

  /** Side branches are mostly short, so that a deep expression is a long chain rather than a wide tree. */
  const sideDepth = (depth) => Math.min(depth, random() < 0.6 ? 0 : random() < 0.7 ? 1 : 3)

  /** Returns an expression of `shape` with `depth` nested operations. */
  function grow(shape, depth, mayBeConstant) {
    const isCondition = shape.startsWith('b')
    if (depth <= 0 && !isCondition) return leaf(shape, mayBeConstant)
    const { op, broadcasts, chained, exponent, indexed, ...row } = pickSignature(shape)
    const parameters = [...row.arguments]
    if (chained) while (parameters.length < 4 && random() < 0.2) parameters.push(parameters.at(-1))
    const main = Math.floor(random() * parameters.length)
    // Several numbers after a vector are its components, as in v.sub(x, y, z).
    const areComponents = parameters.length > 2 && /^(add|sub|mult|div)$/.test(op)
    const args = parameters.map(({ shape, domain }, i) => {
      const isNumber = broadcasts && i !== main && random() < 0.4 && !areComponents
      const argument = grow(
        isNumber ? 'float' : shape,
        i === main ? depth - 1 : sideDepth(depth - 1),
        i !== main,
      )
      return tame(argument, domain)
    })
    if (exponent) args.push(number(pick([-3, -2, -1, 0, 1, 2, 2, 3, 3, 4, 5])))
    if (op === 'swizzle') return tame(swizzle(args[0], shape), 'any')
    const more = indexed ? { index: Math.floor(random() * sizeOf(shape)) } : {}
    if (/^(rotate|vec\d|mat\d)/.test(op)) more.form = 'builder'
    return tame(make(op, shape, args, more), 'any')
  }

  const shape = pick(rootShapes)
  let root
  do root = grow(shape, 1 + Math.floor(random() * maxDepth), false)
  while (depthOf(root) > maxDepth + 1)
  return { seed, points, root }
}
