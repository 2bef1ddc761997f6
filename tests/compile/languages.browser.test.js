// Tests that every warp has the same positions and normals in every language, each on its own pipeline.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { denseMesh, layout, stride } from '../support/browser/dense-mesh.js'
import { openPipelines, targets } from '../support/browser/pipelines.js'
import { warpsInThisRun as warps } from '../warps/index.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

const drawInputs = { millis: 1234, mouse: [120, 250], size: [640, 480], pixelDensity: 2 }
const outputs = ['warpedPosition', 'warpedNormal'].map((name) => ({ name, shape: 3 }))
const vertexStep = 7

/** Returns every seventh vertex of the dense mesh, each followed by the uniforms. */
function pointsOf(size, params) {
  const mesh = denseMesh(size)
  const rest = [...Object.values(drawInputs), ...Object.values(params)].flat()
  return Array.from({ length: Math.floor(mesh.length / stride / vertexStep) }, (_, i) => [
    ...mesh.subarray(i * vertexStep * stride, (i * vertexStep + 1) * stride),
    ...rest,
  ])
}

const inputsOf = (params) => [
  ...Object.entries(layout).map(([name, shape]) => ({ name, shape })),
  ...Object.entries({ ...drawInputs, ...params }).map(([name, value]) => ({
    name,
    shape: [value].flat().length,
  })),
]

// Rounding may move a vertex to the other side of a jump, and the normal of a nearly collapsed surface is ill-conditioned.
for (const { name, text, compile, size, reach, params } of warps)
  if (text === undefined)
    test(`${name} is the same in ${targets.join(', ')}`, async () => {
      const points = pointsOf(size, params)
      const [reference, ...others] = await Promise.all(
        targets.map((target) =>
          pipelines.run(target, { ...compile(target), inputs: inputsOf(params), outputs }, points),
        ),
      )
      assert.ok(reference[0].length === 6 && points.length > 300)
      for (const [i, results] of others.entries()) {
        const differing = results.filter((result, k) =>
          result.some((x, c) => !(Math.abs(x - reference[k][c]) <= 2e-3 * (c < 3 ? reach : 1))),
        )
        assert.ok(
          differing.length <= 0.01 * points.length,
          `${targets[i + 1]}: ${differing.length} of ${points.length} vertices differ`,
        )
      }
    })
