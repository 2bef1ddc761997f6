// Tests of detail from all sides share these places and checks.
import assert from 'node:assert/strict'
import { randomNumbers } from './three-meshes.js'

/** Returns 20 places in all directions, from 1.4 to 3.2 times `size` away from the origin, the same in each run. */
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
 * Checks pictures of a divided box against those of a dense one, from several places: `covered` has the numbers of pixels that the dense
 * box covers, and the other lists those of pixels that either picture shows nowhere within a pixel in the other one. The triangles of
 * `rough` may be 6 pixels off, and those of `coarse` are not divided. Next to outlines there are squares narrower than a pixel, which may
 * lack.
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
