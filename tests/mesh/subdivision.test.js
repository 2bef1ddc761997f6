// Tests that `subdivide` makes coarse meshes bend accurately. Measures the error independently of the samples that `subdivide` takes.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { subdivide } from 'warpjet/mesh'
import { box } from '../support/coarse-meshes.js'
import { deviation, edgesNotUsed } from '../support/deviation.js'
import { cube as large, noiseWarps } from '../support/noise-warps.js'
import { sketchWarps } from '../warps/sketches.js'

const sketches = await sketchWarps()
/** Compiles the warp of a sketch, with or without normals. */
const warpOf = (sketchName, normals = false) =>
  compileWarp(sketches.find(({ name }) => name === sketchName).warp, { normals })

for (const tolerance of [2, 0.5])
  test(`a cube of 180 units with one edge per side becomes accurate to ${tolerance} units`, () => {
    const cube = box([90, 90, 90])
    const [warp, shape] = [warpOf('coarse-and-fine', true), warpOf('coarse-and-fine')]
    const uniforms = { millis: 1571 }
    assert.ok(deviation(cube, shape, uniforms, 2) > 20, 'the cube is accurate without subdivision')
    for (const angle of [0.17, Infinity]) {
      const fine = subdivide(cube, { warp, uniforms, tolerance, angle })
      const error = deviation(fine, shape, uniforms, 2)
      assert.ok(error <= tolerance, `${error}`)
      assert.deepEqual(edgesNotUsed(2, fine), [], 'expected no cracks')
      assert.equal(fine.warnings, undefined)
    }
  })

for (const [name, warp] of Object.entries(noiseWarps))
  test(`a cube warped by ${name} is accurate to the tolerance`, () => {
    for (const tolerance of [1, 0.5, 0.25]) {
      const fine = subdivide(large, { warp, tolerance, angle: Infinity })
      assert.equal(fine.warnings, undefined)
      // With four times as many samples, half as far apart, the measured error was only 2% larger.
      const error = deviation(fine, warp, {}, 1)
      assert.ok(error <= 0.97 * tolerance, `${error} of ${tolerance}`)
    }
  })

test('the test for cracks detects one', () => {
  const { positions, indices } = box([1, 1, 1])
  assert.equal(edgesNotUsed(2, { positions, indices: indices.subarray(3) }).length, 3)
})

test('if a warp bends only one part, at most a third of the triangles of uniform subdivision is needed', () => {
  const bar = box([100, 12.5, 20.6])
  const warp = warpOf('spoon')
  const uniforms = { millis: 2356 }
  for (const levels of [3, 4, 5]) {
    const uniform = subdivide(bar, { levels })
    const allowed = deviation(uniform, warp, uniforms, 2)
    const adaptive = subdivide(bar, { warp, uniforms, tolerance: allowed, angle: Infinity })
    const error = deviation(adaptive, warp, uniforms, 2)
    assert.ok(error <= allowed, `${error} of ${allowed}`)
    assert.deepEqual(edgesNotUsed(2, adaptive), [])
    const [adaptiveCount, uniformCount] = [adaptive, uniform].map(
      ({ indices }) => indices.length / 3,
    )
    assert.ok(adaptiveCount <= uniformCount / 3, `${adaptiveCount} of ${uniformCount}`)
  }
})
