// Compiles displacements in WGSL by `wgslOffset`, and compares values and Jacobians with JavaScript in double precision.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile } from 'warpjet'
import { wgslOffset } from 'warpjet/glsl'
import { derivative } from '../random/differences.js'
import { displacements } from '../wgsl/displacements.js'

/** Points of a cube from -1 to 1, of which none is on a plane where a displacement has a kink or jump. */
const points = Array.from({ length: 200 }, (_, i) =>
  [0.618034, 0.754878, 0.56984].map((x) => 2 * ((0.5 + x * (i + 1)) % 1) - 1),
)

/** The maximum estimated error of a finite difference that is compared; at a kink the error is larger. */
const maxError = 1e-4

for (const [name, { text, uniforms, offset }] of Object.entries(displacements))
  test(name, (t) => {
    const compiled = compile((glsl) => {
      const position = glsl.vec3Param('p')
      const value = wgslOffset(text)({ glsl, position, uniforms: {} })
      return { value, jacobian: glsl.jacobian(value, position) }
    })
    let [slopes, kinks, valueError, slopeError] = [0, 0, 0, 0]
    for (const p of points) {
      const { value, jacobian } = compiled.evaluate({ p, ...uniforms })
      const expected = offset(p)
      expected.forEach((x, i) => {
        valueError = Math.max(valueError, Math.abs(value[i] - x))
      })
      for (let k = 0; k < 3; k++) {
        const by = [{ name: 'p', index: k }]
        derivative((point) => offset(point.p), { p }, by, expected).forEach(
          ({ value, error }, i) => {
            const size = Math.max(1, Math.abs(value))
            if (!(error <= maxError * size)) return kinks++
            slopes++
            slopeError = Math.max(slopeError, Math.abs(jacobian[3 * k + i] - value) / size)
          },
        )
      }
    }
    t.diagnostic(
      `values are up to ${valueError} off, ${slopes} slopes up to ${slopeError}; ${kinks} kinks`,
    )
    assert.ok(valueError < 1e-5, `${valueError}`)
    assert.ok(slopeError < 10 * maxError, `${slopeError}`)
    assert.ok(slopes > 1500 && kinks < slopes / 20, `${slopes} slopes, ${kinks} kinks`)
  })
