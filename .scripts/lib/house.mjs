// What `npm test` holds of the rooms; src/ARCHITECTURE.md draws them.
import { readFileSync } from 'node:fs'
import { dirname, join } from 'node:path/posix'
import { path, walk } from './files.mjs'
import { Stop } from './terminal.mjs'

const read = (file) => readFileSync(path(file), 'utf8')

/** The files that one of the core includes, by its own name in `src`. */
const includesOf = (text) => [...text.matchAll(/^#include "([^"]+)"/gm)].map(([, file]) => file)

/** The modules of ours that one imports or hands on, as { values, all }; those of values are no types alone. */
function importsOf(file, text) {
  const found = text.matchAll(
    /^(?:import|export)( type)?\b[^'";]*?\bfrom '(\.[^']+)'|^import '(\.[^']+)'/gm,
  )
  const all = [...found].map(([, isType, from, alone]) => ({
    isType,
    to: join(dirname(file), (from ?? alone).replace(/\.js$/, '.ts')),
  }))
  return {
    values: all.filter(({ isType }) => !isType).map(({ to }) => to),
    all: all.map(({ to }) => to),
  }
}

/** A way from a node back to itself, or nothing. `edges` has the nodes after each. */
export function circleIn(edges) {
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

/** The nodes from one to another, or nothing. */
function wayFrom(start, end, edges, seen = new Set()) {
  if (start === end) return [end]
  if (seen.has(start)) return undefined
  seen.add(start)
  for (const next of edges.get(start) ?? []) {
    const way = wayFrom(next, end, edges, seen)
    if (way) return [start, ...way]
  }
}

/** Of whole rooms too: arrows between them go one way. */
function includeProblems() {
  const files = walk('src', /\.[ch]pp$/).map((file) => file.replace('src/', ''))
  const folders = new Set(files.map((file) => dirname(file)))
  const isDivided = (folder) => [...folders].some((other) => dirname(other) === folder)
  // What stands beside sub-rooms is below them or their façade, each file by itself.
  const roomOf = (file) =>
    isDivided(dirname(file)) ? file.replace(/\.[ch]pp$/, '') : dirname(file)
  const edges = new Map(files.map((file) => [file, includesOf(read(`src/${file}`))]))
  const rooms = new Map()
  for (const [file, included] of edges)
    for (const other of included)
      if (roomOf(other) !== roomOf(file) && edges.has(other))
        rooms.set(roomOf(file), [...(rooms.get(roomOf(file)) ?? []), roomOf(other)])
  const knowsDialects = files.filter(
    (file) =>
      roomOf(file) === 'builder' && edges.get(file).some((other) => roomOf(other) === 'emit'),
  )
  return [
    circleIn(edges) && `src: an include circle, ${circleIn(edges).join(' -> ')}`,
    circleIn(rooms) && `src: rooms in a circle, ${circleIn(rooms).join(' -> ')}`,
    ...knowsDialects.map(
      (file) => `src/${file} is of the front end and includes a file of src/emit`,
    ),
  ]
}

/** What is in no JavaScript, but in the text of shaders; `glsl.vec3(…)` in a message is none. */
const shaderText =
  /(?<![.\w])(?:vec[234]f?|mat[234](?:x[234]f?)?)\(|\b(?:textureSize|textureDimensions|texelFetch|textureLoad|texture2D|gl_[A-Z]\w+)\b|#version|\bvoid main\b/

/** The texts in a file, without its comments. */
const textsIn = (source) =>
  source
    .replace(/\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g, '')
    .match(/'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`/g) ?? []

/** A host's adapter has to speak the language of its host: p5's shaders are GLSL, and so are three's. */
const isAdapter = (file) =>
  /^js-bindings\/(p5|three|babylon)\/|^js-bindings\/glsl\/function-text\.ts$/.test(file)

/** A way from a module back to itself with an import of values on it. Types alone may need each other. */
function importCircle(edges) {
  for (const [file, { values }] of edges)
    for (const first of values) {
      const way = wayFrom(first, file, new Map([...edges].map(([each, { all }]) => [each, all])))
      if (way) return [file, ...way]
    }
}

/** The folders of js-bindings, with the folders that their values come from; entries stand beside them, above all. */
function roomsOfBindings(edges) {
  const roomOf = (file) => dirname(file).replace('js-bindings/', '')
  const rooms = new Map()
  for (const [file, { values }] of edges)
    for (const room of values.map(roomOf))
      if (room !== roomOf(file) && room !== 'js-bindings' && roomOf(file) !== 'js-bindings')
        rooms.set(roomOf(file), [...(rooms.get(roomOf(file)) ?? []), room])
  return rooms
}

function importProblems() {
  const files = walk('js-bindings', /\.ts$/).filter((file) => !file.endsWith('.d.ts'))
  const edges = new Map(files.map((file) => [file, importsOf(file, read(file))]))
  const speaking = files
    .filter((file) => !isAdapter(file))
    .flatMap((file) =>
      textsIn(read(file))
        .filter((text) => shaderText.test(text))
        .map((text) => `${file} has shader text, which belongs to a dialect: ${text}`),
    )
  const circle = importCircle(edges)
  const rooms = circleIn(roomsOfBindings(edges))
  return [
    circle && `js-bindings: an import circle, ${circle.join(' -> ')}`,
    rooms && `js-bindings: rooms in a circle, ${rooms.join(' -> ')}`,
    ...speaking,
  ]
}

export function checkHouse() {
  const problems = [...includeProblems(), ...importProblems()].filter(Boolean)
  if (problems.length) throw new Stop(problems.join('\n'))
}
