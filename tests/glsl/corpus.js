// GLSL functions of packages whose licences allow us to run them, read from node_modules, and our own.
import { readFileSync, readdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { ownBuiltIns } from './own-built-ins.js'
import { own } from './own.js'

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

const isKnown = ({ type }) => /^(?:float|bool|vec[234])$/.test(type)

/** Returns the source of a file, including files of its package that it requires, inserted like glslify does. */
const textOf = (file) =>
  readFileSync(join(modules, file), 'utf8').replace(
    /^#pragma glslify: \w+ = require\((\.[^)]+)\)/gm,
    (_, name) => textOf(join(dirname(file), `${name}.glsl`)).replace(/^#pragma glslify.*/gm, ''),
  )

/** Returns { name, text, head, type, parameters } of the function that a file exports; `undefined` if it needs another package. */
function read(name, text) {
  if (/require\(/.test(text)) return undefined
  const exported = /#pragma glslify:\s*export\((\w+)\)/.exec(text)?.[1]
  const plain = text.replace(/\/\/.*|\/\*[^]*?\*\//g, '')
  const heads = [...plain.matchAll(/^\s*(float|vec[234]|mat[234])\s+(\w+)\s*\(([^)]*)\)\s*\{/gm)]
  const candidates = heads.filter(([, , head]) => !exported || head === exported)
  const [, type, head, list] = candidates.at(-1) ?? []
  const parameters = list?.split(',').map((each) => {
    const [type, name] = each
      .trim()
      .replace(/^in\s+/, '')
      .split(/\s+/)
    return { type, name }
  })
  if (!head || !parameters.every(isKnown)) return undefined
  return { name, text, head, type, parameters }
}

function* files() {
  for (const [name, folders] of Object.entries(packages))
    for (const folder of folders)
      for (const file of readdirSync(join(modules, name, folder)))
        if (file.endsWith('.glsl') && !leftOpen.test(join(name, folder, file)))
          yield join(name, folder, file)
}

/**
 * These functions raise negative numbers to a power, which GLSL leaves undefined; we replace the power by the product that is
 * meant.
 */
const leftOpen = /^glsl-easings.(?:cubic-in-out|quartic-out|quintic-in-out|quintic-out)\.glsl$/

/**
 * Returns an argument for a parameter, from a vec3 `p`: numbers from 0 up, as easings require, no two equal or mirrored. The
 * period of a noise is an integer: between integers its hash differs at every point.
 */
const argument = ({ type, name }, i) =>
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

/** Each has a function `vec3 corpus(vec3 p)` at the end of its source. */
export const corpus = [
  ...[...files()].map((file) => read(file, textOf(file))),
  ...Object.entries({ ...own, ...ownBuiltIns }).map(([name, text]) => read(name, text)),
]
  .filter(Boolean)
  .map(({ name, text, head, type, parameters }) => ({
    name,
    text: `${text}\nvec3 corpus(vec3 p) { return ${toVec3(type, `${head}(${parameters.map(argument).join(', ')})`)}; }\n`,
  }))
