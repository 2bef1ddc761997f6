// A baked mesh equals what the GPU draws, for each warp of the gallery on each model. tests/compile/normals.browser.test.js checks the same
// for all warps on a mesh with all attributes; tests/support/browser/baked.js has the tolerances.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compileWarp } from '../../dist/warpjet.js'
import { models } from '../../web/models/index.js'
import { withAccurateSine, withAccurateSineIfShort } from '../support/browser/accurate.js'
import { assertCpuEqualsGpu, compareCpuWithGpu } from '../support/browser/baked.js'
import { launchBrowser } from '../support/browser/browser.js'
import { maxDegrees, moments, positionAndNormal } from '../support/browser/compare.js'
import {
  arraysOf,
  denseMesh,
  interleave,
  layout,
  stride,
  vertices,
} from '../support/browser/dense-mesh.js'
import { angleBetween } from '../support/browser/oracle.js'
import { openPipeline, vertexShader } from '../support/browser/transform-feedback.js'
import { warpsInThisRun as warps } from '../warps/index.js'
import { normalGradients } from '../warps/normal-field.js'

const modelCache = new Map()

/** Returns a model in the size that the warp expects, with constant uvs if it has none, and with colors. */
function modelMesh(name, size) {
  // Generating a model takes longer than drawing it.
  if (!modelCache.has(name)) modelCache.set(name, models[name]())
  const { positions, normals, uvs } = modelCache.get(name)
  const mesh = new Float32Array((positions.length / 3) * stride)
  for (let i = 0; i < positions.length / 3; i++) {
    const [x, y, z] = [3 * i, 3 * i + 1, 3 * i + 2]
    const normal = [normals[x], normals[y], normals[z]]
    const [u, v] = uvs ? [uvs[2 * i], uvs[2 * i + 1]] : [0.25, 0.75]
    let at = i * stride
    for (const k of [x, y, z]) mesh[at++] = (positions[k] * size) / 100
    for (const number of [...normal, u, v, 0.5, 0.25, 1, 0.75]) mesh[at++] = number
    const gradients = normalGradients(normal, size)
    for (const name in gradients) for (const number of gradients[name]) mesh[at++] = number
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
  .filter(({ isGolden }) => isGolden)
  .map((warp) => ({ ...warp, compiled: warp.compile('glsl300') }))
  .filter(({ compiled }) => compiled.evaluate)
  // Picks some warps per model: neighbours in the list are similar.
  .filter((_, i) => isRun('every model') || i % 4 === 0)
const names = Object.keys(models)

for (const [i, warp] of cases.entries()) {
  const { name, compiled, size, params } = warp
  describe(`${name} on`, () => {
    for (const model of isRun('every model') ? names : [names[i % names.length]])
      test(model, async () => {
        const mesh = modelMesh(model, size)
        const draws = moments.map((moment) => ({ ...moment, ...params }))
        await gpu.load(mesh)
        const run = (text) => gpu.run(vertexShader(text, 'glsl300', params), draws)
        const best = withAccurateSineIfShort(compiled)
        const builtIn = await run(compiled)
        const exact = best === compiled ? builtIn : await run(best)
        const arrays = arraysOf(mesh, compiled.attributes)
        const baked = draws.map((uniforms) => interleave(compiled.evaluate(arrays, { uniforms })))
        const worst = compareCpuWithGpu(warp, mesh, draws, baked, { builtIn, exact })
        table.push({ warp: name, mesh: model, ...worst })
        assertCpuEqualsGpu(worst, warp.degrees)
      })
  })
}

test('baked tangents equal those that the GPU computes', async () => {
  // The shader reads the tangent from the color attribute, and returns it as the position.
  const warp = compileWarp(
    ({ glsl, position }) =>
      glsl.vec3(position.y().sin(), position.x().mult(position.z()), position.x().cos().mult(0.5)),
    { tangents: true, names: { tangent: 'color' } },
  )
  const mesh = denseMesh(1)
  const colorAt = layout.position + layout.normal + layout.uv
  const points = vertices(mesh).map((vertex, i) => {
    const [x, y, z] = vertex.normal
    const tangent = [y - z, z - x, x - y, i % 2 ? 1 : -1]
    mesh.set(tangent, i * stride + colorAt)
    return {
      ...vertex,
      tangent: [...mesh.subarray(i * stride + colorAt, i * stride + colorAt + 4)],
    }
  })
  await gpu.load(mesh)
  const code = `${warp.code}\nwarpedPosition = warpedTangent.xyz; warpedNormal.x = warpedTangent.w;`
  const text = withAccurateSine({ code, declarations: warp.declarations })
  const [gpuResults] = await gpu.run(vertexShader(text, 'glsl300'), [{}])
  const tangents = Float32Array.from(points.flatMap(({ tangent }) => tangent))
  const baked = warp.evaluate({ ...arraysOf(mesh, warp.attributes), tangents }).tangents
  points.forEach(({ tangent, normal }, i) => {
    const [direction, [side]] = positionAndNormal(gpuResults, i)
    assert.equal(side, tangent[3])
    assert.equal(baked[4 * i + 3], tangent[3])
    // If the length of the normal is not 1, or the tangent is zero, the result has no direction.
    if (Math.abs(Math.hypot(...normal) - 1) > 1e-3 || Math.hypot(...tangent.slice(0, 3)) < 1e-3)
      return
    const angle = angleBetween(direction, [...baked.subarray(4 * i, 4 * i + 3)])
    assert.ok(angle <= maxDegrees, `vertex ${i}: ${angle}°`)
  })
})
