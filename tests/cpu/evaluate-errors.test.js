// Tests the messages of evaluate and the other methods that evaluate a warp on the CPU.
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { throwsWarpError } from '../support/warp-errors.js'

const wave = compileWarp(({ glsl, position, millis }) =>
  glsl.vec3(0, position.x().mult(3).add(millis.div(500)).sin().mult(0.2), 0),
)
const uniforms = { millis: 250 }

describe('errors for', () => {
  const positions = [1, 2, 3]

  test('meshes', () => {
    throwsWarpError(
      () => wave.evaluate(),
      /evaluate: expected a mesh with an array of positions, got undefined/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions: 3 }),
      /expected a flat array of 3 numbers per vertex for positions, got the number 3/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions: [1, 2] }),
      /expected 3 numbers per vertex for positions, got 2 numbers/,
    )
    throwsWarpError(
      () =>
        wave.evaluate({
          positions: [
            [1, 2, 3],
            [1, 2, 3],
            [1, 2, 3],
          ],
        }),
      /expected a finite number for positions\[0\], of vertex 0, got an array of 3/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions, normals: [1] }),
      /expected 3 numbers per vertex, 3 for these positions, for normals, got 1/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions: [1, 2, 3, 4, NaN, 6] }, { uniforms }),
      /expected a finite number for positions\[4\], of vertex 1, got NaN/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions: [1, 2, Infinity] }, { uniforms }),
      /expected a finite number for positions\[2\], of vertex 0, got Infinity/,
    )
    throwsWarpError(
      () => wave.evaluateAt([1, 2], { uniforms }),
      /evaluateAt: expected an array of 3 finite numbers for the position, got an array of 2/,
    )
    throwsWarpError(
      () => wave.evaluateAt([1, 2, 3], { uniforms, normal: [0, NaN, 1] }),
      /expected an array of 3 finite numbers for the normal, got one with NaN/,
    )
  })

  test('uniforms', () => {
    throwsWarpError(
      () => wave.evaluate({ positions }),
      /the warp reads "millis"; pass a value in the uniforms, as in \{ "millis": 0 \}/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions }, { uniforms: { milis: 3 } }),
      /the warp has no uniform "milis"; it has millis, mouse, size, pixelDensity/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions }, { uniforms: { millis: '3' } }),
      /expected a finite number for the uniform "millis", got the text "3"/,
    )
    throwsWarpError(
      () => wave.evaluate({ positions }, { uniforms: 3 }),
      /expected an object, such as \{ millis: 1200 \}, for uniforms, got the number 3/,
    )
    const follows = compileWarp(({ glsl, mouse }) => glsl.vec3(mouse, glsl.param('amount')))
    throwsWarpError(
      () => wave.evaluate({ positions, uniforms }),
      /uniforms are an option, not a part of the mesh, as in evaluate\(mesh, \{ uniforms/,
    )
    throwsWarpError(
      () => wave.bounds({ min: [0, 0, 0], max: [1, 1, 1] }, { millis: 1 }),
      /write \{ uniforms: \{ millis: … \} \}/,
    )
    throwsWarpError(
      () => follows.evaluate({ positions }, { uniforms: { mouse: [1, 2] } }),
      /reads "amount"/,
    )
    throwsWarpError(
      () => follows.evaluate({ positions }, { uniforms: { amount: 1 } }),
      /"mouse": \[0,0\]/,
    )
    throwsWarpError(
      () => follows.evaluate({ positions }, { uniforms: { amount: 1, mouse: [1] } }),
      /expected an array of 2 finite numbers for the uniform "mouse", got an array of 1/,
    )
  })

  test('attributes that the warp reads', () => {
    const colored = compileWarp(({ color }) => color.rgb())
    throwsWarpError(
      () => colored.evaluate({ positions }),
      /the warp reads the color of each vertex; pass "colors" too/,
    )
    const inflated = compileWarp(({ normal }) => normal.mult(2))
    throwsWarpError(
      () => inflated.evaluateAt(positions),
      /evaluateAt: the warp reads the normal of each vertex; pass "normal" too/,
    )
  })

  test('boxes', () => {
    throwsWarpError(
      () => wave.bounds(),
      /bounds: expected \{ min, max \}, each of 3 numbers, for box, got undefined/,
    )
    throwsWarpError(
      () => wave.bounds({ min: [0, 0, 0] }),
      /bounds: expected an array of 3 finite numbers for box\.max, got undefined/,
    )
    throwsWarpError(
      () => wave.bounds({ min: [0, 2, 0], max: [1, 1, 1] }, { uniforms }),
      /bounds: box\.min\[1\] is 2, above box\.max\[1\], which is 1/,
    )
    throwsWarpError(
      () => wave.bounds({ min: [0, 0, 0], max: [1, 1, 1] }),
      /bounds: the warp reads "millis"/,
    )
  })

  test('warps that the CPU cannot evaluate, or that were compiled without normals', () => {
    const gpuOnly = compileWarp(({ glsl, position }) => {
      const bump = glsl.fn({
        name: 'bump',
        source: 'float bump(float x) { return x; }',
        arity: 1,
        derivatives: [1],
      })
      return glsl.vec3(bump(position.x()), 0, 0)
    })
    for (const method of ['evaluate', 'foldover'])
      throwsWarpError(
        () => gpuOnly[method]({ positions }),
        new RegExp(
          `${method}: this warp calls a function of glsl\\.fn or reads an image by glsl\\.texture, which only the GPU can do`,
        ),
      )
    const withoutNormals = compileWarp(({ position }) => position, { normals: false })
    throwsWarpError(
      () => withoutNormals.foldover({ positions }),
      /foldover: the warp was compiled with "normals: false"/,
    )
  })

  test('tangents without normals', () => {
    throwsWarpError(
      () => compileWarp(({ position }) => position, { normals: false, tangents: true }),
      /compileWarp: tangents are transformed with the normal; remove "normals: false"/,
    )
    throwsWarpError(
      () => compileWarp(({ position }) => position, { tangents: 1 }),
      /compileWarp: expected true or false for the option "tangents", got the number 1/,
    )
  })
})
