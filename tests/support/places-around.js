// Positions of the camera, and checks of pictures, for tests that view divided shapes from all sides.
import assert from 'node:assert/strict'
import { randomNumbers } from './three-meshes.js'

/** Returns 20 positions in all directions, from 1.4 to 3.2 times `size` away from the origin, the same in each run. */
export function placesAround(size) {
  const random = randomNumbers(39)
  return Array.from({ length: 20 }, () => {
    const distance = size * (1.4 + 1.8 * random())
    const height = 2 * random() - 1
    const angle = 2 * Math.PI * random()
    const radius = Math.sqrt(1 - height ** 2)
    return [radius * Math.cos(angle), height, radius * Math.sin(angle)].map((x) => distance * x)
  })
}

/**
 * Checks pictures of a divided box against pictures of a dense box. All arguments are lists with a number of pixels for each position of
 * the camera. `covered` are the pixels that the dense box covers. The others are the pixels in which two pictures differ: pixels of either
 * picture whose color the other picture has nowhere within one pixel. They compare the dense box with a box that is divided to an error of
 * 1 pixel (`divided`) or of 8 pixels (`rough`), or not divided (`coarse`). A few pixels always differ, since a square of the texture that
 * is narrower than a pixel at an outline may be missing in one of the pictures.
 */
export function checkPictures({ covered, divided, rough, coarse }) {
  const sum = (counts) => counts.reduce((a, b) => a + b)
  const share = (counts) => sum(counts) / (2 * sum(covered))
  assert.ok(Math.min(...covered) > 5000)
  assert.ok(share(divided) < 0.001, `${share(divided)} of the pixels`)
  assert.ok(share(rough) > 0.005, `${share(rough)} with rough triangles`)
  assert.ok(share(coarse) > 0.5, `${share(coarse)} without detail`)
  for (const [i, count] of divided.entries())
    assert.ok(count < 0.002 * 2 * covered[i], `picture ${i}: ${count} of ${covered[i]} pixels`)
}
