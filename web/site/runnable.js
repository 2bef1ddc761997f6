/**
 * Converts a code block of the docs to a sketch for the playground: { text, host, chosen }, or undefined if there is nothing to run,
 * as in a command line. A whole sketch runs unchanged. If a block is only a part, the comment before it contains the rest, with …
 * in place of the block; a bare call of createWarp is wrapped in a sketch that draws a sphere.
 */
import { deflateRawSync } from 'node:zlib'

/** Maps a script to the code that needs it. */
const needs = {
  deformers:
    /\b(?:twist|bend|taper|bulge|stretch|ripple|melt|inflate|genie|spherify|shear|noiseDisplace|chain|blend|mask|inSpace)\(|warpjet\.(?:wave|add)\(|\{[^}]*\b(?:wave|add)\b[^}]*\} = warpjet/,
  glsl: /\b(?:glslOffset|wgslOffset|exactNormals|differentiate)\(|glsl\.source\(/,
}

const scriptsOf = (text) => Object.keys(needs).filter((name) => needs[name].test(text))

/** Replaces imports by the global `warpjet`, which has the same names. */
const withoutImports = (text) =>
  text.replaceAll(/^import (\{[^}]*\}) from 'warpjet(?:\/\w+)?'.*\n/gm, 'const $1 = warpjet\n')

const indent = (text, spaces) => text.trimEnd().replaceAll(/^(?=.)/gm, spaces)

/** Wraps a block in a sketch that prints the value of an expression. */
const wrapInPrint = (text, expression) => `function setup() {
  createCanvas(640, 480, WEBGL)
${indent(text, '  ')}
  print(${expression})
}

function draw() {
  background('#151823')
}
`

/** Wraps a block in an offset function that returns the value of an expression. */
const wrapInOffset = (text, expression) =>
  `createWarp(({ glsl, position, normal, uv, millis }) => {
${indent(text, '  ')}
  return ${expression}
})
`

/** Wraps a bare call of createWarp in a sketch that draws with it. */
const wrapInSketch = (text) => {
  const [, name] = /^(\w+) = createWarp\(/m.exec(text) ?? []
  const body = (name ? text : text.replace(/^createWarp\(/m, 'warp = createWarp(')).trimEnd()
  const warp = name ?? /^const (\w+) = createWarp\(/m.exec(text)?.[1] ?? 'warp'
  const isInWorld = /space: 'world'/.test(text)
  return `let ${warp}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
${indent(body.replace(/^const (?=\w+ = createWarp\()/m, ''), '  ')}
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  fill('#ff8a5b')
  ${warp}()
  ${isInWorld ? 'warpBox(110, 260, 110, 40)' : 'sphere(150, 160, 120)'}
}
`
}

/**
 * `directive` is the content of the comment before the block: `not` (do not run); `prints EXPRESSION`; `inside EXPRESSION`, if the
 * block is a part of an offset function that returns the expression; or names of scripts. Its other lines are the code around the block.
 */
export function runnable(text, language, directive = '') {
  const [words, ...lines] = directive.split('\n')
  const first = words.trim()
  if (language !== 'js' || first === 'not') return undefined
  const [, kind, rest] = /^(prints|inside) (.*)$/.exec(first) ?? []
  const frame = lines.join('\n').trim()
  let whole = text
  if (kind)
    whole = kind === 'prints' ? wrapInPrint(withoutImports(text), rest) : wrapInOffset(text, rest)
  else if (frame) {
    const block = /from 'three'/.test(frame) ? text : withoutImports(text)
    whole = `${frame.replace(/^( *)…$/m, (_, spaces) => indent(block, spaces))}\n`
  }
  if (/from 'three'/.test(whole)) return { text: whole, host: 'three', chosen: [] }
  const code = withoutImports(whole)
  const isSketch = /\bfunction setup\(\)/.test(code)
  if (!isSketch && !/\bcreateWarp\(/.test(code)) return undefined
  const sketch = isSketch ? code : wrapInSketch(code)
  const named = kind ? [] : first.split(' ').filter(Boolean)
  return { text: sketch, host: 'p5', chosen: [...new Set([...named, ...scriptsOf(sketch)])] }
}

/** Returns the fragment of a link to the playground, which playground/link.js reads. */
export const linkTo = (sketch) =>
  `#sketch=${deflateRawSync(JSON.stringify(sketch)).toString('base64url')}`
