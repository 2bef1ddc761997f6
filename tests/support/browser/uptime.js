// How right a warp's text is after a page has run for so long.
import { asAccurateAsCanBe } from './accurate.js'
import { compare, moments } from './compare.js'
import { denseMesh, vertices } from './dense-mesh.js'
import { warpVertex } from './oracle.js'
import { vertexShader } from './transform-feedback.js'

/** In milliseconds, of a week; and what one frame adds to it. */
export const week = 6e8
const frame = 16

const [{ millis: _, ...others }] = moments

/**
 * How far positions and normals (in degrees) are from the oracle's at the start and after a week, and how far the way that
 * vertices go from one frame to the next is from the right one, in parts of the longest such way.
 */
export async function afterAWeek(gpu, warp, options) {
  const { compile, offset, size, step, every, reach, params, degrees, mirrors } = warp
  const mesh = denseMesh(size, every)
  const points = vertices(mesh)
  await gpu.load(mesh)
  const compiled = compile('glsl300', options)
  const draws = [1234, week, week + frame].map((millis) => ({ ...others, ...params, millis }))
  const given = draws.map((draw) => {
    // The warp's own parameters stay in the shader.
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

/** Warps of sketches; what is text alone has no frame, and deep noise no oracle that is exact enough. */
export const isMeasured = ({ kept, text, deep }) => kept && !text && !deep
