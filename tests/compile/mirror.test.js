// Warps that mirror space: the outer side of a closed surface stays outside.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { compile, compileWarp } from 'warpjet'
import { chain, inflate, stretch, twist } from 'warpjet/deformers'
import { glslOffset } from 'warpjet/glsl'
import { bakeWarp } from 'warpjet/mesh'
import { warp as warpObject } from 'warpjet/three'
import { assertOutside, byUniform, cross, mirror, round, to } from '../support/mirrors.js'

const mirrors = {
  'a mirror': mirror,
  'a point reflection': ({ position }) => position.mult(-2),
  'two exchanged axes': to(({ glsl, position }) =>
    glsl.vec3(position.y(), position.x(), position.z()),
  ),
  'a mirror with a scale that grows to the side': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().mult(p.y().mult(p.y()).add(1)).neg(), p.y(), p.z()),
  ),
  'a mirror with a wave': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().neg(), p.y().add(p.x().mult(2).sin().mult(0.2)), p.z()),
  ),
  'a mirror with varying thickness': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().mult(p.z().mult(3).sin().mult(0.4).sub(1)), p.y(), p.z()),
  ),
  'a twisted mirror': chain(mirror, twist({ angle: 0.8, length: 1 })),
  'a twist, mirrored': chain(twist({ angle: 0.8, length: 1 }), mirror),
  'an inflated mirror': chain(mirror, inflate({ amount: 0.2 })),
  'a mirror twisted about an oblique axis': chain(
    mirror,
    twist({ angle: 0.8, length: 1, axis: [0.3, 1, -0.2] }),
  ),
  'a rotated mirror': chain(mirror, ({ glsl, position }) =>
    glsl
      .rotate(glsl.vec3(1, 2, 0.5), 0.7)
      .mult(position)
      .sub(position),
  ),
  'a mirror in GLSL source': glslOffset(
    'vec3 offset(vec3 position) { return vec3(-2.0 * position.x, 0.0, 0.0); }',
  ),
}

describe('the outer side stays outside', () => {
  for (const [name, offset] of Object.entries(mirrors))
    test(name, () => {
      assertOutside(round, 'before')
      for (const perFrame of [false, true])
        assertOutside(bakeWarp(round, compileWarp(offset, { perFrame })), name)
    })

  test('the normal at (1, 0, 0) of a sphere is (-1, 0, 0)', () => {
    const { normal, position } = compileWarp(mirror).evaluateAt([1, 0, 0], { normal: [1, 0, 0] })
    assert.deepEqual(
      [position, normal.map((x) => x + 0)],
      [
        [-1, 0, 0],
        [-1, 0, 0],
      ],
    )
  })

  test('a warp that does not mirror leaves triangles unchanged, and so does one that folds', () => {
    for (const offset of [
      twist({ angle: 0.8, length: 1 }),
      ({ glsl, position }) => glsl.vec3(position.x().mult(-2), position.y().mult(-2), 0),
      ({ glsl, position }) => glsl.vec3(position.x().mult(position.x()).mult(-1.5), 0, 0),
      ({ glsl, position }) => glsl.vec3(position.x().neg(), 0, 0),
    ])
      assert.deepEqual(bakeWarp(round, compileWarp(offset)).indices, round.indices)
  })

  test('normals are continuous at a fold', () => {
    // The derivative of x - x² changes its sign at 0.5; the surface y = 0 flips there, and so does the paper's normal.
    const fold = compileWarp(({ glsl, position }) =>
      glsl.vec3(position.x().mult(position.x()).neg(), position.x(), 0),
    )
    const at = (x) => fold.evaluateAt([x, 0, 0], { normal: [0, 1, 0] }).normal
    for (const x of [0.3, 0.499, 0.501, 0.7]) {
      const size = Math.hypot(1, 1 - 2 * x)
      const expected = [-1 / size, (1 - 2 * x) / size, 0]
      at(x).forEach((number, i) => assert.ok(Math.abs(number - expected[i]) < 1e-6, `${x}`))
    }
  })
})

