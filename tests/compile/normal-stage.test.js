// Where normals are computed: what 'auto' selects, and the code for pixels.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as deformers from '../../dist/deformers.js'
import { compileWarp } from '../../dist/warpjet.js'
import { throwsWarpError } from '../support/warp-errors.js'

const along = (height) => (inputs) => inputs.position.mult(height(inputs))
const fbm = along(({ glsl, position }) => glsl.fbm(position.mult(2)).mult(0.3))
const waves = ({ glsl, position: { x, y, z } }) =>
  glsl.vec3(y().mult(7).sin(), z().mult(7).sin(), x().mult(7).sin()).mult(0.05)
const stageOf = (offset, options) => compileWarp(offset, { normals: 'auto', ...options }).normals

describe("'auto' computes normals at pixels", () => {
  test('for noise, of any frequency', () => {
    assert.equal(stageOf(fbm), 'pixel')
    assert.equal(stageOf(along(({ glsl, position }) => glsl.simplex(position.div(200)))), 'pixel')
  })

  test('for waves that bend within the length of an edge, but not for long ones', () => {
    assert.equal(stageOf(waves), 'pixel')
    assert.equal(
      stageOf(({ glsl, position }) => glsl.vec3(0, 0, position.x().mult(0.5).sin().mult(0.2))),
      'vertex',
    )
  })

  test('for waves times a uniform, whatever its value is when the warp is made', () => {
    const offset = (inputs) => waves(inputs).mult(inputs.uniforms.strength)
    assert.equal(stageOf(offset, { uniforms: { strength: 0 } }), 'pixel')
  })

  test('for an offset that reads uv or normal, and bends', () => {
    const flag = ({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(30).sin().mult(0.05))
    assert.equal(stageOf(flag, { surfaceVariation: true }), 'pixel')
    const blob = ({ normal, position }) => normal.mult(position.x().mult(9).sin().mult(0.1))
    assert.equal(stageOf(blob, { surfaceVariation: true }), 'pixel')
  })
})

describe("'auto' computes normals at vertices", () => {
  test('for an offset that bends only at uvs outside of 0 to 1', () => {
    for (const at of [(uv) => uv.x(), (uv) => uv.y()]) {
      const outside = ({ glsl, uv }) => {
        const distance = glsl.max(at(uv).sub(1), at(uv).neg()).max(0)
        return glsl.vec3(0, 0, distance.mult(30).sin().mult(0.05))
      }
      assert.equal(stageOf(outside, { surfaceVariation: true }), 'vertex')
    }
  })

  test('for a twist of 1.5 radians per unit, and for a zero offset', () => {
    assert.equal(stageOf(deformers.twist({ angle: 1.5 })), 'vertex')
    assert.equal(
      stageOf(({ glsl }) => glsl.vec3(0)),
      'vertex',
    )
  })

  test('for waves that a uniform vector multiplies by 0 and 0.001', () => {
    const offset = (inputs) => waves(inputs).mult(inputs.uniforms.only)
    assert.equal(stageOf(offset, { uniforms: { only: [0, 0, 1e-3] } }), 'vertex')
  })

  test('for noise that takes more than 4,000 operations', () => {
    const heavy = along(({ glsl, position }) => {
      let sum = glsl.fbm(position.mult(2))
      for (let i = 1; i < 5; i++) sum = sum.add(glsl.fbm(position.mult(2 + i), { octaves: 8 }))
      return sum
    })
    assert.equal(stageOf(heavy), 'vertex')
  })

  test('for a warp that only the GPU can evaluate', () => {
    const offset = ({ glsl, position }) => {
      const f = glsl.fn({
        name: 'f',
        arity: 1,
        source: 'float f(float x) { return sin(x * 99.0); }',
        derivatives: [(x) => x.mult(99).cos().mult(99)],
      })
      // f(x) alone would not do: its normal reads only the derivative, which the CPU can evaluate.
      return glsl.vec3(0, 0, f(f(position.x())))
    }
    assert.equal(stageOf(offset), 'vertex')
  })
})

test('the option `normals` selects where normals are computed, and the property `normals` of the warp returns it', () => {
  assert.equal(compileWarp(fbm).normals, 'vertex')
  assert.equal(compileWarp(fbm, { normals: true }).normals, 'vertex')
  assert.equal(compileWarp(fbm, { normals: false }).normals, false)
  assert.equal(compileWarp(waves, { normals: 'pixel' }).normals, 'pixel')
  throwsWarpError(
    () => compileWarp(waves, { normals: 'pixels' }),
    /^compileWarp: expected true, false, 'vertex', 'pixel' or 'auto' for the option "normals", got the text "pixels"\.$/,
  )
})

describe('the code for pixels', () => {
  test('computes only the normal, which the code for vertices then omits', () => {
    const { code, emitFragment } = compileWarp(waves, { normals: 'pixel' })
    assert.doesNotMatch(code, /warpedNormal|cos/)
    const fragment = emitFragment()
    assert.match(fragment.code, /^vec3 warpedNormal;/)
    assert.doesNotMatch(fragment.code, /warpedPosition|offset/)
  })

  test('has names, outputs and a language of its own, and the tangent on demand', () => {
    const warp = compileWarp(waves, { tangents: true, names: { position: 'aPosition' } })
    const { code } = warp.emitFragment('wgsl', {
      names: { position: 'vRest' },
      outputs: { normal: 'n', tangent: 't' },
    })
    assert.match(code, /^var n: vec3f;\nvar t: vec4f;|^var n: vec3<f32>;/)
    assert.match(code, /vRest/)
    assert.doesNotMatch(code, /aPosition/)
    assert.match(warp.emitFragment().code, /aPosition/)
  })

  test('reads the same frame constants as the code for vertices', () => {
    const moving = ({ glsl, position, millis }) =>
      glsl.vec3(0, 0, position.x().mult(7).add(millis.div(900)).sin())
    const warp = compileWarp(moving, { perFrame: true })
    const frame = ({ uniforms }) => uniforms.map(({ name }) => name)
    assert.deepEqual(frame(warp.emitFragment()), frame(warp))
  })

  test('throws if normals are left out', () => {
    throwsWarpError(
      () => compileWarp(waves, { normals: false }).emitFragment(),
      /^emitFragment: the warp was compiled with "normals: false", which leaves normals out; compile it without this option\.$/,
    )
  })
})

test("'auto' calls the function of a uniform once more than the default does", () => {
  let calls = 0
  const strength = () => ++calls && 0.5
  const offset = (inputs) => waves(inputs).mult(inputs.uniforms.strength)
  compileWarp(offset, { uniforms: { strength } })
  const before = calls
  calls = 0
  compileWarp(offset, { normals: 'auto', uniforms: { strength } })
  assert.equal(calls, before + 1)
})
