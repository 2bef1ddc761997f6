// Compares pictures of warps with pictures of the same motion by p5 itself, or by another way to write the same warp.
import assert from 'node:assert/strict'
import { beyondEdges, differingPixels, litPixels } from './pixels.js'

/**
 * Draws the pairs of a table on a host, and compares them:
 * - `setup`, `size`, `files`: as for `drawScenes`.
 * - `pairs`: maps a name to the code of two scenes, and optionally of a third one that must look different.
 * - `lit`: the second picture has more lit pixels than this.
 * - `tolerance`: the max difference of equal pixels, in each channel.
 * - `differing`: the max number of other pixels, or their share of the lit ones. A function of the pair's name, or a number.
 * - `different`: [number or share of pixels, tolerance]: more pixels differ from the third picture.
 * - `withinEdges`: 'first' or 'both', the pictures whose pixels may not lie outside the range of the other picture's neighbours.
 * - `view`: applied to each picture before it is compared.
 * - `check`: gets the pictures by pair, [first, second, third], for what the table tests beyond that.
 */
export async function comparePictures(host, table) {
  const { pairs, lit, tolerance, differing, different, withinEdges, check } = table
  const { view = (image) => image } = table
  const codes = [...new Set(Object.values(pairs).flat())]
  const { setup, size, files } = table
  const drawn = await host.draw({
    ...{ setup, size, ...(files && { files }) },
    scenes: Object.fromEntries(codes.map((code, i) => [i, code])),
  })
  const imagesOf = (pair) => pair.map((code) => drawn[codes.indexOf(code)])
  for (const [name, pair] of Object.entries(pairs)) {
    const [image, expected, other] = imagesOf(pair).map(view)
    const count = litPixels(expected).length
    assert.ok(count > lit, `${name}: ${count} pixels are lit`)
    const found = differingPixels(image, expected, tolerance)
    const bound = typeof differing === 'function' ? differing(name) : differing
    assert.ok(
      bound > 0 && bound < 1 ? found < bound * count : found <= bound,
      `${name}: ${found} of ${count} pixels differ`,
    )
    if (withinEdges) assert.equal(beyondEdges(image, expected, tolerance), 0, name)
    if (withinEdges === 'both') assert.equal(beyondEdges(expected, image, tolerance), 0, name)
    if (!other) continue
    const [atLeast, more] = different
    const changed = differingPixels(image, other, more)
    assert.ok(
      changed > (atLeast < 1 ? atLeast * count : atLeast),
      `${name}: only ${changed} pixels differ from the other picture`,
    )
  }
  check?.(Object.fromEntries(Object.entries(pairs).map(([name, pair]) => [name, imagesOf(pair)])))
}
