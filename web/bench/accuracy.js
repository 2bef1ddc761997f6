/** Measures the angles between a method's normals and those of the double-precision oracle, which shares no code with our compiler. */
import { dot } from '../../tests/support/browser/matrix.js'
import { angleBetween, warpVertex } from '../../tests/support/browser/oracle.js'
import { methods } from './methods.js'
import { compileVertexProbe, probePixels, probeVertices, sampleVertices } from './probe.js'

/** The step of the oracle's finite differences, in units of the mesh. */
const ORACLE_STEP = 0.02
/** Above this sensitivity the warped surface has nearly collapsed, and no float32 computation can find its normal. */
const MAX_SENSITIVITY = 1e3

/** Returns the exact normal of the warped surface at each of `places`, [{ position, normal }]; null where the oracle finds none. */
export const computeExactNormals = (workload, places, millis) =>
  places.map((place) => {
    const { normal, sensitivity } = warpVertex(workload.offset, place, { millis }, ORACLE_STEP)
    return normal?.some(Boolean) && sensitivity < MAX_SENSITIVITY ? normal : null
  })

/** Returns { largest, median } in degrees: undefined if nothing could be compared, `largest` NaN if a normal is NaN. */
export function errorsOf(places, exact) {
  const errors = places
    .map(({ measured }, i) => exact[i] && angleBetween(measured, exact[i]))
    .filter((error) => error !== null)
  const sorted = errors.filter(Number.isFinite).sort((a, b) => a - b)
  const largest = sorted.length < errors.length ? NaN : sorted.at(-1)
  return { largest, median: sorted[sorted.length >> 1] }
}

/**
 * Like `errorsOf`, for pixels that compute their own normals. These do not know which side is the front, so each
 * is compared with the exact normal of the side to which it points.
 */
export function pixelErrors(workload, pixels, millis) {
  const exact = computeExactNormals(workload, pixels, millis)
  const onSameSide = exact.map((normal, i) => {
    const isBehind = normal && dot(normal, pixels[i].measured) < 0
    return isBehind ? normal.map((value) => -value) : normal
  })
  return errorsOf(pixels, onSameSide)
}

/** Returns the step whose largest error is smallest: { h, largest, median }. @param probe a program from `compileVertexProbe` */
export function findBestStep(scene, workload, { probe, sample, steps, millis }) {
  let exact
  const trials = steps.map((h) => {
    const places = probeVertices(scene, probe, sample, { millis, h })
    exact ??= computeExactNormals(workload, places, millis)
    return { h, ...errorsOf(places, exact) }
  })
  const rank = ({ largest }) => (Number.isFinite(largest) ? largest : Infinity)
  return trials.reduce((best, trial) => (rank(trial) < rank(best) ? trial : best))
}

/**
 * Measures each method on up to `limit` vertices, or pixels for dFdx. Returns a Map from method name to { largest, median, h }. Errors
 * are degrees; `h`, in units of the mesh, is the step whose largest error is smallest.
 */
export function measureErrors(scene, workload, mesh, millis, limit) {
  const sample = sampleVertices(mesh, limit)
  const results = new Map()
  for (const { name, program, steps = [undefined], flat } of methods) {
    const parts = program(workload)
    if (flat) {
      results.set(name, pixelErrors(workload, probePixels(scene, parts, millis, limit), millis))
    } else {
      const probe = compileVertexProbe(scene, parts)
      results.set(name, findBestStep(scene, workload, { probe, sample, steps, millis }))
      scene.gl.deleteProgram(probe)
    }
  }
  return results
}
