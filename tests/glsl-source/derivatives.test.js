// Compares the Jacobian of every function of the corpus with finite differences in double precision, by an interpreter with a parser of its
// own.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile } from 'warpjet'
import 'warpjet/glsl'
import { corpus } from '../glsl/corpus.js'
import { pointsOfCube } from '../glsl/points.js'
import { walk } from '../glsl/walk.js'
import { derivative } from '../random/differences.js'

const points = pointsOfCube(12)

/** Functions that compute with integers: their derivative is zero, but they have steps finer than any finite difference. */
const stairs = new Set([
  'a hash of bits',
  'bits of floats',
  'half floats',
  'roundEven of numbers halfway between integers',
  'packed 16-bit numbers',
])

/** The maximum estimated error of a finite difference that is compared; at a kink or a jump the error is larger. */
const maxError = 1e-4

/** Returns whether GLSL defines a value: the root of a negative number, for instance, is not defined. */
const isDefined = Number.isFinite

const compared = { slopes: 0, kinks: 0 }

for (const { name, text } of corpus)
  test(`${name}: values and derivatives with respect to x, y and z are correct`, () => {
    const compiled = compile((glsl) => {
      const p = glsl.vec3Param('p')
      const value = glsl.source(text, { function: 'corpus' })(p)
      return { value, jacobian: glsl.jacobian(value, p) }
    })
    const f = walk(text, 'corpus')
    let [slopes, kinks] = [0, 0]
    for (const p of points) {
      const { value, jacobian } = compiled.evaluate({ p })
      const expected = f(p)
      const steepest = Math.max(1, ...Array.from(jacobian, Math.abs).filter(isDefined))
      expected.forEach((x, i) => {
        if (!isDefined(x)) return
        const isNear = Math.abs(value[i] - x) <= 2e-5 * steepest * Math.max(1, Math.abs(x))
        assert.ok(isNear, `value ${i} at ${p}: ${value[i]}, not ${x}`)
      })
      for (let k = 0; k < 3; k++) {
        const by = [{ name: 'p', index: k }]
        derivative((point) => f(point.p), { p }, by, expected).forEach(({ value, error }, i) => {
          const ours = jacobian[3 * k + i]
          if (stairs.has(name)) return assert.equal(ours, 0)
          const size = Math.max(1, Math.abs(value))
          if (!(error <= maxError * size)) return kinks++
          slopes++
          const isNear = Math.abs(ours - value) <= 10 * maxError * size
          return assert.ok(isNear, `slope ${i} by ${'xyz'[k]} at ${p}: ${ours}, not ${value}`)
        })
      }
    }
    assert.ok(stairs.has(name) || kinks <= slopes / 5, `${slopes} slopes, ${kinks} kinks`)
    compared.slopes += slopes
    compared.kinks += kinks
  })

test('enough derivatives are compared, since few points are at a kink', () => {
  assert.ok(compared.slopes > 100 * (corpus.length - stairs.size), `${compared.slopes} slopes`)
  assert.ok(compared.kinks < compared.slopes / 100, `${compared.kinks} kinks`)
})
