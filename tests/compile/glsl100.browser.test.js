// The code for WebGL 1 compiles there, and has the same results as the code for WebGL 2.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowser } from '../support/browser/browser.js'
import { denseMesh } from '../support/browser/dense-mesh.js'
import { openPipeline, vertexShader } from '../support/browser/transform-feedback.js'
import { warpsInThisRun as warps } from '../warps/index.js'

let browser
before(async () => (browser = await launchBrowser()))
after(() => browser.close())

test('every warp links in WebGL 1', async () => {
  const gpu = await openPipeline(browser, 'webgl')
  for (const { compile, params } of warps)
    await gpu.link(vertexShader(compile('glsl100'), 'glsl100', params))
})

// WebGL 1 has no transform feedback, but WebGL 2 accepts its shaders.
test('the code for WebGL 1 and WebGL 2 has the same results', async () => {
  const gpu = await openPipeline(browser)
  const inputs = { millis: 1234, mouse: [120, 250], size: [640, 480], pixelDensity: 2 }
  const compared = warps.filter(({ name }) => /twist|wobble|genie|flatten|space|ifElse/.test(name))
  for (const { name, compile, size, params } of compared) {
    await gpu.load(denseMesh(size))
    const [first, second] = await Promise.all(
      ['glsl100', 'glsl300'].map((target) =>
        gpu.run(vertexShader(compile(target), target, params), [{ ...inputs, ...params }]),
      ),
    )
    assert.deepEqual(first, second, name)
  }
})
