// Measures the accuracy of a warp's code after a page has run for a long time.
import { withAccurateSineIfShort } from './accurate.js'
import { compare, moments } from './compare.js'
import { denseMesh, vertices } from './dense-mesh.js'
import { warpVertex } from './oracle.js'
import { vertexShader } from './transform-feedback.js'

/** A week, in milliseconds. */
export const week = 6e8
/** The duration of a frame, in milliseconds. */
const frame = 16

/** The other inputs of a draw. */
const [{ millis: _, ...others }] = moments

/**
 * Returns the errors of positions and normals (in degrees) against the oracle at the start and after a week, and the max error of
 * the vertices' motion from one frame to the next, relative to the longest such motion.
 */
export async function measureAfterAWeek(gpu, warp, options) {
  const { compile, offset, size, step, every, reach, params, degrees, mirrors } = warp
  const mesh = denseMesh(size, every)
  const points = vertices(mesh)
  await gpu.load(mesh)
  const compiled = compile('glsl300', options)
  const draws = [1234, week, week + frame].map((millis) => ({ ...others, ...params, millis }))
  const uniformsOfDraws = draws.map((draw) => {
    // The warp's parameters remain uniforms of the shader, beside the frame uniforms.
    const inputs = Object.fromEntries(Object.entries(draw).filter(([name]) => !(name in params)))
    return { ...draw, ...compiled.frameUniforms(inputs) }
  })
  const { mouse, size: canvas, pixelDensity, millis, ...declared } = uniformsOfDraws[0]
  const shader = vertexShader(withAccurateSineIfShort(compiled), 'glsl300', declared)
  const results = await gpu.run(shader, uniformsOfDraws)
  const expected = draws.map((draw) =>
    points.map((vertex) => warpVertex(offset, vertex, draw, step, mirrors)),
  )
  const [start, then] = [0, 1].map((i) => compare([results[i]], [expected[i]], reach, degrees))
  return { start, then, step: motionError(results.slice(1), expected.slice(1)) }
}

function motionError([before, after], [expectedBefore, expectedAfter]) {
  let worst = 0
  let longest = 0
  expectedBefore.forEach(({ position }, i) => {
    const expected = expectedAfter[i].position.map((x, k) => x - position[k])
    const actual = expected.map((_, k) => after[6 * i + k] - before[6 * i + k])
    longest = Math.max(longest, Math.hypot(...expected))
    worst = Math.max(worst, Math.hypot(...expected.map((x, k) => x - actual[k])))
  })
  return longest > 0 ? worst / longest : 0
}

/**
 * Tests for warps to measure: those of sketches. Warps that are only code have no frames, and deep noise has no sufficiently exact oracle.
 */
export const isMeasured = ({ isGolden, text, deep }) => isGolden && !text && !deep
