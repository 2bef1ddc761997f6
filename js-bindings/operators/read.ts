// Reads a function's source code and compiles it again, with operators that work on expressions.
import type { OffsetFunction, WarpInputs } from '../core/types/types.js'
import { isLibraryFunction, type TranslationOptions } from '../errors/operators.js'
import { callable, record } from '../options/kinds.js'
import { Place } from '../options/place.js'
import type { TranslationResult } from './calls.js'
import { noteChanging } from './changing.js'
import { hasFormula } from './functions.js'
import { globalExists, isSurelyGlobal } from './globals.js'
import { describeInvisible, describeMissingThis, withOperatorMessage } from './messages.js'
import { needsOf, returnsArray } from './needs.js'
import { parseFunction } from './parse.js'
import { freeReferences, type References } from './resolve.js'
import {
  asVector,
  glslOf,
  operatorsOf,
  translated,
  withOperators,
  type Operators,
} from './runtime.js'
import { surroundingsOf, type Definition, type Surroundings } from './surroundings.js'
import { unusedName } from './symbols.js'
import { translate } from './translate.js'
import type { Tree } from './tree.js'

/** Values that a translated function may read by name, since it cannot access the variables around it. */
export type Scope = Readonly<Record<string, unknown>>

interface TranslationContext {
  /** The call that the function was passed to. */
  place: Place
  scope: Scope
  sketch: object | undefined
  /** Source code of the functions that are being translated. A call to one of them is recursive. */
  pending: Set<string>
}

const operatorsPlace = new Place('operators')
const functionKind = callable('a function, as in operators(({ position }) => position * 2),')
const scopeKind = record<Scope>('an object of variables by name, as in { amount },')

let count = 0

/**
 * Translates an offset function that uses `+ - * / % **`, comparisons, `&& || !`, `?:`, `if`, `+=`, `Math.sin(x)` and `[x, y, z]` on
 * expressions, or calls other functions of the sketch that do. The result is compiled from the source code, so it can access global
 * variables and `scope`, but no other variables around the function. A function that needs other variables is returned untranslated, and
 * throws where it uses an operator. A function with nothing to translate is returned as is. Throws a `WarpError` if `offset` is not a
 * function or `scope` is not an object.
 */
export function operators(
  offset: OffsetFunction,
  scope: Scope = {},
  { method = 'createWarp', sketch }: TranslationOptions = {},
): OffsetFunction {
  functionKind.read(offset, operatorsPlace)
  rejectInvalidNames(scopeKind.read(scope, operatorsPlace.part('the scope')))
  if (translated.has(offset) || isLibraryFunction(offset)) return offset
  const context = { place: new Place(method), scope, sketch, pending: new Set<string>() }
  const parsed = parseFunction(offset)
  if (!parsed) return offset
  const needs = needsOf(parsed.tree)
  const isVector = returnsArray(parsed.tree)
  if (needs === 'nothing' && !isVector) return offset
  const translation = needs === 'nothing' ? undefined : read(offset, context)
  const result =
    translation && 'make' in translation
      ? withOperators(
          translation.make as (operators: Operators) => (inputs: WarpInputs) => unknown,
          {
            readHelper: (helper, name) => readHelper(helper, name, context),
            testsExistence: needs === 'logic' && !isVector,
            check: makeThisCheck(parsed.tree, context.place),
          },
        )
      : keepUntranslated(translation ? withOperatorMessage(offset, translation.explain) : offset)
  translated.add(result)
  return result
}

function rejectInvalidNames(scope: Scope) {
  const invalid = Object.keys(scope).find((name) => !isVariableName(name))
  if (invalid !== undefined)
    throw operatorsPlace.error(
      `expected variable names as keys of the scope, as in { amount }, got "${invalid}".`,
    )
}

/** Returns a function that calls the untranslated one, and converts a result `[x, y, z]` to a vector. */
const keepUntranslated = (offset: OffsetFunction): OffsetFunction =>
  function (this: unknown, inputs: WarpInputs) {
    const result: unknown = Reflect.apply(offset, this, [inputs])
    return asVector(operatorsOf(glslOf(inputs)), inputs, result)
  }

function isVariableName(name: string): boolean {
  if (!/^[\p{ID_Start}$_][\p{ID_Continue}$\u200c\u200d]*$/u.test(name)) return false
  try {
    new Function(name, `'use strict'`)
    return true
  } catch (error) {
    // On a page that forbids `new Function` the name cannot be checked.
    return !(error instanceof SyntaxError)
  }
}

/** Reads a function or class that is called with expressions. Returns `undefined` if it has nothing to translate, or is not the sketch's. */
function readHelper(
  helper: Function,
  name: string,
  context: TranslationContext,
): TranslationResult | undefined {
  const parsed = parseFunction(helper)
  return parsed && needsOf(parsed.tree, { isHelper: true }) !== 'nothing'
    ? read(helper, context, name)
    : undefined
}

