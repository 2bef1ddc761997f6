// Every warp of the gallery whose offset function is in the sketch is written again with operators in tests/warps/with-operators.js. Both
// versions generate the same code, byte for byte.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'
import { sketchWarps } from '../warps/sketches.js'
import { threeWarps } from '../warps/three-sketches.js'
import { offsetSources } from '../warps/with-operators.js'

/** Returns whether the offset function is in the sketch, unlike those of deformers, compositions and GLSL source. */
const hasOffsetFunction = ({ name, warp }) => warp && !/^(deformer|composition|glsl)-/.test(name)

const sketches = [...(await sketchWarps()).filter(hasOffsetFunction), ...threeWarps()]

test('each warp has a version with operators, and each version has a warp', () => {
  assert.deepEqual(sketches.map(({ name }) => name).sort(), Object.keys(offsetSources).sort())
})

for (const { name, warp, options } of sketches)
  test(name, () => {
    const { surfaceVariation = true, uniforms } = options
    const codeOf = (offset) => {
      const { code, declarations } = compileWarp(offset, { surfaceVariation, uniforms })
      return `${declarations}${code}`
    }
    // Loads the source file itself, as in a page.
    const withOperators = operators((0, eval)(offsetSources[name]))
    assert.ok(codeOf(withOperators) === codeOf(warp), 'the code differs')
  })
