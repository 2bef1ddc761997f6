// Measures the accuracy of a warp's code after a page has run for a long time.
import { asAccurateAsCanBe } from './accurate.js'
import { compare, moments } from './compare.js'
import { denseMesh, vertices } from './dense-mesh.js'
import { warpVertex } from './oracle.js'
import { vertexShader } from './transform-feedback.js'

/** A week in milliseconds, and the duration of a frame. */
export const week = 6e8
const frame = 16

const [{ millis: _, ...others }] = moments

/**
 * Returns the errors of positions and normals (in degrees) against the oracle at the start and after a week, and the error of the
 * vertices' motion from one frame to the next, relative to the longest such motion.
 */
export async function afterAWeek(gpu, warp, options) {
  const { compile, offset, size, step, every, reach, params, degrees, mirrors } = warp
  const mesh = denseMesh(size, every)
  const points = vertices(mesh)
  await gpu.load(mesh)
  const compiled = compile('glsl300', options)
  const draws = [1234, week, week + frame].map((millis) => ({ ...others, ...params, millis }))
  const given = draws.map((draw) => {
    // The warp's own parameters stay uniforms of the shader.
    const inputs = Object.fromEntries(Object.entries(draw).filter(([name]) => !(name in params)))
    return { ...draw, ...compiled.frameUniforms(inputs) }
  })
  const { mouse, size: canvas, pixelDensity, millis, ...declared } = given[0]
  const shader = vertexShader(asAccurateAsCanBe(compiled), 'glsl300', declared)
  const results = await gpu.run(shader, given)
  const expected = draws.map((draw) =>
    points.map((vertex) => warpVertex(offset, vertex, draw, step, mirrors)),
  )
  const [start, then] = [0, 1].map((i) => compare([results[i]], [expected[i]], reach, degrees))
  return { start, then, step: stepError(results.slice(1), expected.slice(1)) }
}

function stepError([before, after], [was, is]) {
  let worst = 0
  let longest = 0
  was.forEach(({ position }, i) => {
    const right = is[i].position.map((x, k) => x - position[k])
    const found = right.map((_, k) => after[6 * i + k] - before[6 * i + k])
    longest = Math.max(longest, Math.hypot(...right))
    worst = Math.max(worst, Math.hypot(...right.map((x, k) => x - found[k])))
  })
  return longest > 0 ? worst / longest : 0
}

/** The warps of sketches; warps that are only code have no frame, and deep noise has no sufficiently exact oracle. */
export const isMeasured = ({ isGolden, text, deep }) => isGolden && !text && !deep
