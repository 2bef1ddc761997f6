// Narrow peaks and steps on coarse meshes: the option `detail` finds them between the vertices. The truth are the formulas in plain
// numbers, at random points.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import { glslOffset } from 'warpjet/glsl'
import {
  expectClose,
  coarseMeshes as meshes,
  raise,
  viewFrom,
  views,
} from '../support/detail-error.js'

const { abs, exp, tanh } = Math

const dot = (a, b) => a.x().mult(b.x()).add(a.y().mult(b.y())).add(a.z().mult(b.z()))
const smoothstep = (low, high, x) => {
  const t = Math.min(1, Math.max(0, (x - low) / (high - low)))
  return t * t * (3 - 2 * t)
}

/** A peak of exp(-1000 r²) at a place of the mesh. A uniform moves it along x. */
const bump = (x, y) => (z) => ({
  offset({ glsl, position, uniforms }) {
    const d = position.sub(glsl.vec3(uniforms.shift.add(x), y, z(x, y)))
    return raise(glsl, dot(d, d).mult(-1000).exp())
  },
  height: (p, shift) => exp(-1000 * squareOfDistance(p, [x + shift, y, z(x, y)])),
  isNear: (p, shift) => squareOfDistance(p, [x + shift, y, z(x, y)]) < 0.12 ** 2,
})
const squareOfDistance = (p, q) => p.reduce((sum, a, i) => sum + (a - q[i]) ** 2, 0)

/** A peak of (1 + 300 r²)⁻² at a place of the mesh, r being the distance from an axis along z. */
const spike = (x, y) => () => ({
  offset({ glsl, position }) {
    const d = position.sub(glsl.vec3(x, y, 0))
    const square = d.x().mult(d.x()).add(d.y().mult(d.y()))
    return raise(glsl, square.mult(300).add(1).pow(-2))
  },
  height: (p) => (1 + 300 * ((p[0] - x) ** 2 + (p[1] - y) ** 2)) ** -2,
  isNear: (p) => (p[0] - x) ** 2 + (p[1] - y) ** 2 < 0.12 ** 2,
})

/** A function of x. */
const along = (offset, height, isNear) => () => ({
  offset: ({ glsl, position }) => raise(glsl, offset(position.x(), glsl)),
  height: (p) => height(p[0]),
  isNear: (p) => isNear(p[0]),
})

const cases = {
  'a bump in the middle': bump(0, 0),
  'a bump off the middle': bump(0.13, 0.27),
  'a negative power': spike(0.13, 0.27),
  'waves in a loop': () => ({
    offset: glslOffset(`
      uniform float shift;
      vec3 offset(vec3 position) {
        float height = 0.0;
        for (int i = 1; i <= 12; i++) {
          float wave = sin((position.x - shift) * 3.0 * float(i) + position.y * float(i * i) * 0.3);
          height += wave * wave * wave / float(i * i);
        }
        return vec3(0.0, 0.0, 0.3 * height);
      }`),
    height(p) {
      let sum = 0
      for (let i = 1; i <= 12; i++) sum += Math.sin(p[0] * 3 * i + p[1] * i * i * 0.3) ** 3 / i ** 2
      return sum
    },
    isNear: () => true,
  }),
  'a smoothstep of width 0.04': along(
    (x, glsl) => glsl.smoothstep(0.37, 0.41, x),
    (x) => smoothstep(0.37, 0.41, x),
    (x) => abs(x - 0.39) < 0.05,
  ),
  'tanh(50 x)': along(
    (x) => x.sub(0.0137).mult(50).tanh(),
    (x) => tanh(50 * (x - 0.0137)),
    (x) => abs(x - 0.0137) < 0.1,
  ),
}

for (const [meshName, { z, ...mesh }] of Object.entries(meshes))
  for (const [name, make] of Object.entries(cases))
    test(`${name} on ${meshName}`, () => {
      const each = make(z)
      const warp = compileWarp(each.offset, { uniforms: { shift: 0 } })
      const divided = createDetail(mesh, warp)
      for (const view of views) {
        divided.update(view)
        expectClose(divided, each, view)
      }
      divided.dispose()
    })

test('a bump that a uniform moves is followed, and leaves no trail', () => {
  for (const { z, ...mesh } of Object.values(meshes)) {
    const each = bump(-0.4, 0.1)(z)
    const warp = compileWarp(each.offset, { uniforms: { shift: 0 } })
    const divided = createDetail(mesh, warp)
    const counts = []
    for (let i = 0; i <= 40; i++) {
      const shift = 0.017 * i
      divided.update(views[0], { uniforms: { shift } })
      counts.push(divided.indices.length / 3)
      if (i % 8 === 0) expectClose(divided, each, views[0], shift)
    }
    // The mesh is cut anew after a few frames, so that there are never many more triangles than at first, and in some frames hardly any more.
    assert.ok(Math.max(...counts) < 4 * counts[0], `${counts}`)
    assert.ok(Math.min(...counts.slice(-10)) < 1.3 * counts[0], `${counts}`)
    divided.dispose()
  }
})

// Each factor is the product of the two before it, so that the last one is a product of ten billion shared factors.
test(
  'a division by a product of many shared factors is compiled at once',
  { timeout: 20_000 },
  () => {
    const warp = compileWarp(
      ({ glsl, position }) => {
        let [product, before] = [position.x().add(2), position.y().add(3)]
        for (let i = 0; i < 50; i++) [product, before] = [product.mult(before), product]
        return glsl.vec3(0, glsl.val(1).div(product), 0)
      },
      { normals: false },
    )
    const divided = createDetail({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }, warp)
    divided.update(viewFrom([0, 0, 4]))
    assert.ok(divided.indices.length >= 3)
    divided.dispose()
  },
)
