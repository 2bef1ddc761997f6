// Displacements in WGSL through `wgslOffset`: values and Jacobians against formulas of JavaScript, in double precision.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile } from 'warpjet'
import { wgslOffset } from 'warpjet/glsl'
import { derivative } from '../random/differences.js'
import { displacements } from '../wgsl/displacements.js'

/** Points of a cube, on no plane that a displacement divides it by. */
const points = Array.from({ length: 200 }, (_, i) =>
  [0.618034, 0.754878, 0.56984].map((x) => 2 * ((0.5 + x * (i + 1)) % 1) - 1),
)

/** The maximum estimated error of a finite difference that is compared; at a kink the error is larger. */
const sure = 1e-4

for (const [name, { text, uniforms, moved }] of Object.entries(displacements))
  test(name, (t) => {
    const compiled = compile((glsl) => {
      const position = glsl.vec3Param('p')
      const value = wgslOffset(text)({ glsl, position, uniforms: {} })
      return { value, jacobian: glsl.jacobian(value, position) }
    })
    let [slopes, kinks, farthest, steepest] = [0, 0, 0, 0]
    for (const p of points) {
      const { value, jacobian } = compiled.evaluate({ p, ...uniforms })
      const wanted = moved(p)
      wanted.forEach((x, i) => {
        farthest = Math.max(farthest, Math.abs(value[i] - x))
      })
      for (let k = 0; k < 3; k++) {
        const by = [{ name: 'p', index: k }]
        derivative((given) => moved(given.p), { p }, by, wanted).forEach(({ value, error }, i) => {
          const size = Math.max(1, Math.abs(value))
          if (!(error <= sure * size)) return kinks++
          slopes++
          steepest = Math.max(steepest, Math.abs(jacobian[3 * k + i] - value) / size)
        })
      }
    }
    t.diagnostic(`values to ${farthest}, ${slopes} slopes to ${steepest}, ${kinks} kinks`)
    assert.ok(farthest < 1e-5, `${farthest}`)
    assert.ok(steepest < 10 * sure, `${steepest}`)
    assert.ok(slopes > 1500 && kinks < slopes / 20, `${slopes} slopes, ${kinks} kinks`)
  })
