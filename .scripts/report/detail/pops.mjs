// Measures pops: how far the drawn surface jumps when the option `detail` divides a mesh again, while camera and warp move slowly.
import * as THREE from 'three'
import { createDetail } from '../../../dist/detail.js'
import { copyDivision, markPlaces, popsBetween } from '../../../tests/support/pops.js'
import { quantile } from '../../../tests/support/screen-error.js'
import { randomNumbers } from '../../../tests/support/three-meshes.js'
import { chooseTriangles, scale, viewFrom } from './cases.mjs'

const frames = 200
/** The number of random triangles of each division that are measured. */
const maxTriangles = 300
/** The change of the inputs of warps per frame. */
const steps = { millis: 16, bend: 0.005 }

/**
 * Returns the view in a frame. The camera circles the mesh by half a degree per frame, and its distance changes from 4 to 2.4 times
 * `halfSize` and back.
 */
function viewAt(frame, halfSize) {
  const distance = halfSize * (3.2 + 0.8 * Math.cos((2 * Math.PI * frame) / frames))
  const angle = (frame * Math.PI) / 360
  return viewFrom(new THREE.Vector3().setFromSphericalCoords(distance, 1.1, angle), halfSize)
}

/**
 * Returns { pop, pop999, changes, pops }. `pop` is the largest jump of a point, `pop999` the jump that only a thousandth of the points
 * exceeds, both in pixels. `changes` counts how often the mesh was divided again, `pops` how often a point then jumped by more than a pixel.
 * `sizes` are half of the mesh's size along x, y and z.
 */
export function measurePops(warp, mesh, sizes, firstUniforms) {
  const random = randomNumbers(11)
  const detail = createDetail(markPlaces(scale(mesh, sizes)), warp)
  const choose = (division) => chooseTriangles(random, division, maxTriangles)
  const allJumps = []
  let [changes, pops] = [0, 0]
  let division, before
  for (let frame = 0; frame < frames; frame++) {
    const uniforms = Object.fromEntries(
      Object.entries(firstUniforms).map(([name, x]) => [name, x + frame * (steps[name] ?? 0)]),
    )
    const view = viewAt(frame, Math.max(...sizes))
    const isChanged = detail.update(view, { uniforms })
    if (isChanged) division = copyDivision(detail)
    const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
    const now = { division, warpPositions, view }
    if (isChanged && before) {
      changes++
      const jumps = popsBetween(before, now, choose)
      for (const distance of jumps) allJumps.push(distance)
      if (quantile(jumps, 1) > 1) pops++
    }
    before = now
  }
  detail.dispose()
  return {
    pop999: quantile(allJumps, 0.999),
    pop: quantile(allJumps, 1),
    changes,
    pops,
  }
}
