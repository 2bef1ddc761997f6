// Runs the README's sketch and every block of the docs with a “Run” link without a browser: stand-ins for p5 and three.js only pass each
// offset to the compiler. web/tests/docs.browser.test.js runs the same blocks as a reader does.
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { test } from 'node:test'
import * as deformers from '../../dist/deformers.js'
import * as glsl from '../../dist/glsl.js'
import * as library from '../../dist/warpjet.js'
import { blocksOf } from '../site/markdown.js'

const root = new URL('../../', import.meta.url)
const pages = readdirSync(new URL('web/docs/', root)).filter((file) => file.endsWith('.md'))
const blocks = ['README.md', ...pages.map((page) => `web/docs/${page}`)].flatMap((file) =>
  blocksOf(readFileSync(new URL(file, root), 'utf8')).map((block) => ({ ...block, file })),
)
// Sketches with operators do not run here: the operators look up names among the globals of a page.
const runnable = blocks.filter(
  ({ sketch }) => sketch?.host === 'p5' && !sketch.chosen.includes('operators'),
)

/** Replaces any object of the host: calling it, constructing it or reading a property returns the object itself; as a number it is 1. */
const anything = new Proxy(function () {}, {
  get(_, key) {
    if (key === Symbol.toPrimitive) return () => 1
    if (key === Symbol.iterator) return function* () {}
    if (key === 'then') return undefined
    // Ends loops over its elements.
    return key === 'length' ? 0 : anything
  },
  apply: () => anything,
  construct: () => anything,
  set: () => true,
})

/** Returns the globals of a sketch, and an object in which the globals count the warps and prints of the sketch. */
function globalsFor({ chosen }) {
  const counts = { warps: 0, printed: 0 }
  const createWarp = (offset, { uniforms, space, returns } = {}) => {
    assert.ok([undefined, 'local', 'world', 'camera'].includes(space))
    const values = Object.entries(uniforms ?? {}).map(([name, value]) => [
      name,
      typeof value === 'function' ? [0, 0] : value,
    ])
    const plainOffset =
      returns === 'position' ? (inputs) => inputs.glsl.sub(offset(inputs), inputs.position) : offset
    try {
      library.compileWarp(plainOffset, {
        uniforms: Object.fromEntries(values),
        surfaceVariation: true,
      })
    } catch {
      // Only the sketch knows whether a function's value is a number or a vector.
      const numbers = values.map(([name, value]) => [name, Array.isArray(value) ? 0 : value])
      library.compileWarp(plainOffset, {
        uniforms: Object.fromEntries(numbers),
        surfaceVariation: true,
      })
    }
    counts.warps++
    return anything
  }
  const warpjet = {
    ...library,
    ...(chosen.includes('deformers') && deformers),
    ...(chosen.includes('glsl') && glsl),
  }
  const defined = {
    ...{ console, createWarp, warpjet, Math, Float32Array, Infinity, undefined, Object, Array },
    AutoDiff: { gen: library.gen },
    print: (...values) => {
      assert.ok(values.every((value) => String(value).length))
      counts.printed++
    },
    asin: Math.asin,
    width: 640,
    height: 480,
    mouseX: 10,
    mouseY: 10,
    millis: () => 500,
  }
  const globals = new Proxy(defined, {
    has: (_, key) => typeof key === 'string',
    get: (target, key) => {
      if (typeof key === 'symbol') return undefined
      return key in target ? target[key] : anything
    },
  })
  return { globals, counts }
}

/** Runs a sketch in a `with` statement that provides these globals; its own declarations stay local. */
const run = (text, globals) =>
  new Function(
    'globals',
    `with (globals) { return (async function () { ${text}
      ;await setup(); if (typeof draw === 'function') draw() })() }`,
  )(globals)

for (const { file, line, sketch } of runnable)
  test(`${file}, line ${line}`, async () => {
    const { globals, counts } = globalsFor(sketch)
    await run(sketch.text, globals)
    const needsNeither = /\b(?:baseMaterialShader|exactNormals|loadWarpModel)\(/.test(sketch.text)
    assert.ok(
      counts.warps || counts.printed || needsNeither,
      'expected a warp or a print, got neither',
    )
  })

test('most blocks of JavaScript run, and the others are listed here', () => {
  const notRun = blocks
    .filter(({ language, sketch }) => language === 'js' && !sketch)
    .map(({ file }) => file.replace('web/docs/', ''))
  // Babylon.js, PlayCanvas, A-Frame and CSM are not part of the site; a bundler's settings, files for Node and loops of renderers are not sketches; and
  // lost-context.test.js runs the code of uptime.md.
  assert.deepEqual(notRun, [
    'README.md',
    ...['babylon.md', 'babylon.md', 'babylon.md', 'babylon.md', 'babylon.md'],
    ...['core.md', 'how-to-blender.md', 'how-to-blender.md', 'mesh.md', 'mesh.md', 'mesh.md'],
    ...[
      'operators.md',
      'three.md',
      'three.md',
      'three.md',
      'three.md',
      'three.md',
      'three.md',
      'uptime.md',
    ],
  ])
})