describe('uniforms decide whether a warp mirrors', () => {
  const uniforms = { scale: 1 }
  const scaledOffsets = {
    'a width': byUniform,
    'a size': to(({ position, uniforms }) => position.mult(uniforms.scale)),
    'a width, twisted': chain(byUniform, twist({ angle: 0.8, length: 1 })),
    'a twist, then a width': chain(twist({ angle: 0.8, length: 1 }), byUniform),
    'a width that varies over the surface': to(({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(p.y().mult(p.y()).add(1)).mult(uniforms.scale), p.y(), p.z()),
    ),
    'a change that depends on a uniform': ({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(uniforms.scale.sub(1)), 0, 0),
    'a mirror of uniform width': to(({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(uniforms.scale.neg()), p.y().neg(), p.z()),
    ),
  }
  for (const [name, offset] of Object.entries(scaledOffsets))
    for (const perFrame of [false, true])
      test(`${name}${perFrame ? ', with frame constants' : ''}`, () => {
        const warp = compileWarp(offset, { uniforms, perFrame })
        for (const size of [1, 0.8, -0.8, -1, -1.5])
          assertOutside(bakeWarp(round, warp, { uniforms: { scale: size } }), `${size}`)
        // Without a value in the call, the value of the option applies.
        assertOutside(bakeWarp(round, warp), 'as declared')
      })

  test('the time can decide whether a warp mirrors', () => {
    const warp = compileWarp(
      to(({ glsl, position: p, millis }) =>
        glsl.vec3(p.x().mult(millis.div(1000).cos()), p.y(), p.z()),
      ),
      { perFrame: true },
    )
    for (const millis of [0, 500, 2700, 3100, 6283])
      assertOutside(bakeWarp(round, warp, { uniforms: { millis } }), `${millis}`)
  })

  test('the deformer stretch mirrors if it is pulled through itself', () => {
    const warp = compileWarp(stretch({ amount: ({ uniforms }) => uniforms.by }), {
      uniforms: { by: 0 },
    })
    for (const by of [0.5, -0.5, -2])
      assertOutside(bakeWarp(round, warp, { uniforms: { by } }), `${by}`)
  })

  test('normals of a collapsed surface are zero', () => {
    const warp = compileWarp(byUniform, { uniforms })
    const at = (normal) => warp.evaluateAt([0.6, 0.8, 0], { normal, uniforms: { scale: 0 } }).normal
    assert.deepEqual(at([0, 1, 0]), [0, 0, 0])
    assert.deepEqual(at([0.6, 0.8, 0]), [1, 0, 0])
  })

  test('the code has one sign factor, which is a frame constant', () => {
    const warp = compileWarp(byUniform, { uniforms, perFrame: true })
    const { warpjetFrame0 } = warp.frameUniforms({ scale: -3 })
    assert.ok(warpjetFrame0.includes(-1), `${warpjetFrame0}`)
    assert.ok(warp.frameUniforms({ scale: 3 }).warpjetFrame0.includes(1))
    for (const target of ['glsl300', 'glsl100', 'wgsl']) {
      const { code } = compileWarp(byUniform, { uniforms, target })
      assert.match(code, /scale < 0\.0/)
    }
  })

  test('the code of a warp that cannot mirror has no sign factor', () => {
    for (const offset of [
      to(({ glsl, position: p, uniforms }) =>
        glsl.vec3(p.x().mult(uniforms.scale.exp()), p.y(), p.z()),
      ),
      to(({ glsl, position, uniforms }) => glsl.rotateY(uniforms.scale).mult(position)),
      to(({ glsl, position, uniforms }) =>
        glsl.rotate(glsl.vec3(0.6, 0, 0.8), uniforms.scale).mult(position),
      ),
      twist({ angle: ({ uniforms }) => uniforms.scale, length: 1, axis: [0.6, 0, 0.8] }),
      to(({ glsl, position: p, uniforms }) =>
        glsl.vec3(p.x().mult(uniforms.scale), p.y().mult(uniforms.scale), p.z()),
      ),
    ])
      assert.doesNotMatch(compileWarp(offset, { uniforms }).code, /-1\.0 : 1\.0/)
  })
})

test('adjustNormal returns normals on the outer side', () => {
  const { evaluate } = compile((glsl) => {
    const position = glsl.vec3Param('position')
    const adjust = (factor) =>
      glsl.vec3(position.x().mult(factor), 0, 0).adjustNormal(glsl.vec3Param('normal'), position)
    return { byConstant: adjust(-2), byUniform: adjust(glsl.param('by')) }
  })
  const at = (by) => evaluate({ position: [1, 0, 0], normal: [1, 0, 0], by })
  assert.deepEqual(
    at(-3).byConstant.map((x) => x + 0),
    [-1, 0, 0],
  )
  assert.deepEqual(
    at(-3).byUniform.map((x) => x + 0),
    [-1, 0, 0],
  )
  assert.deepEqual(
    at(3).byUniform.map((x) => x + 0),
    [1, 0, 0],
  )
})

describe('offsets that depend on the normal and on uv', () => {
  const grown = ({ glsl, position, normal, uv }) =>
    glsl.vec3(position.x().mult(-2), 0, 0).add(
      normal.mult(
        uv
          .x()
          .mult(2 * Math.PI)
          .sin()
          .mult(0.1)
          .add(0.05),
      ),
    )

  for (const surfaceVariation of [true, false])
    test(`the outer side of a mirror inflated along the normal stays outside${surfaceVariation ? ', with surface variation' : ''}`, () => {
      const warp = compileWarp(grown, { surfaceVariation })
      const baked = bakeWarp(round, warp)
      assertOutside(baked, 'baked')
    })
})

test('the bitangent points where texture coordinates increase, also in a mirror', () => {
  const warp = compileWarp(
    to(({ glsl, position: p }) => glsl.vec3(p.x().neg(), p.y().add(p.x().sin().mult(0.3)), p.z())),
  )
  // On the plane z = 0, (t, b, n) is (x, y, z).
  const mesh = { positions: [0.4, 0.2, 0], normals: [0, 0, 1], tangents: [1, 0, 0, 1] }
  const { normals, tangents } = warp.evaluate(mesh)
  const [t, n] = [[...tangents.slice(0, 3)], [...normals]]
  const b = cross(n, t).map((x) => x * tangents[3])
  assert.deepEqual(
    n.map((x) => Math.round(x) + 0),
    [0, 0, 1],
  )
  // The derivative of the warped position along the original b is (0, 1, 0).
  assert.ok(b[1] > 0.9, `${b}`)
  const flipped = warp.evaluate({ ...mesh, tangents: [1, 0, 0, -1] })
  assert.equal(flipped.tangents[3], -tangents[3])
})

test('an image read at the same point for all vertices does not decide the side, since the CPU cannot read it', () => {
  const offset = ({ glsl, position, uniforms }) =>
    position.mult(glsl.texture(uniforms.map, glsl.vec2(0.5, 0.5)).x())
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 8, 6), new THREE.MeshBasicMaterial())
  const texture = new THREE.DataTexture(new Uint8Array([255, 0, 0, 255]), 1, 1)
  assert.doesNotThrow(() => warpObject(mesh, offset, { uniforms: { map: texture } }))
})
