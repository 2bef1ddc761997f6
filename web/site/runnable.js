/**
 * A code block of the docs as a sketch of the playground: { text, host, chosen }, or undefined where there is nothing to run, as
 * in a command line. A whole sketch runs as it stands. Where a block shows a part, the comment before it has the rest, with … in
 * the place of the block; a bare call of createWarp gets a sphere around it.
 */
import { deflateRawSync } from 'node:zlib'

/** What a script adds to what a sketch may say. */
const needs = {
  deformers:
    /\b(?:twist|bend|taper|bulge|stretch|ripple|melt|inflate|genie|spherify|shear|noiseDisplace|chain|blend|mask|inSpace)\(|warpjet\.(?:wave|add)\(|\{[^}]*\b(?:wave|add)\b[^}]*\} = warpjet/,
  glsl: /\b(?:glslOffset|exactNormals|differentiate)\(|glsl\.source\(/,
}

const scriptsOf = (text) => Object.keys(needs).filter((name) => needs[name].test(text))

/** Modules are for bundlers; the scripts put the same names on a global. */
const withoutImports = (text) =>
  text.replaceAll(/^import (\{[^}]*\}) from 'warpjet(?:\/\w+)?'.*\n/gm, 'const $1 = warpjet\n')

const indented = (text, by) => text.trimEnd().replaceAll(/^(?=.)/gm, by)

/** A sketch that prints what the block has made. */
const printing = (text, made) => `function setup() {
  createCanvas(640, 480, WEBGL)
${indented(text, '  ')}
  print(${made})
}

function draw() {
  background('#151823')
}
`

/** The block as a part of an offset function that returns that. */
const inside = (text, returned) =>
  `createWarp(({ glsl, position, normal, uv, millis }) => {
${indented(text, '  ')}
  return ${returned}
})
`

const around = (text) => {
  const [, name] = /^(\w+) = createWarp\(/m.exec(text) ?? []
  const body = (name ? text : text.replace(/^createWarp\(/m, 'warp = createWarp(')).trimEnd()
  const warp = name ?? /^const (\w+) = createWarp\(/m.exec(text)?.[1] ?? 'warp'
  const space = /space: 'world'/.test(text)
  return `let ${warp}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
${indented(body.replace(/^const (?=\w+ = createWarp\()/m, ''), '  ')}
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  fill('#ff8a5b')
  ${warp}()
  ${space ? 'warpBox(110, 260, 110, 40)' : 'sphere(150, 160, 120)'}
}
`
}

/**
 * `directive`: what stands in the comment before the block. `not`; `prints …`, of what the block has made; `inside …`, of an
 * offset function that returns that; names of scripts; and below, the text around the block.
 */
export function runnable(text, language, directive = '') {
  const [words, ...lines] = directive.split('\n')
  const first = words.trim()
  if (language !== 'js' || first === 'not') return undefined
  const [, kind, rest] = /^(prints|inside) (.*)$/.exec(first) ?? []
  const frame = lines.join('\n').trim()
  let whole = text
  if (kind) whole = kind === 'prints' ? printing(withoutImports(text), rest) : inside(text, rest)
  else if (frame) {
    const block = /from 'three'/.test(frame) ? text : withoutImports(text)
    whole = `${frame.replace(/^( *)…$/m, (_, by) => indented(block, by))}\n`
  }
  if (/from 'three'/.test(whole)) return { text: whole, host: 'three', chosen: [] }
  const plain = withoutImports(whole)
  const isSketch = /\bfunction setup\(\)/.test(plain)
  if (!isSketch && !/\bcreateWarp\(/.test(plain)) return undefined
  const sketch = isSketch ? plain : around(plain)
  const named = kind ? [] : first.split(' ').filter(Boolean)
  return { text: sketch, host: 'p5', chosen: [...new Set([...named, ...scriptsOf(sketch)])] }
}

/** The end of a link to the playground, as playground/link.js reads it. */
export const linkTo = (sketch) =>
  `#sketch=${deflateRawSync(JSON.stringify(sketch)).toString('base64url')}`
