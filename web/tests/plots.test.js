// Compares the plots in the docs with the formulas in the docs, and checks how the code below each plot moves a ball, in double precision
// and without a browser. web/tests/docs.browser.test.js runs one example per group as a reader would.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { add, dot, subtract, times } from '../../tests/support/linear.js'
import { builder, wrap } from '../../tests/support/plain-builder.js'
import { blocksOf } from '../site/markdown.js'

const page = (file) => readFileSync(new URL(`../docs/${file}`, import.meta.url), 'utf8')
const sections = ['plots.md', 'plots-vectors.md'].flatMap((file) =>
  page(file).split(/^### /m).slice(1),
)
const titleOf = (section) => section.split('\n')[0]

const toFunction = (call) => new Function('glsl', 'x', `return ${call}`)

/** Returns a function that evaluates a call in double precision, with the formulas in JavaScript. */
const plainFunction = (call) => (x) => toFunction(call)(builder, wrap(x)).plain

/** Compiles the offset function that a section's code passes to createWarp. Only positions are compared. */
function warpOf(section) {
  let warp
  const [{ text }] = blocksOf(section)
  const createWarp = (offset) => (warp = compileWarp(offset, { surfaceVariation: false }))
  new Function('createWarp', text)(createWarp)
  return warp
}

function assertNear(actual, expected, bound, what) {
  const size = bound * Math.max(1, Math.abs(expected))
  assert.ok(Math.abs(actual - expected) <= size, `${what}: ${actual}, not ${expected}`)
}

// The expected offsets of code without a formula, computed from a point and its normal.

const gradient = (f, p) =>
  p.map((_, i) => (f(p.with(i, p[i] + 1e-5)) - f(p.with(i, p[i] - 1e-5))) / 2e-5)
const unit = (v) => times(1 / Math.sqrt(dot(v, v)), v)
const bumpSlope = ([x]) => 0.8 * Math.cos(4 * x)
/** Returns the normal of the bumps. Their Jacobian is the identity, except for the slope in its second row and first column. */
const bumpNormal = (p, [x, y, z]) => unit([x - bumpSlope(p) * y, y, z])
const byHand = {
  derivative: ([, y]) => [0.3 * Math.cos(3 * y), 0, 0],
  gradient: (p) => times(0.1, gradient((q) => dot(q.map((x) => Math.sin(2 * x)), q), p)), // prettier-ignore
  jacobian: ([x, y, z]) =>
    times(0.3, [-x * Math.sin(y) + z * Math.cos(y), 1, -x * Math.cos(y) - z * Math.sin(y)]),
  adjustNormal: (p, n) => times(0.3, bumpNormal(p, n)),
  adjustTangent: (p, n) => {
    const [moved, facing] = [[1, bumpSlope(p), 0], bumpNormal(p, n)]
    return times(0.3, unit(subtract(moved, times(dot(facing, moved), facing))))
  },
}

for (const section of sections) {
  const title = titleOf(section)
  const [, call, from, to] = /<!-- plot (.*) from (\S+) to (\S+) -->/.exec(section) ?? []
  if (byHand[title])
    test(`the code for ${title} moves points as expected`, () => {
      const place = { positions: [0.3, -0.2, 0.5, -0.6, 0.7, 0.1], normals: [0.36, 0.48, 0.8, 0, 1, 0] } // prettier-ignore
      const { positions } = warpOf(section).evaluate(place)
      for (const i of [0, 3]) {
        const [p, n] = [place.positions, place.normals].map((list) => list.slice(i, i + 3))
        const expected = add(p, byHand[title](p, n))
        for (const [k, x] of expected.entries()) assertNear(positions[i + k], x, 1e-5, `${p}`)
      }
    })
  else
    describe(`${title}: ${call}`, () => {
      const [low, high] = [Number(from), Number(to)]
      const places = Array.from({ length: 9 }, (_, i) => low + ((high - low) * (i + 0.37)) / 9)
      const plain = plainFunction(call)

      test('the plot matches the formula', () => {
        const program = compile((glsl) => {
          const x = glsl.param('x')
          const value = toFunction(call)(glsl, x)
          return { value, derivative: glsl.derivative(value, x) }
        })
        for (const x of places) {
          const { value, derivative } = program.evaluate({ x })
          assertNear(value, plain(x), 1e-6, `value at ${x}`)
          assertNear(derivative, (plain(x + 1e-6) - plain(x - 1e-6)) / 2e-6, 1e-5, `slope at ${x}`)
        }
      })

      test('the code below the plot moves a ball by the amount that the formula gives', () => {
        const ys = places.map((x) => (2 * (x - low)) / (high - low) - 1)
        const { positions } = warpOf(section).evaluate({ positions: ys.flatMap((y) => [0, y, 0]) })
        for (const [i, x] of places.entries()) {
          const moved = Math.min(Math.max(0.1 * plain(x), -1), 1)
          assertNear(positions[3 * i], moved, 1e-5, `moved by x = ${x}`)
        }
      })
    })
}

test('every operation and every noise has a section', () => {
  const [, tables] = /^## Arithmetic$([^]*)^## Other names$/m.exec(page('operations.md'))
  const names = [...`${tables}${page('noise.md')}`.matchAll(/^\| `(?:glsl\.)?(\w+)\(/gm)]
  assert.ok(names.length > 75)
  for (const [, name] of names)
    assert.ok(
      sections.some((section) => titleOf(section) === name),
      name,
    )
})
