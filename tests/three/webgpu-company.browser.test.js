// Tests WebGPURenderer on both backends: a warp combined with other code draws the same picture as the same motion without a warp.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

/** The number of pixels that may differ by more than 12 of 255 in a channel. */
const maxDiffering = 5
const minMoved = 200

let pages, page, messages
before(async () => {
  pages = await threePages(webgpuFlags)
  ;({ page, messages } = await pages.open('three', 'page-company.js'))
})
after(() => pages.close())

for (const backend of ['webgl', 'webgpu'])
  describe(`the backend ${backend}`, () => {
    const evaluate = (work, ...args) => {
      messages.length = 0
      return page.evaluate(work, [...args, backend])
    }

    test('a warp combined with other code draws the same picture as the motion without a warp', async (t) => {
      for (const name of await evaluate(() => company.names))
        await t.test(name, async () => {
          const { differing, moved } = await evaluate(
            ([name, backend]) => company.compare(name, backend),
            name,
          )
          assert.deepEqual(messages, [])
          assert.ok(
            differing <= maxDiffering,
            `${differing} pixels differ from the motion by three.js`,
          )
          assert.ok(moved > minMoved, `${moved} pixels are moved`)
        })
    })

    test('velocities equal those of the same motion without a warp', async (t) => {
      for (const name of await evaluate(() => company.velocities))
        await t.test(name, async () => {
          const { wrong, drawn, moving } = await evaluate(
            ([name, backend]) => company.velocity(name, backend),
            name,
          )
          assert.deepEqual(messages, [])
          assert.ok(wrong <= maxDiffering, `${wrong} velocities are wrong`)
          assert.ok(drawn > minMoved, `${drawn} pixels are drawn`)
          if (name.includes('moves')) assert.ok(moving > minMoved, `${moving} pixels move`)
        })
    })

    test('a wave over uv along the normals of a torus has exact normals', async (t) => {
      for (const hasTangents of [false, true])
        await t.test(hasTangents ? 'with tangents and a second uv' : 'plain', async () => {
          const { differing, moved } = await evaluate(
            ([settings, backend]) => company.torus(backend, settings),
            {
              hasTangents,
            },
          )
          assert.deepEqual(messages, [])
          assert.ok(differing <= maxDiffering, `${differing} pixels differ`)
          assert.ok(moved > minMoved, `${moved} pixels are moved`)
          const rough = await evaluate(([settings, backend]) => company.torus(backend, settings), {
            hasTangents,
            exact: false,
          })
          assert.ok(rough.differing > 100, `${rough.differing} differ without surface variation`)
        })
    })
  })

test('errors for unsupported objects name them, and say what to write instead', async () => {
  const errors = await page.evaluate(() => company.errors())
  const expected = [
    /^WarpError: warp: the vertexNode of the MeshStandardNodeMaterial "screen" of the Mesh "boat" .*positionNode\.$/,
    /^WarpError: warp: the PointsNodeMaterial of the Mesh "dust" draws squares that face the camera, unless its object is a Points; use new Points\(geometry, material\)\.$/,
    /^WarpError: warp: the Sprite "tree" .*use a Mesh with a PlaneGeometry\.$/,
    /^WarpError: warp: the Mesh "ship" is drawn by a renderer of another copy of three\.js /,
  ]
  assert.equal(errors.length, expected.length)
  errors.forEach((error, i) => assert.match(error, expected[i]))
})
