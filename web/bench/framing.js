/** Finds the camera position that keeps a whole warped mesh in the picture. Evaluates the row's offset as a plain function of numbers. */
import { sampleVertices } from './probe.js'

/** The max number of vertices that are evaluated. */
const VERTICES = 100
/** The times at which the mesh is sampled, in milliseconds. */
const times = Array.from({ length: 60 }, (_, i) => 400 * i)
/** The distance of the camera, in radii of the warped mesh, for the field of view of Scene's camera. */
const DISTANCE = 2.9

/** Returns the bounding box of the warped vertices. */
function boxAt(workload, points, millis) {
  const low = [Infinity, Infinity, Infinity]
  const high = low.map((value) => -value)
  for (const point of points) {
    const offset = workload.offset(point, { millis })
    for (let i = 0; i < 3; i++) {
      low[i] = Math.min(low[i], point[i] + offset[i])
      high[i] = Math.max(high[i], point[i] + offset[i])
    }
  }
  return { low, high }
}

const middleOf = ({ low, high }) => low.map((value, i) => (value + high[i]) / 2)

/** @returns { distance, middleAt(millis) }, in units of the mesh */
export function frameMesh(workload, mesh) {
  const { positions } = sampleVertices(mesh, VERTICES)
  const points = Array.from({ length: positions.length / 3 }, (_, i) => [
    ...positions.subarray(3 * i, 3 * i + 3),
  ])
  const longest = Math.max(
    ...times.flatMap((millis) => {
      const { low, high } = boxAt(workload, points, millis)
      return high.map((value, i) => value - low[i])
    }),
  )
  return {
    distance: (DISTANCE * longest) / 2,
    middleAt: (millis) => middleOf(boxAt(workload, points, millis)),
  }
}
