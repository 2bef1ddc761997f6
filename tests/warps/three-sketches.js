// The warps of the gallery's examples with three.js, extracted from their modules: runs only the definitions that each warp
// refers to.
import { readFileSync, readdirSync } from 'node:fs'
import { parse } from 'acorn'
import * as THREE from 'three'

const examples = new URL('../../examples/', import.meta.url)

/** Finds the first call of `warp` in each, as [{ name, warp, options }], which are its last two arguments. */
export const threeWarps = () =>
  readdirSync(examples)
    .filter((folder) => folder.startsWith('three-'))
    .sort()
    .map((name) => [name, readFileSync(new URL(`${name}/sketch.js`, examples), 'utf8')])
    // Others have exactNormals alone.
    .filter(([, source]) => /\bwarp\(/.test(source))
    .map(warpOf)

function warpOf([name, source]) {
  const { body } = parse(source, { ecmaVersion: 'latest', sourceType: 'module' })
  const textOf = ({ start, end }) => source.slice(start, end)
  const declared = new Map()
  for (const node of body) {
    if (node.type === 'FunctionDeclaration') declared.set(node.id.name, node)
    for (const { id, init } of node.declarations ?? [])
      if (id.type === 'Identifier') declared.set(id.name, init)
  }
  const known = { THREE }
  const surroundings = new Proxy(known, {
    has: (_, key) => key in known || declared.has(key),
    get: (_, key) => (key in known || !declared.has(key) ? known[key] : (known[key] = run(key))),
  })
  const evaluate = (text) =>
    new Function('surroundings', `with (surroundings) { return (${text}) }`)(surroundings)
  const run = (key) => evaluate(textOf(declared.get(key)))
  const [, offset, options] = declared.get('warped').arguments
  return { name, warp: evaluate(textOf(offset)), options: evaluate(textOf(options)) }
}
