// Draws a box that compute passes divide, seen from all sides.
import { beyondPixel, litPixels } from '../pixels.js'
import { paintSquares, swell } from '../swollen-box.js'
import { errors, startSketch, wait } from './sketches.js'

/** Draws a box from all positions of the camera. Returns the pictures. */
async function picturesOf(places, shape, detail = false) {
  let warp, squares
  const started = await startSketch({
    isSharp: true,
    setup(p) {
      warp = p.createWarp(swell, { detail })
      squares = p.createImage(240, 240)
      squares.loadPixels()
      squares.pixels.set(paintSquares())
      squares.updatePixels()
    },
    draw(p, i) {
      p.perspective(1, 1, 10, 1000)
      p.camera(...places[i], 0, 0, 0, 0, 1, 0)
      p.noStroke()
      p.texture(squares)
      warp()
      shape(p)
    },
  })
  if (detail) await started.begin()
  const pictures = []
  for (const i of places.keys()) {
    // The buffers may be too small at first.
    for (let k = 0; detail && k < 3; k++) {
      await started.picture(i)
      await wait(10)
    }
    const { image, draws } = await started.picture(i)
    if (detail && !draws[0]?.indirectBuffer)
      throw new Error('expected compute passes to divide the box, but the CPU did')
    pictures.push(image)
  }
  started.remove()
  return pictures
}

/** Compares a box, with and without detail, with a dense one. Returns the numbers of pixels for `checkPictures`. */
export async function compareAround({ places }) {
  const box = (p) => p.box(120)
  const dense = await picturesOf(places, (p) => p.warpBox(120, 120, 120, 48))
  const beyond = async (detail) => {
    const pictures = await picturesOf(places, box, detail)
    // All channels of colors are 0 or 255.
    return pictures.map((picture, i) => beyondPixel(picture, dense[i], 128))
  }
  return {
    covered: dense.map((picture) => litPixels(picture).length),
    divided: await beyond(1),
    rough: await beyond(8),
    coarse: await beyond(),
    errors: errors.splice(0),
  }
}
