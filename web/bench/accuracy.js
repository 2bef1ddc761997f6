/** How far a method's normals are from those of the double oracle, which knows nothing of our compiler. */
import { angleBetween, warpVertex } from '../../tests/support/browser/oracle.js'
import { dot } from '../../tests/support/browser/matrix.js'
import { methods } from './methods.js'
import { probePixels, probeVertices, sampleVertices, vertexProbe } from './probe.js'

/** Of the oracle's differences, in units of the mesh. */
const ORACLE_STEP = 0.02
/** Where the moved surface has all but collapsed, float32 cannot have a normal, whoever computes it. */
const MAX_SENSITIVITY = 1e3

/** Exact normals of [{ position, normal }]; null where there is none to compare with. */
export const exactNormals = (workload, places, millis) =>
  places.map((place) => {
    const { normal, sensitivity } = warpVertex(workload.offset, place, { millis }, ORACLE_STEP)
    return normal?.some(Boolean) && sensitivity < MAX_SENSITIVITY ? normal : null
  })

/** In degrees → { largest, median }; undefined where nothing could be compared, NaN where a normal is not a number. */
export function errorsOf(places, exact) {
  const errors = places
    .map(({ found }, i) => exact[i] && angleBetween(found, exact[i]))
    .filter((error) => error !== null)
  const sorted = errors.filter(Number.isFinite).sort((a, b) => a - b)
  const largest = sorted.length < errors.length ? NaN : sorted.at(-1)
  return { largest, median: sorted[sorted.length >> 1] }
}

/**
 * The same for pixels that found their normals themselves: which side of the surface is the front they cannot know, so
 * each is compared with the side that it has found.
 */
export function pixelErrors(workload, pixels, millis) {
  const exact = exactNormals(workload, pixels, millis)
  const seen = exact.map((normal, i) => {
    const isBehind = normal && dot(normal, pixels[i].found) < 0
    return isBehind ? normal.map((value) => -value) : normal
  })
  return errorsOf(pixels, seen)
}

/** The step of the smallest largest error → { h, largest, median }. @param probe a program of vertexProbe */
export function bestStep(scene, workload, { probe, sample, steps, millis }) {
  let exact
  const trials = steps.map((h) => {
    const places = probeVertices(scene, probe, sample, { millis, h })
    exact ??= exactNormals(workload, places, millis)
    return { h, ...errorsOf(places, exact) }
  })
  const badness = ({ largest }) => (Number.isFinite(largest) ? largest : Infinity)
  return trials.reduce((best, trial) => (badness(trial) < badness(best) ? trial : best))
}

/**
 * Measures each method on up to `limit` vertices, or pixels for dFdx → Map from the method's name to
 * { largest, median, h }, in degrees; `h`, in units of the mesh, is the step of the smallest largest error.
 */
export function measureErrors(scene, workload, mesh, millis, limit) {
  const sample = sampleVertices(mesh, limit)
  const found = new Map()
  for (const { name, program, steps = [undefined], flat } of methods) {
    const parts = program(workload)
    if (flat) {
      found.set(name, pixelErrors(workload, probePixels(scene, parts, millis, limit), millis))
    } else {
      const probe = vertexProbe(scene, parts)
      found.set(name, bestStep(scene, workload, { probe, sample, steps, millis }))
      scene.gl.deleteProgram(probe)
    }
  }
  return found
}
