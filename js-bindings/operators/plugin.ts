// A plugin for Vite, Rollup and webpack (in unplugin's shape of a Rollup plugin). It translates offset functions in place when a project
// is built, so that they can access the variables around them, and also the functions of the same module that they call.
import { parse } from 'acorn'
import MagicString from 'magic-string'
import { isChanging, setsLater } from './changing.js'
import { binderOf, definitionIn, pathTo } from './definitions.js'
import { needsOf, returnsArray } from './needs.js'
import { freeReferences } from './resolve.js'
import { namesBoundBy, walk } from './scopes.js'
import { unusedName } from './symbols.js'
import type { Translation } from './translate-expressions.js'
import { translateIn } from './translate.js'
import type { Tree } from './tree.js'

const calleeNames = new Set(['createWarp', 'compileWarp'])

/** The exports of warpjet that take offset functions. */
const exportsTakingOffsets = new Set(
  'createWarp compileWarp compile gen warp BabylonWarp Warp chain add blend mask inSpace'.split(
    ' ',
  ),
)

/**
 * Translates a module without changing its lines; returns `undefined` if it contains nothing to translate. Builds call this for each
 * module.
 */
export const translateModule = (code: string): string | undefined => translateCode(code)?.toString()

function translateCode(code: string): MagicString | undefined {
  if (!/\b(?:createWarp|compileWarp)\s*\(|['"]warpjet\b/.test(code)) return undefined
  let program: Tree
  try {
    program = parse(code, {
      ecmaVersion: 'latest',
      sourceType: 'module',
      allowHashBang: true,
    }) as Tree
  } catch {
    // JSX, or another language that a later step of the build parses.
    return undefined
  }
  const offsets = offsetsIn(program)
  if (offsets.length === 0) return undefined
  const free = new Set([...freeReferences(program).values()].flat())
  const translation: Translation = {
    isFree: (node) => free.has(node),
    aliases: aliasesOfMath(program),
    operatorsName: unusedName('warpjetOperators', code),
    readsHelpers: false,
  }
  const { operatorsName } = translation
  const runtime = unusedName('warpjetWithOperators', code)
  const helpers = helpersOf(program, offsets)
  const text = new MagicString(code)
  const pieces: [tree: Tree, translatePiece: () => void][] = [...helpers].map((helper) => [
    helper,
    () => translateIn(text, code, helper, translation),
  ])
  for (const { argument, tree } of offsets) {
    // The names of changing variables, which the offset reads only once: the runtime warns about them.
    const once = changingIn(program, tree, free)
    const end = once.length ? `, { once: ${JSON.stringify(once)} })` : ')'
    pieces.push([
      argument,
      () => {
        if (argument === tree) translateIn(text, code, tree, translation)
        text.prependRight(
          argument.start,
          argument === tree ? `${runtime}((${operatorsName}) => (` : `${runtime}(() => `,
        )
        text.appendLeft(argument.end, argument === tree ? `)${end}` : end)
      },
    ])
  }
  let translatedTo = 0
  for (const [tree, translatePiece] of pieces.sort(([a], [b]) => a.start - b.start)) {
    if (tree.start < translatedTo) continue
    translatePiece()
    translatedTo = tree.end
  }
  // Appended at the end, since the module may begin with "use client", and imports work from anywhere.
  const operatorsImport = helpers.size ? `operators as ${operatorsName}, ` : ''
  return text.append(
    `\nimport { ${operatorsImport}withOperators as ${runtime} } from 'warpjet/operators/runtime'\n`,
  )
}

/** A function that is passed to warpjet. `argument` is the function itself or its name, `tree` the function. */
interface Offset {
  argument: Tree
  tree: Tree
}

const isPlainFunction = ({ type, async, generator }: Tree) =>
  /Function/.test(type) && !async && !generator

function offsetsIn(program: Tree): Offset[] {
  const imported = importedFrom(program, /^warpjet(\/|$)/)
  const found: Offset[] = []
  const add = (argument: Tree) => {
    const tree = isPlainFunction(argument) ? argument : functionBy(program, argument)
    if (!tree || !isPlainFunction(tree) || found.some((each) => each.argument === argument)) return
    if (needsOf(tree) !== 'nothing' || returnsArray(tree)) found.push({ argument, tree })
  }
  walk(program, (node) => {
    if (!/^(Call|New)Expression$/.test(node.type)) return
    const { callee } = node
    const values = node.arguments as Tree[]
    const name: string | undefined = callee.name ?? callee.property?.name
    const takesOffset =
      imported.has(callee.name) ||
      (imported.has(callee.object?.name) && exportsTakingOffsets.has(name ?? ''))
    if (calleeNames.has(name ?? '') || takesOffset) values.forEach(add)
    // JSX is compiled to jsx(Warp, { offset: … }).
    if (imported.has(values[0]?.name ?? '') && values[1]?.type === 'ObjectExpression')
      for (const { key, value } of values[1].properties) if (key?.name === 'offset') add(value)
  })
  return found
}

function importedFrom(program: Tree, from: RegExp): Set<string> {
  const names = new Set<string>()
  for (const { type, source, specifiers } of program.body as Tree[])
    if (type === 'ImportDeclaration' && from.test(source.value))
      for (const { local, imported } of specifiers)
        if (!imported || exportsTakingOffsets.has(imported.name)) names.add(local.name)
  return names
}

/** Returns the names bound by declarations such as `const { sin, cos } = Math` and `const s = Math.sin`. */
function aliasesOfMath(program: Tree): Set<string> {
  const names = new Set<string>()
  walk(program, ({ type, id, init }) => {
    if (type === 'VariableDeclarator' && (init?.name ?? init?.object?.name) === 'Math')
      for (const name of namesBoundBy(id)) names.add(name)
  })
  return names
}

/** Returns the function of this module that an identifier names. */
function functionBy(program: Tree, { type, name, start, end }: Tree): Tree | undefined {
  if (type !== 'Identifier') return undefined
  const binder = binderOf(pathTo({ program, start, end }), name)
  return binder && definitionIn(binder, name)
}

/** Returns the functions and methods of this module that offset functions call, directly or indirectly. */
function helpersOf(program: Tree, offsets: Offset[]): Set<Tree> {
  const helpers = new Set<Tree>()
  const isInside = ({ start, end }: Tree) =>
    offsets.some(
      ({ argument, tree }) => argument === tree && start >= tree.start && end <= tree.end,
    )
  const add = (tree: Tree | undefined) => {
    if (!tree || !isPlainFunction(tree) || helpers.has(tree) || isInside(tree)) return
    if (needsOf(tree, { isHelper: true }) !== 'nothing') helpers.add(tree)
    visit(tree)
  }
  const seen = new Set<Tree>()
  const visit = (tree: Tree) => {
    if (seen.has(tree)) return
    seen.add(tree)
    for (const nodes of freeReferences(tree).values())
      for (const node of nodes) add(functionBy(program, node))
    walk(tree, (node) => {
      if (!/^(Call|New)Expression$/.test(node.type)) return
      const { property, computed } = node.callee
      if (property?.name && !computed) methodsNamed(program, property.name).forEach(add)
      if (node.type === 'NewExpression') methodsNamed(program, 'constructor').forEach(add)
    })
  }
  for (const { argument, tree } of offsets) {
    if (argument === tree) visit(tree)
    else add(tree)
  }
  return helpers
}

/** Returns the methods named `name` in all classes and objects of a module. */
function methodsNamed(program: Tree, name: string): Tree[] {
  const found: Tree[] = []
  walk(program, ({ type, key, value, computed, kind }) => {
    if (!/^(MethodDefinition|Property|PropertyDefinition)$/.test(type) || computed) return
    if (key.name === name && /Function/.test(value?.type ?? '') && !/^(get|set)$/.test(kind))
      found.push(value)
  })
  return found
}

/** Returns the names that a function reads once although their values change. */
function changingIn(program: Tree, tree: Tree, free: ReadonlySet<Tree>): string[] {
  const names = new Set<string>()
  for (const [name, nodes] of freeReferences(tree))
    for (const node of nodes) {
      if (isChanging(node.member ?? '')) names.add(`${name}.${node.member}`)
      if (
        free.has(node) ? isChanging(name) : isVariableOf(program, name) && setsLater(program, name)
      )
        names.add(name)
    }
  return [...names]
}

/** Returns whether the module declares `name` at its top level, and not as a constant. */
const isVariableOf = (program: Tree, name: string): boolean =>
  program.body.some(
    ({ type, kind, declarations }: Tree) =>
      type === 'VariableDeclaration' &&
      kind !== 'const' &&
      declarations.some(({ id }: Tree) => id.name === name),
  )

/** The plugin for Vite and Rollup: `plugins: [operators()]`. */
export const operators = () => ({
  name: 'warpjet-operators',
  transform(code: string, id: string) {
    if (!/\.(?:[cm]?[jt]sx?|vue|svelte)(?:\?|$)/.test(id) || /\/node_modules\//.test(id))
      return null
    const text = translateCode(code)
    if (!text) return null
    return { code: text.toString(), map: mapOf(text, id) }
  },
})

const mapOf = (text: MagicString, source: string) =>
  text.generateMap({ source, includeContent: true, hires: 'boundary' })

/** The part of webpack's loader context that we need. */
interface LoaderContext {
  resourcePath: string
  callback(error: null, code: string, map?: object): void
}

/** The loader for webpack: `module: { rules: [{ test: /\.js$/, use: 'warpjet/operators/plugin' }] }`. */
export default function loader(this: LoaderContext, code: string) {
  const text = translateCode(code)
  if (text) this.callback(null, text.toString(), mapOf(text, this.resourcePath))
  else this.callback(null, code)
}
