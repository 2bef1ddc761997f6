// Compares positions and normals of a vertex shader, and of `evaluate` on the CPU, with an oracle in double precision, and with each
// other. Prints a table of the measured errors at the end.
//
// There are two bounds on normals, since SwiftShader, which replaces a GPU here, computes sin and cos only to 2e-4:
// - with an accurate sine in GLSL instead of the built-in one: the warp's `degrees` (0.02° for nearly all warps) wherever the warp is
//   smooth;
// - with the built-in sine: 0.02° at 99% of the vertices, and at all of them 0.02° times the sensitivity of the normal to errors of the
//   derivatives (2e-4 is 0.0115°).
// Excluded are vertices near a kink of the warp, and those where the surface has nearly collapsed, to 1/100,000 of its area, so that
// float32 cannot represent its direction to 0.02°.
//
// The bounds on positions are 2e-5 with the accurate sine and 1e-3 with the built-in one, relative to `reach`, the size of the numbers in
// the formula. At `millis` 98,765 the angles of these warps reach 1,000, where the spacing of float32 is 6e-5.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { withAccurateSine, withAccurateSineIfShort } from '../support/browser/accurate.js'
import { assertCpuEqualsGpu, compareCpuWithGpu } from '../support/browser/baked.js'
import { launchBrowser } from '../support/browser/browser.js'
import { compare, moments } from '../support/browser/compare.js'
import { arraysOf, denseMesh, interleave, stride, vertices } from '../support/browser/dense-mesh.js'
import { warpVertex } from '../support/browser/oracle.js'
import { openPipeline, vertexShader } from '../support/browser/transform-feedback.js'
import { orphans, warpsInThisRun as warps } from '../warps/index.js'

const thinning = isRun('every vertex') ? 1 : 3

const positionBound = { exact: 2e-5, builtIn: 1e-3 }

let browser, gpu
const table = []

before(async () => {
  browser = await launchBrowser()
  gpu = await openPipeline(browser)
})
after(async () => {
  await browser.close()
  console.table(table)
})

test('every oracle of the gallery has its sketch', () => assert.deepEqual(orphans, []))

test('the accurate sine, cosine and arc cosine are accurate', async () => {
  const angles = Array.from({ length: 2000 }, (_, i) => Math.fround(i - 1000 + i / 2010))
  await gpu.load(
    Float32Array.from(angles.flatMap((x) => [x, x / 1001, ...Array(stride - 2).fill(0)])),
  )
  const code = `vec3 warpedPosition = vec3(sin(position.x), cos(position.x), acos(position.y));
vec3 warpedNormal = normal;`
  const [results] = await gpu.run(
    vertexShader(withAccurateSine({ code, declarations: '' }), 'glsl300'),
    [{}],
  )
  angles.forEach((x, i) => {
    const expected = [Math.sin(x), Math.cos(x), Math.acos(Math.fround(x / 1001))]
    expected.forEach((value, k) => {
      const difference = Math.abs(results[6 * i + k] - value)
      assert.ok(difference < 1e-6, `${difference} off at ${x}`)
    })
  })
})

/** Returns whether the square of a number is subnormal: GPUs flush such a square to 0, unlike the CPU. */
const isTiny = (x) => x !== 0 && Math.abs(x) <= 1e-15

describe('positions and normals are correct:', () => {
  for (const warp of warps)
    test(warp.name, async () => {
      const { compile, offset, size, step, every, reach, params, mirrors } = warp
      assert.ok(offset, `tests/warps/gallery.js has no oracle for ${warp.name}`)
      const mesh = denseMesh(size, every * thinning)
      const points = vertices(mesh)
      const draws = moments.map((moment) => ({ ...moment, ...params }))
      await gpu.load(mesh)
      const expected = draws.map((inputs) =>
        points.map((vertex) => warpVertex(offset, vertex, inputs, step, mirrors)),
      )
      const compiled = compile('glsl300')
      const best = withAccurateSineIfShort(compiled)
      const run = (text) => gpu.run(vertexShader(text, 'glsl300', params), draws)
      const builtIn = await run(compiled)
      const exact = best === compiled ? builtIn : await run(best)
      assertOnGpu(warp, ...[builtIn, exact].map((r) => compare(r, expected, reach, warp.degrees)))

      // Two sketches use `gen`, whose results have no `evaluate`.
      if (!compiled.evaluate) return
      const onCpu = draws.map((uniforms) =>
        interleave(compiled.evaluate(arraysOf(mesh, compiled.attributes), { uniforms })),
      )
      assertOnCpu(warp, onCpu, expected, points)
      const worst = compareCpuWithGpu(warp, mesh, draws, onCpu, { builtIn, exact }, expected)
      assertCpuEqualsGpu(worst, warp.degrees)
    })
})

function assertOnGpu({ name, degrees, collapses }, builtIn, exact) {
  table.push(row(name, builtIn, exact))

  assert.equal(builtIn.notFinite + exact.notFinite, 0, 'NaN or infinite')
  if (collapses) assert.equal(exact.notZero, 0, 'normals that should be zero')
  assert.ok(exact.kinks + exact.collapsing < 0.05 * exact.count, 'too many vertices are excluded')
  assert.ok(exact.length < 1e-6, `normals are ${exact.length} off length 1`)

  assert.ok(exact.angle <= degrees, `normals are ${exact.angle}° off`)
  assert.ok(builtIn.relativeAngle <= degrees, `normals are ${builtIn.relativeAngle}° off`)
  assert.ok(
    builtIn.beyond <= 0.01 * builtIn.count,
    `${builtIn.beyond} normals are more than ${degrees}° off`,
  )
  assert.ok(exact.position <= positionBound.exact, `positions are ${exact.position} off`)
  assert.ok(builtIn.position <= positionBound.builtIn, `positions are ${builtIn.position} off`)
}

function assertOnCpu({ degrees, reach, collapses }, onCpu, expected, points) {
  const isCompared = points.map(({ normal }) => !normal.some(isTiny))
  const actual = compare(
    onCpu.map((results) => results.filter((_, i) => isCompared[Math.floor(i / 6)])),
    expected.map((moment) => moment.filter((_, i) => isCompared[i])),
    reach,
    degrees,
  )
  assert.equal(actual.notFinite, 0, 'on the CPU, NaN or infinite')
  if (collapses) assert.equal(actual.notZero, 0, 'on the CPU, normals that should be zero')
  assert.ok(actual.length < 1e-6, `on the CPU normals are ${actual.length} off length 1`)
  assert.ok(actual.angle <= degrees, `on the CPU normals are ${actual.angle}° off`)
  assert.ok(actual.position <= 2e-5, `on the CPU positions are ${actual.position} off`)
}

function row(name, builtIn, exact) {
  const percent = (value) => `${((100 * value) / exact.count).toFixed(1)}%`
  return {
    warp: name,
    'position off': exact.position.toExponential(0),
    'normal off': `${exact.angle.toFixed(5)}°`,
    'built-in sine: position': builtIn.position.toExponential(0),
    'built-in sine: normal': `${builtIn.angle.toFixed(3)}°`,
    beyond: builtIn.beyond,
    kinks: percent(exact.kinks),
    collapsing: percent(exact.collapsing),
    'no normal': percent(exact.vanishing),
  }
}
