// Extracts the warps of the gallery's examples with three.js from their modules: runs only the definitions that each warp refers to.
import { readFileSync, readdirSync } from 'node:fs'
import { parse } from 'acorn'
import * as THREE from 'three'

const examples = new URL('../../examples/', import.meta.url)

/**
 * Returns the offset function and the options of `warped = warp(object, offset, options)` in each example, as [{ name, warp, options }].
 */
export const threeWarps = () =>
  readdirSync(examples)
    .filter((folder) => folder.startsWith('three-'))
    .sort()
    .map((name) => [name, readFileSync(new URL(`${name}/sketch.js`, examples), 'utf8')])
    // The other examples only use exactNormals.
    .filter(([, source]) => /\bwarp\(/.test(source))
    .map(warpOf)

function warpOf([name, source]) {
  const { body } = parse(source, { ecmaVersion: 'latest', sourceType: 'module' })
  const textOf = ({ start, end }) => source.slice(start, end)
  const declarations = new Map()
  for (const node of body) {
    if (node.type === 'FunctionDeclaration') declarations.set(node.id.name, node)
    for (const { id, init } of node.declarations ?? [])
      if (id.type === 'Identifier') declarations.set(id.name, init)
  }
  const values = { THREE }
  const scope = new Proxy(values, {
    has: (_, key) => key in values || declarations.has(key),
    get: (_, key) =>
      key in values || !declarations.has(key) ? values[key] : (values[key] = run(key)),
  })
  const evaluate = (text) => new Function('scope', `with (scope) { return (${text}) }`)(scope)
  const run = (key) => evaluate(textOf(declarations.get(key)))
  const [, offset, options] = declarations.get('warped').arguments
  return { name, warp: evaluate(textOf(offset)), options: evaluate(textOf(options)) }
}
