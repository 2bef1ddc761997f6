// Normals in shaders follow from the exact derivative even if intermediate results overflow or underflow in float32.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { openPipelines, targetsInThisRun } from '../support/browser/pipelines.js'
import { extremes } from '../warps/extremes.js'

let pipelines

before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

for (const target of targetsInThisRun)
  for (const { name, offset, points } of extremes)
    test(`the normal in ${target} is finite and correct: ${name}`, async () => {
      const program = {
        ...compileWarp(offset, { target }),
        inputs: ['position', 'normal'].map((name) => ({ name, shape: 3 })),
        outputs: [{ name: 'warpedNormal', shape: 3 }],
      }
      const rows = points.map(({ position, normal }) => [...position, ...normal])
      const results = await pipelines.run(target, program, rows)
      points.forEach(({ position, expected }, k) => {
        const actual = [...results[k]]
        actual.forEach((x, i) =>
          assert.ok(Math.abs(x - expected[i]) < 1e-3, `${actual}, not ${expected}, at ${position}`),
        )
      })
    })
