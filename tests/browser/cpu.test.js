// A bake equals the screen: what `evaluate` computes against what a vertex shader computes, for every warp of the gallery
// on every mesh of the gallery, and for all other warps on one that has everything.
//
// Positions agree to 1e-5 of the numbers in the formula, normals to 0.02° or what the warp says, with an accurate sine in GLSL in place of the
// built-in one. At `millis` 98,765, where angles reach 1,000 and float32 is no finer than 6e-5, positions agree to 2e-5, as
// they do with the oracle in double. SwiftShader's own sine is 2e-4 off, and with it positions agree to 1e-3. Left out are vertices where the oracle finds a
// kink nearby, on whose sides two roundings may differ, and those where the surface has all but collapsed.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { models } from '../../web/models/index.js'
import { warpsInThisRun as warps } from '../warps/index.js'
import { asAccurateAsCanBe, withAccurateSine } from './support/accurate.js'
import { launchBrowser } from './support/browser.js'
import { degrees, moments, mostSensitive } from './support/compare.js'
import { arraysOf, denseMesh, interleaved, stride, vertices } from './support/dense-mesh.js'
import { angleBetween, distanceBetween, warpVertex } from './support/oracle.js'
import { openPipeline, vertexShader } from './support/transform-feedback.js'

const positionBound = { exact: 1e-5, late: 2e-5, builtIn: 1e-3 }

/** A model as large as the warp expects, with uvs and colors made up where it has none. */
function modelMesh(make, size) {
  const { positions, normals, uvs } = make()
  const mesh = new Float32Array((positions.length / 3) * stride)
  for (let i = 0; i < positions.length / 3; i++) {
    const position = [0, 1, 2].map((k) => (positions[3 * i + k] * size) / 100)
    const normal = [0, 1, 2].map((k) => normals[3 * i + k])
    const uv = uvs ? [uvs[2 * i], uvs[2 * i + 1]] : [0.25, 0.75]
    mesh.set([...position, ...normal, ...uv, 0.5, 0.25, 1, 0.75], i * stride)
  }
  return mesh
}

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

const cases = warps
  .map((warp) => ({ ...warp, compiled: warp.compile('glsl300') }))
  .filter(({ compiled }) => compiled.evaluate)

for (const warp of cases) {
  const { name, compiled, offset, size, step, degrees, every, reach, params, kept } = warp
  const meshes = { 'sphere, cube and oddities': () => denseMesh(size, every) }
  if (kept)
    for (const [model, make] of Object.entries(models)) meshes[model] = () => modelMesh(make, size)

  describe(`${name} on`, () => {
    for (const [meshName, make] of Object.entries(meshes))
      test(meshName, async () => {
        const mesh = make()
        const points = vertices(mesh)
        const draws = moments.map((moment) => ({ ...moment, ...params }))
        await gpu.load(mesh)
        const exact = asAccurateAsCanBe(compiled)
        const shown = await gpu.run(vertexShader(exact, 'glsl300', params), draws)
        const builtIn = await gpu.run(vertexShader(compiled, 'glsl300', params), draws)
        const worst = { position: 0, angle: 0, builtIn: 0, leftOut: 0 }
        draws.forEach((uniforms, k) => {
          const baked = interleaved(compiled.evaluate({ ...arraysOf(points), uniforms }))
          const atBest = uniforms.millis > 1e4 ? positionBound.late : positionBound.exact
          const bound = exact === compiled ? positionBound.builtIn : atBest
          points.forEach((vertex, i) => {
            const [position, normal] = parts(baked, i)
            const scale = Math.max(reach, Math.hypot(...position))
            const [shownPosition, shownNormal] = parts(shown[k], i)
            const bothZero = ![...normal, ...shownNormal].some(Boolean)
            const angle = bothZero ? 0 : angleBetween(normal, shownNormal)
            const distance = distanceBetween(position, shownPosition) / scale
            if (angle > degrees || distance > bound) {
              const truth = warpVertex(offset, vertex, uniforms, step)
              if (!truth.normal?.some(Boolean) || truth.sensitivity > mostSensitive)
                return worst.leftOut++
            }
            worst.position = Math.max(worst.position, distance / bound)
            worst.angle = Math.max(worst.angle, angle)
            const [roughPosition] = parts(builtIn[k], i)
            worst.builtIn = Math.max(
              worst.builtIn,
              distanceBetween(position, roughPosition) / scale,
            )
          })
        })
        table.push({ warp: name, mesh: meshName, ...worst })
        assert.ok(
          worst.position <= 1,
          `positions are ${worst.position} times as far off as allowed`,
        )
        assert.ok(worst.angle <= degrees, `normals are ${worst.angle}° off`)
        assert.ok(worst.builtIn <= positionBound.builtIn, `${worst.builtIn} off by the own sine`)
        assert.ok(worst.leftOut <= 0.1 * draws.length * points.length, 'too much is left out')
      })
  })
}

test('tangents', async () => {
  // The tangent comes in by the attribute of the color, and goes out by the position.
  const warp = compileWarp(
    ({ glsl, position }) =>
      glsl.vec3(position.y().sin(), position.x().mult(position.z()), position.x().cos().mult(0.5)),
    { tangents: true, names: { tangent: 'color' } },
  )
  const mesh = denseMesh(1)
  const points = vertices(mesh).map((vertex, i) => {
    const [x, y, z] = vertex.normal
    const tangent = [y - z, z - x, x - y, i % 2 ? 1 : -1]
    mesh.set(tangent, (i + 1) * stride - 4)
    return { ...vertex, tangent: [...mesh.subarray((i + 1) * stride - 4, (i + 1) * stride)] }
  })
  await gpu.load(mesh)
  const code = `${warp.code}\nwarpedPosition = warpedTangent.xyz; warpedNormal.x = warpedTangent.w;`
  const text = withAccurateSine({ code, declarations: warp.declarations })
  const [shown] = await gpu.run(vertexShader(text, 'glsl300'), [{}])
  const tangents = Float32Array.from(points.flatMap(({ tangent }) => tangent))
  const baked = warp.evaluate({ ...arraysOf(points), tangents }).tangents
  points.forEach(({ tangent, normal }, i) => {
    const [direction, [side]] = parts(shown, i)
    assert.equal(side, tangent[3])
    assert.equal(baked[4 * i + 3], tangent[3])
    // Where the normal comes with an odd length, or the tangent is nothing, there is no direction.
    if (Math.abs(Math.hypot(...normal) - 1) > 1e-3 || Math.hypot(...tangent.slice(0, 3)) < 1e-3)
      return
    const angle = angleBetween(direction, [...baked.subarray(4 * i, 4 * i + 3)])
    assert.ok(angle <= degrees, `vertex ${i}: ${angle}°`)
  })
})

/** Position and normal of a vertex among six numbers each. */
const parts = (results, i) => [0, 3].map((at) => [...results.subarray(6 * i + at, 6 * i + at + 3)])
