// The dependency rules of src and js-bindings. The ARCHITECTURE.md of each explains them; .dependency-cruiser.cjs has those of
// js-bindings.
import { readFileSync } from 'node:fs'
import { dirname } from 'node:path/posix'
import { path, walk } from './files.mjs'
import { run } from './run.mjs'
import { Stop } from './terminal.mjs'

const read = (file) => readFileSync(path(file), 'utf8')

/** Returns the nodes on cycles and on paths between cycles. `edges` maps each node → the set of nodes that it points to. */
function findCycles(edges) {
  const remaining = new Map(edges)
  const hasSuccessor = (node) => [...remaining.get(node)].some((target) => remaining.has(target))
  const hasPredecessor = (node) => [...remaining.values()].some((targets) => targets.has(node))
  for (let size = -1; size !== remaining.size;) {
    size = remaining.size
    for (const node of remaining.keys())
      if (!hasSuccessor(node) || !hasPredecessor(node)) remaining.delete(node)
  }
  return [...remaining.keys()]
}

/** Returns messages about circular includes, between files or between modules, which are folders of src. */
function findIncludeProblems() {
  const files = walk('src', /\.[ch]pp$/).map((file) => file.replace('src/', ''))
  const folders = [...new Set(files.map((file) => dirname(file)))]
  // A file beside subfolders is a module by itself: the subfolders include it, or it is their façade.
  const moduleOf = (file) =>
    folders.some((folder) => dirname(folder) === dirname(file))
      ? file.replace(/\.[ch]pp$/, '')
      : dirname(file)
  const edges = new Map(files.map((file) => [file, new Set()]))
  const modules = new Map(files.map((file) => [moduleOf(file), new Set()]))
  for (const [file, included] of edges)
    for (const [, includedFile] of read(`src/${file}`).matchAll(/^#include "([^"]+)"/gm)) {
      included.add(includedFile)
      if (edges.has(includedFile) && moduleOf(includedFile) !== moduleOf(file))
        modules.get(moduleOf(file)).add(moduleOf(includedFile))
    }
  const problems = {
    'circular includes': findCycles(edges),
    'circular modules': findCycles(modules),
  }
  if (modules.get('builder').has('emit'))
    problems['the front end must not include a back end'] = ['builder', 'emit']
  return Object.entries(problems)
    .filter(([, names]) => names.length)
    .map(([problem, names]) => `src: ${problem}: ${names.join(', ')}`)
}

/** Matches shader source. `glsl.vec3(…)` in a message is JavaScript and does not match. */
const shaderSource =
  /(?<![.\w])(?:vec[234]f?|mat[234](?:x[234]f?)?)\(|\b(?:textureSize|textureDimensions|texelFetch|textureLoad|texture2D|gl_[A-Z]\w+)\b|#version|\bvoid main\b/
const comments = /\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g
const strings = /'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`/g

/**
 * Matches the files that may contain shader source: adapters to p5, three.js and Babylon.js, whose own shaders are source text; the compute
 * passes in WGSL; and declarations of types.
 */
const adapters =
  /^js-bindings\/(?:(?:p5|three|babylon)\/|glsl-source\/function-text\.ts$|detail\/gpu\/)|\.d\.ts$/

/** Returns messages about shader source in files that are not adapters. */
const findShaderSource = () =>
  walk('js-bindings', /\.ts$/)
    .filter((file) => !adapters.test(file))
    .flatMap((file) =>
      (read(file).replace(comments, '').match(strings) ?? [])
        .filter((text) => shaderSource.test(text))
        .map((text) => `${file} contains shader source, which belongs in a dialect: ${text}`),
    )

/**
 * Rejects circular includes, a front end that includes a back end, circular imports, imports of an entry by a lower module, and shader
 * source outside a dialect of the C++.
 */
export async function checkDependencies() {
  const problems = [...findIncludeProblems(), ...findShaderSource()]
  if (problems.length) throw new Stop(problems.join('\n'))
  const cruiser = path('node_modules/dependency-cruiser/bin/dependency-cruise.mjs')
  await run(process.execPath, [cruiser, 'js-bindings', '--config', '.dependency-cruiser.cjs'])
}
