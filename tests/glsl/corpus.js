// GLSL functions: of packages whose licences allow us to run them, read from node_modules, and our own.
import { readFileSync, readdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { builtInCalls } from './own-built-ins.js'
import { ownFunctions } from './own.js'

const modules = fileURLToPath(new URL('../../node_modules', import.meta.url))

/** Maps packages to their folders with functions. */
export const packages = {
  'glsl-noise': ['classic', 'periodic', 'simplex'],
  'glsl-easings': [''],
  'glsl-sdf-primitives': [''],
  'glsl-blend': [''],
  'glsl-worley': [''],
  'glsl-rotate': [''],
  'glsl-smooth-min': [''],
  'glsl-cos-palette': [''],
  'glsl-hsl2rgb': [''],
  'glsl-map': [''],
  'glsl-luma': [''],
}

const isSupported = ({ type }) => /^(?:float|bool|vec[234])$/.test(type)

/** Returns the source of a file, including files of its package that it requires, inserted like glslify does. */
const textOf = (file) =>
  readFileSync(join(modules, file), 'utf8').replace(
    /^#pragma glslify: \w+ = require\((\.[^)]+)\)/gm,
    (_, name) => textOf(join(dirname(file), `${name}.glsl`)).replace(/^#pragma glslify.*/gm, ''),
  )

/** Returns { name, text, functionName, type, parameters } of the function that a file exports; `undefined` if it needs another package. */
function parseSource(name, text) {
  if (/require\(/.test(text)) return undefined
  const exported = /#pragma glslify:\s*export\((\w+)\)/.exec(text)?.[1]
  const plain = text.replace(/\/\/.*|\/\*[^]*?\*\//g, '')
  const functions = [
    ...plain.matchAll(/^\s*(float|vec[234]|mat[234])\s+(\w+)\s*\(([^)]*)\)\s*\{/gm),
  ]
  const candidates = functions.filter(([, , name]) => !exported || name === exported)
  const [, type, functionName, list] = candidates.at(-1) ?? []
  const parameters = list?.split(',').map((parameter) => {
    const [type, name] = parameter
      .trim()
      .replace(/^in\s+/, '')
      .split(/\s+/)
    return { type, name }
  })
  if (!functionName || !parameters.every(isSupported)) return undefined
  return { name, text, functionName, type, parameters }
}

function* listFiles() {
  for (const [name, folders] of Object.entries(packages))
    for (const folder of folders)
      for (const file of readdirSync(join(modules, name, folder)))
        if (file.endsWith('.glsl') && !undefinedPowers.test(join(name, folder, file)))
          yield join(name, folder, file)
}

/**
 * These functions are left out: they raise negative numbers to a power, which GLSL leaves undefined.
 */
const undefinedPowers =
  /^glsl-easings.(?:cubic-in-out|quartic-out|quintic-in-out|quintic-out)\.glsl$/

/**
 * Returns an argument for a parameter, from a vec3 `p`. Floats are at least 0, as easings require. No two arguments are equal or differ
 * only in their sign. The period `rep` of a noise is an integer: with a fraction, the hash differs at every point.
 */
const makeArgument = ({ type, name }, i) =>
  name === 'rep'
    ? `${type}(3.0)`
    : {
        bool: 'false',
        float: `(${['p.x', 'p.y', 'p.z'][i % 3]} * 0.49 + 0.5 + ${Math.floor(i / 3)}.0)`,
        vec2: `(${['p.xy', 'p.yz', 'p.zx'][i % 3]} + ${Math.floor(i / 3)}.0)`,
        vec3: `(${['p', 'p.yzx', 'p.zxy'][i % 3]} * ${(4 + i) / 4}${i % 4 ? '' : '.0'} + ${Math.floor(i / 3)}.0)`,
        vec4: `(vec4(p, 0.3) + ${i}.0 * vec4(0.1, 0.2, 0.3, 0.4))`,
      }[type]

const toVec3 = (type, call) =>
  ({
    float: `vec3(${call})`,
    vec2: `vec3(${call}, 0.0)`,
    vec3: call,
    vec4: `(${call}).xyz + (${call}).w`,
    mat2: `vec3(${call}[0], ${call}[1].x)`,
    mat3: `${call} * vec3(0.5, 1.0, 2.0)`,
    mat4: `(${call} * vec4(0.5, 1.0, 2.0, 4.0)).xyz`,
  })[type]

/** The functions, each with its name and a source that ends with a function `vec3 corpus(vec3 p)`, which calls it. */
export const corpus = [
  ...[...listFiles()].map((file) => parseSource(file, textOf(file))),
  ...Object.entries({ ...ownFunctions, ...builtInCalls }).map(([name, text]) =>
    parseSource(name, text),
  ),
]
  .filter(Boolean)
  .map(({ name, text, functionName, type, parameters }) => ({
    name,
    text: `${text}\nvec3 corpus(vec3 p) { return ${toVec3(type, `${functionName}(${parameters.map(makeArgument).join(', ')})`)}; }\n`,
  }))
