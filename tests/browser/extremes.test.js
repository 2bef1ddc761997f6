// Normals in a shader where float32 overflows or underflows on the way to them: those of the exact derivative.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { extremes } from '../warps/extremes.js'
import { launchBrowser } from './support/browser.js'
import { stride } from './support/dense-mesh.js'
import { openPipeline, vertexShader } from './support/transform-feedback.js'

let browser, gpu

before(async () => {
  browser = await launchBrowser()
  gpu = await openPipeline(browser)
})
after(() => browser.close())

for (const { name, offset, points } of extremes)
  test(`the normal is finite, and right: ${name}`, async () => {
    const rest = Array(stride - 6).fill(0)
    await gpu.load(Float32Array.from(points.flatMap((p) => [...p.position, ...p.normal, ...rest])))
    const [results] = await gpu.run(vertexShader(compileWarp(offset), 'glsl300'), [{}])
    points.forEach(({ position, expected }, k) => {
      const found = [...results.subarray(6 * k + 3, 6 * k + 6)]
      found.forEach((x, i) =>
        assert.ok(Math.abs(x - expected[i]) < 1e-3, `${found}, not ${expected}, at ${position}`),
      )
    })
  })
