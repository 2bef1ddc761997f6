// Every warp of the gallery that has its own formula is written again with operators, and generates the same code, byte for byte.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'
import { sketchWarps } from '../warps/sketches.js'
import { threeWarps } from '../warps/three-sketches.js'
import { texts } from '../warps/with-operators.js'

/** Ready-made deformers, compositions, GLSL source and results of `gen` are not functions of the sketch. */
const isOwn = ({ name, warp }) => warp && !/^(deformer|composition|glsl)-/.test(name)

const sketches = [...(await sketchWarps()).filter(isOwn), ...threeWarps()]

test('each warp has its second version, and there are no others', () => {
  assert.deepEqual(sketches.map(({ name }) => name).sort(), Object.keys(texts).sort())
})

for (const { name, warp, options } of sketches)
  test(name, () => {
    const { surfaceVariation = true, uniforms } = options
    const codeOf = (offset) => {
      const { code, declarations } = compileWarp(offset, { surfaceVariation, uniforms })
      return `${declarations}${code}`
    }
    // Loads the source file itself, as in a page.
    const again = operators((0, eval)(texts[name]))
    assert.ok(codeOf(again) === codeOf(warp), 'the texts differ')
  })
