// Shrinks a failing expression: removes everything that is not needed for it to fail.
import { inputNode, inputs, nodesOf, number } from './ast.js'
import { chained } from './plain.js'
import { isCondition, isMatrix } from './shapes.js'

/** Returns `root` with one node replaced by another. */
function replaceNode(root, from, to) {
  if (root === from) return to
  const args = root.args.map((argument) => replaceNode(argument, from, to))
  return args.every((argument, i) => argument === root.args[i]) ? root : { ...root, args }
}

/** Returns the complexity of an expression, a sum over its nodes. Inputs count less than operations, and constants by their digits. */
function weight(root) {
  let sum = 0
  for (const { op, value, raw } of nodesOf(root)) {
    if (op === 'number') sum += 1 + String(value).length / 10 + (raw ? 0 : 0.05)
    else sum += op === 'input' ? 1.5 : 4
  }
  return sum
}

const constants = [0, 1, 2, -1]

/** Numbers may replace vectors; an operation that does not accept them throws, and the candidate is dropped. */
const mayBeNumber = ({ shape }) => !isMatrix(shape) && !isCondition(shape)

/** Returns possible replacements of a node. */
function* replacementsOf(node, isRoot) {
  const isReplacement = ({ shape }) =>
    isRoot
      ? !shape.startsWith('bvec')
      : shape === node.shape || (shape === 'float' && mayBeNumber(node))
  for (const below of nodesOf(node)) if (below !== node && isReplacement(below)) yield below
  for (const input of inputs) if (input.shape === node.shape) yield inputNode(input)
  if (mayBeNumber(node)) for (const value of constants) yield number(value)
  if (node.op === 'number')
    for (const digits of [0, 1]) yield number(Number(node.value.toFixed(digits)))
  if (chained.has(node.op) && node.args.length > 2)
    for (let i = 0; i < node.args.length; i++) yield { ...node, args: node.args.toSpliced(i, 1) }
}

const isSame = (a, b) => a?.kind === b.kind && stem(a.message) === stem(b.message)
/** Returns an error's message without the parts that differ between cases. */
const stem = (message = '') => message.replace(/".*?"|[-\d.]+|\w+\(.*/gs, '').slice(0, 60)

/**
 * Returns the smallest case it finds that fails in the same way, as { test, failure }. `check(test)` returns the failure, if any,
 * or a promise of it.
 */
export async function shrink(test, failure, check) {
  let best = { test, failure }
  const tried = new Set()
  for (let isSmaller = true; isSmaller;) {
    isSmaller = false
    search: for (const node of nodesOf(best.test.root))
      for (const candidate of replacementsOf(node, node === best.test.root)) {
        const root = replaceNode(best.test.root, node, candidate)
        const key = JSON.stringify(root)
        if (weight(root) >= weight(best.test.root) || tried.has(key)) continue
        tried.add(key)
        const newFailure = await attempt(check, { ...best.test, root })
        if (!isSame(newFailure, failure)) continue
        best = { test: { ...best.test, root }, failure: newFailure }
        isSmaller = true
        break search
      }
  }
  return best
}

/** Checks a candidate. An invalid one, such as a cross product of numbers, throws, which is not a failure of the compiler. */
async function attempt(check, test) {
  try {
    return await check(test)
  } catch {
    return undefined
  }
}

/** Formats a list of numbers, with a question mark for each that is too uncertain to compare. */
const formatNumbers = (list) => `[${list.map((x) => x ?? '?').join(', ')}]`

/** Formats a failure for the reader of a test's report. */
export function describe({ test, failure }) {
  const { kind, message, point, result, got, expected, source } = failure
  const lines = [`seed ${test.seed}: ${kind} ${result?.text ?? ''}`, source]
  if (message) lines.push(message)
  if (point) {
    const readInputs = Object.entries(point).filter(([name]) => source.includes(`'${name}'`))
    const values = readInputs.map(([name, value]) => `${name} = ${formatNumbers(value)}`)
    lines.push(`at ${values.join(', ')}`)
    lines.push(`expected ${formatNumbers(expected)}`, `but got  ${formatNumbers(got)}`)
  }
  return lines.join('\n')
}
