// Compares pictures of warps with pictures of the same motion that p5 itself draws, or of the same warp written in another way.
import assert from 'node:assert/strict'
import { beyondEdges, differingPixels, litPixels } from './pixels.js'

/**
 * Draws the pairs of a table on a host, and compares them:
 * - `setup`, `size`, `files`: as for `drawScenes`.
 * - `pairs`: maps a name to the code of two scenes, and optionally of a third one that must look different.
 * - `lit`: the second picture must have more lit pixels than this.
 * - `tolerance`: pixels count as equal if no channel differs by more.
 * - `differing`: the max number of unequal pixels or, if below 1, their fraction of the lit ones. Can be a function of the pair's name.
 * - `different`: [number or fraction of pixels, tolerance]: more pixels than this must differ from the third picture.
 * - `withinEdges`: 'first' or 'both': the picture or pictures in which no pixel may be outside the range of the 3 × 3 pixels at the same
 *   place in the other picture.
 * - `view`: transforms each picture before it is compared.
 * - `check`: makes further assertions; its argument maps names of pairs → [first, second, third] picture.
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
    const [image, expected, third] = imagesOf(pair).map(view)
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
    if (!third) continue
    const [minCount, thirdTolerance] = different
    const changed = differingPixels(image, third, thirdTolerance)
    assert.ok(
      changed > (minCount < 1 ? minCount * count : minCount),
      `${name}: only ${changed} pixels differ from the third picture`,
    )
  }
  check?.(Object.fromEntries(Object.entries(pairs).map(([name, pair]) => [name, imagesOf(pair)])))
}