/** Reads a function together with its surroundings in the script. */
function read(f: Function, context: TranslationContext, helper?: string): TranslationResult {
  const parsed = parseFunction(f)!
  const text = parsed.source.slice(parsed.start, parsed.start + parsed.length)
  return readSource({ ...parsed, text }, surroundingsOf(text), context, helper)
}

interface FunctionSource {
  text: string
  source: string
  tree: Tree
}

function readSource(
  { source, tree }: FunctionSource,
  surroundings: Surroundings,
  context: TranslationContext,
  helper: string | undefined,
): TranslationResult {
  const { place, scope, sketch } = context
  const references = freeReferences(tree)
  const values = new Map<string, (operators: Operators) => unknown>()
  const missing: string[] = []
  for (const [name, nodes] of references) {
    if (Object.hasOwn(scope, name)) values.set(name, () => scope[name])
    else if (name === surroundings.sketchName && sketch) values.set(name, () => sketch)
    else if (!isVisible(name, nodes, surroundings, tree)) {
      const definition = surroundings.functionOf(name)
      const translation = definition && readDefinition(definition, context, name)
      if (translation && 'make' in translation) values.set(name, translation.make)
      else missing.push(name)
    }
  }
  if (missing.length)
    return {
      explain: () =>
        describeInvisible({
          place,
          names: missing,
          shadowed: new Set(missing.filter((name) => globalExists(name))),
          members: membersOfThis(references),
          ...(helper && { helper }),
        }),
    }
  const free = new Set([...references.values()].flat())
  const operatorsName = unusedName('warpjetOperators', source)
  const code = translate(source, tree, {
    isFree: (node) => free.has(node),
    operatorsName,
    readsHelpers: true,
  })
  const names = [...values.keys()]
  // The node of a method starts at its parameter list, after the name.
  const isMethod = tree.type === 'FunctionExpression' && source[tree.start] === '('
  const strict = surroundings.isStrict ? "'use strict'; " : ''
  let factory: Function
  try {
    factory = new Function(
      operatorsName,
      ...names,
      `${strict}return (${isMethod ? 'function ' : ''}${code})\n//# sourceURL=warpjet-operators-${++count}.js`,
    )
  } catch (error) {
    const why =
      error instanceof SyntaxError
        ? `operators cannot be translated in the function's source code: ${error.message}; write x.add(1), x.mult(2), x.sin() in it`
        : "operators are translated in the function's source code, which this page's Content-Security-Policy forbids. Allow 'unsafe-eval' in it, or translate the functions at build time, with warpjet/operators/plugin"
    return { explain: () => `${place}: ${why}.` }
  }
  noteChanging(references, values, surroundings, place)
  return {
    make: (operators: Operators) =>
      factory(operators, ...names.map((name) => values.get(name)!(operators))),
  }
}

/** Reads a function that was found in the script by its name; `undefined` if it is being read already. */
function readDefinition(definition: Definition, context: TranslationContext, name: string) {
  const { pending } = context
  if (pending.has(definition.text)) return undefined
  pending.add(definition.text)
  const translation = readSource(definition, definition.surroundings, context, name)
  pending.delete(definition.text)
  return translation
}

/** Returns whether the translated function and the original read the same variable by that name. */
function isVisible(name: string, nodes: Tree[], surroundings: Surroundings, tree: Tree): boolean {
  if (/^(this|super|new\.target|arguments|#.*)$/.test(name)) return false
  if (surroundings.bound) return !surroundings.bound.has(name)
  // Calls of sin, lerp and the like are translated by name, so these functions need not exist on the page.
  if (hasFormula(name) && !globalExists(name)) return true
  return isSurelyGlobal(name, nodes.every(isCalledIn(tree)))
}

/** Returns a function that checks whether a node is the callee of a call in the tree. */
const isCalledIn = (tree: Tree) => {
  const callees = new Set<Tree>()
  const visit = (node: Tree) => {
    if (node.type === 'CallExpression') callees.add(node.callee)
    for (const child of Object.values(node).flat())
      if (child && typeof child === 'object' && typeof child.type === 'string') visit(child as Tree)
  }
  visit(tree)
  return (node: Tree) => callees.has(node)
}

/** Returns a function that checks the `this` of a call: a method that was passed without its object has none, and would read `undefined`. */
function makeThisCheck(tree: Tree, place: Place): (self: unknown) => void {
  const members =
    tree.type === 'ArrowFunctionExpression' ? [] : membersOfThis(freeReferences(tree.body as Tree))
  return (self) => {
    if (self !== undefined && self !== globalThis) return
    const missing = members.find((member) => !(member in globalThis))
    if (missing) throw place.error(describeMissingThis(missing))
  }
}

/** Returns the properties of `this` that are read, for a message. */
const membersOfThis = (references: References): string[] => [
  ...new Set((references.get('this') ?? []).flatMap(({ member }) => member ?? [])),
]
