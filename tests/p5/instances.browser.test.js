// model(shape, count): the warp differs per instance. Checks the position in the picture, and the light against p5's own shear.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { beyondEdges, colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'

/** p5 1.11 has no instanced models. */
const hosts = p5HostsInThisRun.filter(([version]) => version === '2.x')

const { browsers, server } = await openHosts(hosts)

for (const [, renderer, scripts] of hosts)
  test(`${renderer}: fills and strokes of instances move by their own offsets`, async () => {
    const { fills, strokes } = await drawScenes(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      {
        renderer,
        setup: `
          shape = buildGeometry(() => plane(20))
          warps.row = createWarp(({ glsl, instance }) => glsl.vec3(instance.sub(1).mult(50), 0, 0), { space: 'world' })`,
        scenes: {
          fills: `noStroke(); warps.row(); fill('red'); model(shape, 3)`,
          strokes: `noFill(); stroke('red'); strokeWeight(4); warps.row(); model(shape, 3)`,
        },
      },
    )
    for (const x of [-50, 0, 50]) assert.deepEqual(colorAt(fills, 100 + x, 100), [255, 0, 0])
    assert.equal(litPixels(fills).length, 3 * 400)
    const at = (x) => litPixels(strokes).filter((pixel) => Math.abs(pixel.x - x) < 25).length
    assert.ok(at(0) > 200, `${at(0)} pixels of a frame`)
    for (const x of [-50, 50])
      assert.ok(Math.abs(at(x) - at(0)) <= 4, `${at(x)} at ${x}, ${at(0)} in the middle`)
  })

for (const [, renderer, scripts] of hosts)
  test(`${renderer}: each instance has its own normals, like those transformed by p5`, async () => {
    const light = `noStroke(); directionalLight(255, 255, 255, 0.6, 0.3, -1); fill('red')`
    const { warped, byP5, flat } = await drawScenes(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      {
        renderer,
        setup: `
          shape = buildGeometry(() => sphere(22))
          warps.sheared = createWarp(({ glsl, instance, position }) => {
            const which = instance.sub(1)
            return glsl.vec3(which.mult(50), 0, position.x.mult(which))
          }, { space: 'world' })`,
        scenes: {
          warped: `${light}; warps.sheared(); model(shape, 3)`,
          byP5: `${light}; for (const which of [-1, 0, 1]) {
            push()
            translate(50 * which, 0, 0)
            applyMatrix(1, 0, which, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
            model(shape)
            pop()
          }`,
          flat: `${light}; for (const which of [-1, 0, 1]) { push(); translate(50 * which, 0, 0); model(shape); pop() }`,
        },
      },
    )
    assert.ok(differingPixels(flat, byP5, 6) > 1000, 'shearing changes the light')
    assert.equal(beyondEdges(warped, byP5, 6) + beyondEdges(byP5, warped, 6), 0)
    assert.ok(differingPixels(warped, byP5, 6) < 0.004 * litPixels(byP5).length)
  })
