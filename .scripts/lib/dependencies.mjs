// The dependency rules of src and js-bindings. The ARCHITECTURE.md of each explains them; .dependency-cruiser.cjs has those of
// js-bindings.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname } from 'node:path/posix'
import { path, walk } from './files.mjs'
import { run } from './run.mjs'
import { Stop } from './terminal.mjs'

const read = (file) => readFileSync(path(file), 'utf8')

/** Lists the files that a C++ file includes, by their paths in `src`. */
const includesOf = (text) => [...text.matchAll(/^#include "([^"]+)"/gm)].map(([, file]) => file)

/** Finds a path from a node back to itself; `undefined` if there is none. `edges` maps each node → the nodes it points to. */
function circleIn(edges) {
  const done = new Set()
  const way = []
  const visit = (node) => {
    if (way.includes(node)) return [...way.slice(way.indexOf(node)), node]
    if (done.has(node)) return undefined
    done.add(node)
    way.push(node)
    for (const next of edges.get(node) ?? []) {
      const circle = visit(next)
      if (circle) return circle
    }
    way.pop()
  }
  for (const node of edges.keys()) {
    const circle = visit(node)
    if (circle) return circle
  }
}

/** Includes must not be circular, neither between files nor between modules, which are folders of src. */
function includeProblems() {
  const files = walk('src', /\.[ch]pp$/).map((file) => file.replace('src/', ''))
  const folders = new Set(files.map((file) => dirname(file)))
  const isDivided = (folder) => [...folders].some((other) => dirname(other) === folder)
  // A file beside subfolders is a module by itself: it lies below them, or is their façade.
  const moduleOf = (file) =>
    isDivided(dirname(file)) ? file.replace(/\.[ch]pp$/, '') : dirname(file)
  const edges = new Map(files.map((file) => [file, includesOf(read(`src/${file}`))]))
  const modules = new Map()
  for (const [file, included] of edges)
    for (const other of included)
      if (moduleOf(other) !== moduleOf(file) && edges.has(other))
        modules.set(moduleOf(file), [...(modules.get(moduleOf(file)) ?? []), moduleOf(other)])
  const knowsDialects = files.filter(
    (file) =>
      moduleOf(file) === 'builder' && edges.get(file).some((other) => moduleOf(other) === 'emit'),
  )
  return [
    circleIn(edges) && `src: a circular include, ${circleIn(edges).join(' -> ')}`,
    circleIn(modules) && `src: circular modules, ${circleIn(modules).join(' -> ')}`,
    ...knowsDialects.map(
      (file) => `src/${file} is of the front end and includes a file of src/emit`,
    ),
  ]
}

/** Matches shader source. `glsl.vec3(…)` in a message is JavaScript and does not match. */
const shaderText =
  /(?<![.\w])(?:vec[234]f?|mat[234](?:x[234]f?)?)\(|\b(?:textureSize|textureDimensions|texelFetch|textureLoad|texture2D|gl_[A-Z]\w+)\b|#version|\bvoid main\b/

/** The texts in a file, without its comments. */
const textsIn = (source) =>
  source
    .replace(/\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g, '')
    .match(/'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`/g) ?? []

const { forbidden } = createRequire(import.meta.url)(path('.dependency-cruiser.cjs'))
const { from } = forbidden.find(({ name }) => name === 'adapters-use-host-layer')

/** A host's adapter has to speak the language of its host: p5's shaders are GLSL, and so are three's. */
const isAdapter = (file) =>
  new RegExp(from.path).test(file) || file === 'js-bindings/glsl-source/function-text.ts'

/** Finds shader source outside dialects and adapters. */
const shaderTextProblems = () =>
  walk('js-bindings', /\.ts$/)
    .filter((file) => !file.endsWith('.d.ts') && !isAdapter(file))
    .flatMap((file) =>
      textsIn(read(file))
        .filter((text) => shaderText.test(text))
        .map((text) => `${file} has shader text, which belongs to a dialect: ${text}`),
    )

/** Rejects circular includes, circular imports, imports of an entry from below, and shader text outside a dialect. */
export async function checkDependencies() {
  const problems = [...includeProblems(), ...shaderTextProblems()].filter(Boolean)
  if (problems.length) throw new Stop(problems.join('\n'))
  const cruiser = path('node_modules/dependency-cruiser/bin/dependency-cruise.mjs')
  await run(process.execPath, [cruiser, 'js-bindings', '--config', '.dependency-cruiser.cjs'])
}
