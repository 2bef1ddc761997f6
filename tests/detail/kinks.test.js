// Functions whose slope jumps, on coarse meshes: the option `detail` draws their kinks. The truth are the formulas in plain numbers, at
// random points.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import {
  arraysOf,
  coarseMeshes,
  expectClose,
  raise,
  viewFrom,
  views,
} from '../support/detail-error.js'

const { abs, hypot, max, min } = Math

/** A case whose kink is where `distance` is zero, as a function of x and y. */
const kink = (offset, height, distance, near = 0.03) => ({
  offset: ({ glsl, position, uniforms }) =>
    raise(glsl, offset(position.x().sub(uniforms.shift), position.y(), glsl)),
  height: ([x, y], shift) => height(x - shift, y),
  isNear: ([x, y], shift) => abs(distance(x - shift, y)) < near,
})

const cases = {
  abs: kink(
    (x) => x.sub(0.137).abs(),
    (x) => abs(x - 0.137),
    (x) => x - 0.137,
  ),
  'abs of a slanted line': kink(
    (x, y) => y.mult(0.3).add(x).sub(0.137).abs(),
    (x, y) => abs(0.3 * y + x - 0.137),
    (x, y) => 0.3 * y + x - 0.137,
  ),
  'a ramp by max': kink(
    (x) => x.sub(0.2).max(0).mult(2),
    (x) => 2 * max(x - 0.2, 0),
    (x) => x - 0.2,
  ),
  'a steep clamp': kink(
    (x) => x.clamp(-0.31, 0.23).mult(3),
    (x) => 3 * min(max(x, -0.31), 0.23),
    (x) => min(abs(x + 0.31), abs(x - 0.23)),
  ),
  'the larger of x and y / 2': kink(
    (x, y) => x.max(y.mult(0.5)),
    (x, y) => max(x, 0.5 * y),
    (x, y) => x - 0.5 * y,
  ),
  'a branch': kink(
    (x, y, glsl) => x.gt(0.1).ifElse(x.sub(0.1).mult(2), glsl.val(0)),
    (x) => (x > 0.1 ? 2 * (x - 0.1) : 0),
    (x) => x - 0.1,
  ),
  'the tip of a cone': kink(
    (x, y, glsl) => glsl.length(glsl.vec2(x.sub(0.2), y.sub(0.1))).mult(2),
    (x, y) => 2 * hypot(x - 0.2, y - 0.1),
    (x, y) => hypot(x - 0.2, y - 0.1),
    0.12,
  ),
}

const still = (each) => ({
  ...each,
  offset: ({ uniforms, ...inputs }) => each.offset({ ...inputs, uniforms: { shift: 0 } }),
})

for (const [meshName, { z, ...mesh }] of Object.entries(coarseMeshes))
  for (const [name, each] of Object.entries(cases)) {
    test(`${name} on ${meshName}`, () => {
      const divided = createDetail(mesh, compileWarp(still(each).offset))
      for (const view of views) {
        divided.update(view)
        expectClose(divided, each, view)
      }
      divided.dispose()
    })
  }

test('a kink that a uniform moves is followed in each frame', () => {
  for (const { z, ...mesh } of Object.values(coarseMeshes))
    for (const name of ['abs', 'a ramp by max', 'the larger of x and y / 2']) {
      const divided = createDetail(
        mesh,
        compileWarp(cases[name].offset, { uniforms: { shift: 0 } }),
      )
      for (let i = 0; i <= 20; i++) {
        const shift = 0.034 * i - 0.4
        divided.update(views[0], { uniforms: { shift } })
        if (i % 5 === 0) expectClose(divided, cases[name], views[0], shift)
      }
      divided.dispose()
    }
})

// Cuts along a kink are flat on both sides, so that no triangle bends.
test('a kink along the cuts of a mesh is drawn', () => {
  const mesh = arraysOf(new THREE.PlaneGeometry(2, 2, 4, 4))
  const diagonal = kink(
    (x, y) => x.sub(y).abs(),
    (x, y) => abs(x - y),
    (x, y) => x - y,
  )
  const divided = createDetail(mesh, compileWarp(still(diagonal).offset))
  for (const view of views) {
    divided.update(view)
    expectClose(divided, diagonal, view)
  }
  divided.dispose()
})

test('a surface that only bends outside of the view is drawn', () => {
  const { z, ...mesh } = coarseMeshes['a plane of two triangles']
  const view = viewFrom([0.65, 0.1, 0.5], [0.65, 0, 0.15])
  for (const [name, each] of Object.entries(cases)) {
    const divided = createDetail(mesh, compileWarp(still(each).offset))
    divided.update(views[0])
    divided.update(view)
    expectClose(divided, { ...each, isNear: () => true }, view)
    assert.ok(divided.indices.length > 6, name)
    divided.dispose()
  }
})

/** Returns the number of triangles of a sphere of 720 triangles. */
function countTriangles(offset) {
  const { z, ...mesh } = coarseMeshes['a sphere of 24 × 16 parts']
  const divided = createDetail(mesh, compileWarp(offset))
  divided.update(views[0])
  const count = divided.indices.length / 3
  divided.dispose()
  return count
}

test('a limit without a kink costs nothing', () => {
  const kinked = countTriangles(({ glsl, position }) => raise(glsl, position.x().sub(0.2).max(0)))
  assert.ok(kinked > 1300, `a ramp: ${kinked} triangles`)
  const smooth = {
    'the square of a ramp': (x) => x.sub(0.2).max(0).pow(2),
    'x times abs(x)': (x) => x.mult(x.abs()).mult(0.5),
  }
  for (const [name, offset] of Object.entries(smooth)) {
    const count = countTriangles(({ glsl, position }) => raise(glsl, offset(position.x())))
    assert.ok(count < 1000, `${name}: ${count} triangles`)
  }
})
