// The normal of a surface that a warp collapses is the geometric normal of the triangle, on the side of the eye. In a parallel projection,
// the direction from a position to the origin of view space may lead to the other side of a steep triangle.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { shaderOfNormals } from '../support/browser/p5-shown-normals.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'

const size = 120

/** Leaves the four vertices of the plane where they are, with derivatives that press all surfaces into a point. */
const offset = ({ position }) => position.mult(2).round().div(2).sub(position)

const { browsers, server } = await openHosts(p5HostsInThisRun)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  for (const projection of [`ortho(-60, 60, -60, 60, -500, 500)`, 'perspective(1, 1, 10, 2000)'])
    test(`p5 ${version} on ${renderer}: ${projection}`, async () => {
      const turns = [-1.3, 1.3].flatMap((angle) => [-40, 40].map((x) => [angle, x]))
      const names = ['pixel', 'vertex']
      const images = await drawScenes(
        browsers[renderer],
        server,
        [...scripts, '/dist/p5.warpjet.min.js'],
        {
          size,
          renderer,
          setup: names
            .map(
              (name) =>
                `warps.${name} = createWarp(${offset}, { shader: ${shaderOfNormals(version, renderer)}, normals: '${name}' })`,
            )
            .join('\n'),
          scenes: Object.fromEntries(
            names.flatMap((name) =>
              turns.map(([angle, x]) => [
                [name, angle, x],
                `${projection}; camera(0, 0, 100, 0, 0, 0, 0, 1, 0); noStroke()
                warps.${name}(); translate(${x}, 0); rotateY(${angle}); scale(30); plane(1, 1, 1, 1)`,
              ]),
            ),
          ),
        },
      )
      for (const [name, { data }] of Object.entries(images)) {
        // Without the edges, where colors are mixed with the background.
        const isSeen = (pixel) => data[4 * pixel] + data[4 * pixel + 1] + data[4 * pixel + 2] > 0
        const seen = [...Array(size * size).keys()].filter((pixel) =>
          [0, 1, -1, size, -size].every((step) => isSeen(pixel + step)),
        )
        assert.ok(seen.length > 50, `${name}: ${seen.length} pixels`)
        const [angle, x] = name.split(',').slice(1).map(Number)
        const toEye = projection.startsWith('ortho') ? [0, 0, 1] : [-x, 0, 100]
        const normal = [Math.sin(angle), 0, Math.cos(angle)]
        const side = Math.sign(normal[0] * toEye[0] + normal[2] * toEye[2])
        const expected = normal.map((value) => 127.5 * (side * value + 1))
        const colors = seen.map((pixel) => [...data.subarray(4 * pixel, 4 * pixel + 3)])
        const isNear = (color) => expected.every((value, i) => Math.abs(value - color[i]) < 4)
        for (const color of colors)
          assert.ok(isNear(color), `${name}: ${color} instead of ${expected}`)
      }
    })
