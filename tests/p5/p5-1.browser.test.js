// A smoke test of p5 1.11, the other supported version; `npm test -- --all` also runs every other test of sketches on it.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { colorAt } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5Versions } from '../support/browser/sketch.js'

const { browser, server } = await openHost()

test('p5 1.11 draws warps that move, are lit by their normals, and read uniforms', async () => {
  const scripts = [p5Versions['1.11'], '/dist/p5.warpjet.min.js', '/dist/warpjet.deformers.min.js']
  const { moved, slope } = await drawScenes(browser, server, scripts, {
    setup: `
      warps.move = createWarp(({ glsl, uniforms }) => glsl.vec3(uniforms.far, 0, 0), {
        space: 'world', uniforms: { far: 10 } })
      warps.slope = createWarp(warpjet.shear({ axis: 'x', direction: 'z', amount: -0.5 }),
        { type: 'normal', space: 'world' })`,
    scenes: {
      moved: `warps.move({ far: 40 }); fill('red'); plane(20)`,
      slope: `ortho(); warps.slope(); plane(100)`,
    },
  })
  assert.deepEqual(colorAt(moved, 140, 100), [255, 0, 0])
  assert.deepEqual(colorAt(moved, 100, 100), [0, 0, 0])
  // The normal of z = -x / 2.
  const normal = [0.5, 0, 1].map((x) => x / Math.hypot(0.5, 1))
  colorAt(slope, 100, 100).forEach((value, i) =>
    assert.ok(Math.abs(value - 255 * normal[i]) <= 1, `channel ${i}: ${value}`),
  )
})
