// Every warp of the gallery that computes something itself, written a second time with operators: the same text, byte for byte.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'
import { sketchWarps } from '../warps/sketches.js'
import { threeWarps } from '../warps/three-sketches.js'
import { texts } from '../warps/with-operators.js'

/** Ready-made deformers and what composes them, texts of GLSL, and what `gen` made are no functions of the sketch. */
const isOwn = ({ name, warp }) => warp && !/^(deformer|composition|glsl)-/.test(name)

const sketches = [...(await sketchWarps()).filter(isOwn), ...threeWarps()]

test('each has its second text, and no other', () => {
  assert.deepEqual(sketches.map(({ name }) => name).sort(), Object.keys(texts).sort())
})

for (const { name, warp, options } of sketches)
  test(name, () => {
    const { surfaceVariation = true, uniforms } = options
    const written = (offset) => {
      const { code, declarations } = compileWarp(offset, { surfaceVariation, uniforms })
      return `${declarations}${code}`
    }
    // Of the text itself, as a page has it.
    const again = operators((0, eval)(texts[name]))
    assert.ok(written(again) === written(warp), 'the texts differ')
  })
