// The option `detail`, seen from all sides: a divided box looks like a dense one within a pixel.
import { test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { beyondPixel, litPixels } from '../support/browser/pixels.js'
import { paintSquares, swell } from '../support/browser/swollen-box.js'
import { checkPictures, placesAround } from '../support/places-around.js'

/** Maps a name → the code that draws a box. */
const boxes = {
  dense: 'warps.own(); warpBox(120, 120, 120, 48)',
  divided: 'warps.divided(); box(120)',
  rough: 'warps.rough(); box(120)',
  coarse: 'warps.own(); box(120)',
}

const count = isRun('all 20 places') ? 20 : 5
for (const host of await openP5Hosts())
  test(`${host.name}: a divided box is within a pixel of a dense one from ${count} places`, async (t) => {
    const setup = `
      await setAttributes('antialias', false)
      // Compute passes would take over between two pictures. detail-compute.browser.test.js draws these pictures with them.
      if (${host.isWebGPU})
        p5.instance._renderer.device.createComputePipelineAsync = () => Promise.reject(new Error('none'))
      const swell = ${swell}
      ${paintSquares}
      warps.squares = createImage(240, 240)
      warps.squares.loadPixels()
      warps.squares.pixels.set(paintSquares())
      warps.squares.updatePixels()
      warps.own = createWarp(swell)
      warps.divided = createWarp(swell, { detail: 1 })
      warps.rough = createWarp(swell, { detail: 8 })`
    const places = placesAround(120).slice(0, count)
    const scenes = {}
    for (const [i, place] of places.entries())
      for (const [name, code] of Object.entries(boxes))
        scenes[`${name} ${i}`] = `perspective(1, 1, 10, 1000); camera(${place}, 0, 0, 0, 0, 1, 0);
          noStroke(); texture(warps.squares); ${code}`
    const images = await host.draw({ size: 240, setup, scenes })
    const found = { covered: places.map((_, i) => litPixels(images[`dense ${i}`]).length) }
    for (const name of ['divided', 'rough', 'coarse'])
      found[name] = places.map((_, i) =>
        // All channels of colors are 0 or 255.
        beyondPixel(images[`${name} ${i}`], images[`dense ${i}`], 128),
      )
    t.diagnostic(JSON.stringify(found))
    checkPictures(found)
  })
