// Measures how far the drawn surface jumps when a mesh is divided anew, while camera and warp move slowly.
import * as THREE from 'three'
import { createDetail } from '../../../dist/detail.js'
import { copyDivision, markPlaces, popsBetween } from '../../../tests/support/pops.js'
import { quantile } from '../../../tests/support/screen-error.js'
import { randomNumbers } from '../../../tests/support/three-meshes.js'
import { chooseTriangles, scale, viewFrom } from './cases.mjs'

const frames = 200
/** The number of triangles of each division that are looked at, at random. */
const chosen = 300
/** The changes of the inputs of warps in a frame. */
const steps = { millis: 16, bend: 0.005 }

/** The camera moves around the mesh, by half a degree in a frame, and towards it and back: from 4 to 2.4 times its size. */
function viewAt(frame, size) {
  const distance = size * (3.2 + 0.8 * Math.cos((2 * Math.PI * frame) / frames))
  const angle = (frame * Math.PI) / 360
  return viewFrom(new THREE.Vector3().setFromSphericalCoords(distance, 1.1, angle), size)
}

/** Returns the largest jump, that of all points but a thousandth, and how many of the changes had one of more than a pixel. */
export function measurePops(warp, mesh, sizes, uniforms) {
  const random = randomNumbers(11)
  const detail = createDetail(markPlaces(scale(mesh, sizes)), warp)
  const choose = (division) => chooseTriangles(random, division, chosen)
  const all = []
  let [changes, pops] = [0, 0]
  let before
  for (let frame = 0; frame < frames; frame++) {
    const moved = Object.fromEntries(
      Object.entries(uniforms).map(([name, x]) => [name, x + frame * (steps[name] ?? 0)]),
    )
    const view = viewAt(frame, Math.max(...sizes))
    if (!detail.update(view, { uniforms: moved })) continue
    const after = copyDivision(detail)
    if (before) {
      changes++
      const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms: moved }).positions
      const found = popsBetween(before, after, warpPositions, view, choose)
      for (const distance of found) all.push(distance)
      if (quantile(found, 1) > 1) pops++
    }
    before = after
  }
  detail.dispose()
  return {
    'nearly pop': quantile(all, 0.999),
    pop: quantile(all, 1),
    changes,
    pops,
  }
}
