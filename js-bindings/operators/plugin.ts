// For Vite, Rollup and webpack (by unplugin's shape of a Rollup plugin): offset functions are translated when a project is built,
// where they stand, so that they see the variables around them.
import { parse } from 'acorn'
import { declaredIn, walk } from './scopes.js'
import { operatorsName, translate } from './translate.js'
import type { Tree } from './tree.js'

const callees = new Set(['createWarp', 'compileWarp'])
const runtime = 'warpjetWithOperators'

/** What a build calls for each module; `code` with its lines where they were, or nothing if there is nothing to translate. */
export function translateModule(code: string): string | undefined {
  if (!/\b(?:createWarp|compileWarp)\s*\(/.test(code)) return undefined
  const tree = parse(code, { ecmaVersion: 'latest', sourceType: 'module' }) as Tree
  const own = declaredIn(tree)
  const found: Tree[] = []
  walk(tree, (node) => {
    if (node.type !== 'CallExpression') return
    const { callee } = node
    if (!callees.has(callee.name ?? callee.property?.name)) return
    const offset = node.arguments.find(({ type }: Tree) => /Function/.test(type))
    if (offset && !offset.async) found.push(offset)
  })
  if (found.length === 0) return undefined
  let result = ''
  let at = 0
  for (const offset of found.sort((a, b) => a.start - b.start)) {
    if (offset.start < at) continue
    const text = translate(code, offset, (name) => own.has(name))
    result += `${code.slice(at, offset.start)}${runtime}((${operatorsName}) => (${text}))`
    at = offset.end
  }
  // At the end, since imports count from anywhere, and what is first may be "use client".
  return `${result}${code.slice(at)}\nimport { withOperators as ${runtime} } from 'warpjet/operators/runtime'\n`
}

/** `plugins: [operators()]` in a configuration of Vite or Rollup. */
export const operators = () => ({
  name: 'warpjet-operators',
  transform(code: string, id: string) {
    if (!/\.(?:[cm]?[jt]sx?|vue|svelte)(?:\?|$)/.test(id) || /\/node_modules\//.test(id))
      return null
    const translated = translateModule(code)
    // Lines stay where they are.
    return translated === undefined ? null : { code: translated, map: null }
  },
})

/** A loader of webpack: `module: { rules: [{ test: /\.js$/, use: 'warpjet/operators/plugin' }] }`. */
export default function loader(code: string): string {
  return translateModule(code) ?? code
}
