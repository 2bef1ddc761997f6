// An offset function is called only once, even if shader code is generated several times. A warp whose offset function calls Math.random()
// therefore always looks the same.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { launchBrowser } from '../support/browser/browser.js'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { drawScenes, p5Versions } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

for (const [version, p5] of Object.entries(p5Versions)) {
  describe(`a random warp on p5 ${version}`, () => {
    test('stays the same on a new renderer, with another material, and after a lost context', async () => {
      const shape = `background(0); distort(); fill('red'); lights(); sphere(50)`
      const images = await drawScenes(browser, server, [p5, addon], {
        setup: `
          setAttributes({ antialias: false })
          calls = 0
          distort = createWarp(({ glsl, position }) => {
            if (calls++) throw new Error('called twice')
            const bumps = position.mult(5).add(Math.random() * 6).sin().mult(0.1 + 0.1 * Math.random())
            return glsl.vec3(bumps.y(), bumps.z(), bumps.x())
          })`,
        scenes: {
          first: shape,
          normals: `normalMaterial(); ${shape}`,
          afterNormals: shape,
          attributes: `setAttributes({ antialias: false, alpha: false }); ${shape}`,
          webgl1: `setAttributes({ antialias: false, version: 1 }); ${shape}`,
          lost: `
            drawingContext.getExtension('WEBGL_lose_context').loseContext()
            setAttributes({ antialias: false, version: 2 })
            ${shape}`,
        },
      })
      assert.ok(litPixels(images.first).length > 2000)
      for (const name of ['afterNormals', 'attributes', 'webgl1', 'lost'])
        assert.ok(
          differingPixels(images.first, images[name], 12) < 40,
          `${name}: ${differingPixels(images.first, images[name], 12)}`,
        )
      // Makes all pixels but black ones white.
      const silhouette = ({ width, height, data }) => ({
        width,
        height,
        data: data.map((value, i) =>
          i % 4 < 3 && data.subarray(i - (i % 4), i - (i % 4) + 3).some(Boolean) ? 255 : 0,
        ),
      })
      assert.ok(differingPixels(silhouette(images.first), silhouette(images.normals), 0) < 40)
    })
  })
}
