// Reads a function's text and makes it anew, with operators that work on expressions.
import { parse } from 'acorn'
import { isCallable } from '../checks/options.js'
import { WarpError } from '../checks/errors.js'
import type { OffsetFunction, WarpInputs } from '../types/types.js'
import { type Operators, translated, withOperators } from './runtime.js'
import { declaredIn, freeIn } from './scopes.js'
import { operatorsName, translate } from './translate.js'
import type { Tree } from './tree.js'

/** Values that a text may read by name, since it cannot see the variables around it. */
export type Scope = Readonly<Record<string, unknown>>

let count = 0

/** Whether a text can read a variable of that name: `let` at the top of a script is no property of the page. */
const isSeen = (name: string) =>
  name in globalThis || new Function(`return typeof ${name}`)() !== 'undefined'

/** The function, or what an object has as a method, of which JavaScript gives the text. */
function parsed(text: string): { source: string; tree: Tree } | undefined {
  for (const [before, after] of [
    ['(', ')'],
    ['({ ', ' }).offset'],
  ]) {
    const source = before + text + after
    try {
      const [statement] = parse(source, { ecmaVersion: 'latest' }).body
      const { expression } = statement as unknown as Tree
      const tree: Tree = before === '(' ? expression : expression.object.properties[0].value
      if (/Function/.test(tree.type) && !tree.async && !tree.generator) return { source, tree }
    } catch {
      // Native code, or a method.
    }
  }
  return undefined
}

/**
 * An offset function whose text may use `+ - * / % **`, comparisons, `&& || !`, `?:`, `if`, `+=`, `Math.sin(x)` and `[x, y, z]` on
 * expressions. Its text is read and made anew, so that it sees global variables and `scope`, but no others around it: a function
 * that needs others stays as it is, and says so where it uses an operator. Throws a `WarpError` if no function comes.
 */
export function operators(offset: OffsetFunction, scope: Scope = {}): OffsetFunction {
  if (!isCallable(offset))
    throw new WarpError(
      'operators: a function was expected, as in operators(({ position }) => position * 2).',
    )
  if (translated.has(offset)) return offset
  const read = parsed(Function.prototype.toString.call(offset))
  if (!read) return offset
  const { source, tree } = read
  const missing = [...freeIn(tree)].filter((name) => !Object.hasOwn(scope, name) && !isSeen(name))
  const result = missing.length ? sayingSo(offset, missing) : remade(source, tree, scope)
  translated.add(result)
  return result
}

function remade(source: string, tree: Tree, scope: Scope): OffsetFunction {
  const own = declaredIn(tree)
  const text = translate(source, tree, (name) => own.has(name) || Object.hasOwn(scope, name))
  const names = Object.keys(scope)
  const code = `return (${operatorsName}) => (${text})\n//# sourceURL=warpjet-operators-${++count}.js`
  const make = new Function(...names, code)(...Object.values(scope)) as (
    operators: Operators,
  ) => (inputs: WarpInputs) => unknown
  return withOperators(make)
}

/** Sentences that an operator on an expression brings about. */
const isOfOperator = (error: unknown): error is Error =>
  error instanceof Error &&
  error.name === 'WarpError' &&
  /^JavaScript's own|works on numbers, not on expressions/.test(error.message)

const sayingSo =
  (offset: OffsetFunction, [name, ...others]: string[]): OffsetFunction =>
  (inputs) => {
    try {
      return offset(inputs)
    } catch (error) {
      if (!isOfOperator(error)) throw error
      throw new WarpError(
        `createWarp: operators are read from the function's text, which cannot see "${name}" of the sketch around it; make ${others.length ? `it and ${others.join(', ')}` : 'it'} global, or add the option { scope: { ${[name, ...others].join(', ')} } }.`,
      )
    }
  }
