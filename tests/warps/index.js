import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compileWarp } from '../../dist/warpjet.js'
import { maxDegrees } from '../support/browser/compare.js'
import { gallery } from './gallery.js'
import { inputs } from './inputs.js'
import { normalAt } from './normal-field.js'
import { operations } from './operations.js'
import { pieces } from './pieces.js'
import { sketchWarps } from './sketches.js'
import { stress } from './stress.js'

/** Makes the code of a warp from a height of `gen` over x and y: it moves every point to that height. */
const wrapHeight = (text) => ({
  declarations: '',
  code: `float x = position.x, y = position.y, time = millis / 1000.0;
${text}
vec3 warpedPosition = vec3(x, y, height);
vec3 warpedNormal = sign(normal.z) * normalize(vec3(-slopeX, -slopeY, 1.0));`,
})

/**
 * Returns whether a warp reads an image. We exclude these: the pipelines of the tests pass no images; tests/p5/inputs.browser.test.js does.
 */
const readsImage = ({ warp }) => warp && /sampler2D/.test(compileWarp(warp).declarations)

/** Compiles a sketch's warp like createWarp on p5 2, where normals vary over the surface unless the options say otherwise. */
function addOracle({ name, warp, options, text }) {
  const oracle = gallery[name]
  if (text) return { text, compile: () => wrapHeight(text), ...oracle }
  const { surfaceVariation = true } = options
  // The oracle evaluates each vertex several times.
  let vertex, moved
  const sampledOffset = (p, inputs) => {
    if (inputs !== vertex) moved = { ...(vertex = inputs) }
    moved.normal = normalAt(p, inputs)
    return oracle.offset(p, moved)
  }
  return {
    compile: (target, more) => compileWarp(warp, { target, surfaceVariation, ...more }),
    ...oracle,
    ...(surfaceVariation && oracle && { offset: sampledOffset }),
  }
}

const sketches = (await sketchWarps())
  .filter((sketch) => !readsImage(sketch))
  .map((sketch) => ({ name: sketch.name, isGolden: true, ...addOracle(sketch) }))

/**
 * All warps, [{ name, compile, offset, size, step, degrees, every, reach, mirrors, params, collapses, isGolden, deep }].
 * - `compile(target)` returns the compiled warp;
 * - `offset([x, y, z], inputs)` is the same offset in plain numbers;
 * - `size` is the distance of the mesh's faces from its middle;
 * - `step` is the step of the oracle's differences;
 * - `degrees` is the max error of its normals;
 * - `every` selects every n-th vertex, for slow oracles;
 * - `reach` is the max size of numbers in the formulas, to which rounding errors are proportional;
 * - `mirrors` returns, from the inputs, whether the warp mirrors all of space;
 * - `params` are values of the warp's own parameters;
 * - `collapses` is true if its derivatives are exactly zero, in float32 too, wherever the moved surface has no normal;
 * - `isGolden` is true if its code is stored in tests/golden;
 * - `deep` is true if its code takes long to compile.
 */
export const warps = [...stress, ...sketches, ...operations, ...pieces, ...inputs].map((warp) => ({
  compile: (target, more) => compileWarp(warp.warp, { target, ...more }),
  step: warp.size / 1000,
  degrees: maxDegrees,
  every: 1,
  reach: warp.size,
  params: {},
  ...warp,
}))

/** The warps that this run tests. */
export const warpsInThisRun = warps.filter(({ deep }) => !deep || isRun('deep domain warping'))

/** The names of oracles whose sketch no longer exists. */
export const orphans = Object.keys(gallery).filter(
  (name) => !sketches.some((sketch) => sketch.name === name),
)
