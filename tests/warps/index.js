import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compileWarp } from '../../dist/warpjet.js'
import { degrees } from '../support/browser/compare.js'
import { gallery } from './gallery.js'
import { inputs } from './inputs.js'
import { normalAt } from './normal-field.js'
import { operations } from './operations.js'
import { pieces } from './pieces.js'
import { sketchWarps } from './sketches.js'
import { stress } from './stress.js'

/** A text of `gen` that gives a height over x and y, as a warp that puts every point at that height. */
const asWarp = (text) => ({
  declarations: '',
  code: `float x = position.x, y = position.y, time = millis / 1000.0;
${text}
vec3 warpedPosition = vec3(x, y, height);
vec3 warpedNormal = sign(normal.z) * normalize(vec3(-slopeX, -slopeY, 1.0));`,
})

/** The pipelines of the tests show warps no images; p5-texture.test.js does. */
const readsImage = ({ warp }) => warp && /sampler2D/.test(compileWarp(warp).declarations)

/** A sketch's warp as createWarp compiles it on p5 2, where normals vary over the surface unless the options say no. */
function asInSketch({ name, warp, options, text }) {
  const oracle = gallery[name]
  if (text) return { text, compile: () => asWarp(text), ...oracle }
  const { surfaceVariation = true } = options
  // The oracle asks many times about a vertex.
  let vertex, moved
  const varying = (p, inputs) => {
    if (inputs !== vertex) moved = { ...(vertex = inputs) }
    moved.normal = normalAt(p, inputs)
    return oracle.offset(p, moved)
  }
  return {
    compile: (target, more) => compileWarp(warp, { target, surfaceVariation, ...more }),
    ...oracle,
    ...(surfaceVariation && oracle && { offset: varying }),
  }
}

const sketches = (await sketchWarps())
  .filter((sketch) => !readsImage(sketch))
  .map((sketch) => ({ name: sketch.name, kept: true, ...asInSketch(sketch) }))

/**
 * All warps, [{ name, compile, offset, size, step, degrees, every, reach, params, collapses, kept }].
 * - `compile(target)` gives the statements;
 * - `offset([x, y, z], inputs)` is the same offset in plain numbers;
 * - `size` is the mesh's, from its middle to its faces;
 * - `step` is how wide the oracle's differences are;
 * - `degrees` is how far off its normals may be;
 * - `every` takes only each so many-th vertex, where the oracle is slow;
 * - `reach` is how large the numbers in the formulas get, for rounding errors are in proportion to it;
 * - `mirrors` tells, of the inputs, whether the warp mirrors all of space;
 * - `params` are values of the warp's own parameters;
 * - `collapses`: where the moved surface has no normal, its derivatives are exactly zero in float32 too;
 * - `kept`: its text is one of tests/golden;
 * - `deep`: its text is long to compile.
 */
export const warps = [...stress, ...sketches, ...operations, ...pieces, ...inputs].map((warp) => ({
  compile: (target, more) => compileWarp(warp.warp, { target, ...more }),
  step: warp.size / 1000,
  degrees,
  every: 1,
  reach: warp.size,
  params: {},
  ...warp,
}))

/** Those that this run computes with. */
export const warpsInThisRun = warps.filter(({ deep }) => !deep || isRun('deep domain warping'))

/** Oracles whose sketch is gone. */
export const orphans = Object.keys(gallery).filter(
  (name) => !sketches.some((sketch) => sketch.name === name),
)
