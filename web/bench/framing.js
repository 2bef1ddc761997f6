/** Where the eye must stand to have all of a warped mesh in the picture, by the row's offset as a plain function. */
import { sampleVertices } from './probe.js'

const VERTICES = 100
/** Milliseconds. */
const times = Array.from({ length: 60 }, (_, i) => 400 * i)
/** Radii of the mesh, for the angle that Scene's camera sees. */
const DISTANCE = 2.9

/** The box around the moved vertices. */
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
export function framing(workload, mesh) {
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
