// Normals where an offset has no usable derivatives: at the border of its domain, and where it collapses the surface.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { lookFromAfar, shaderOfNormals } from '../support/browser/p5-shown-normals.js'
import { drawScenes, openHosts, p5HostsInThisRun, p5InThisRun } from '../support/browser/sketch.js'

const size = 120
const { browsers, server } = await openHosts(p5HostsInThisRun)

// Tests warps whose domain ends at the border of their mesh, on antialiased canvases: the centers of some pixels at the border are outside
// of the mesh, where the offset is undefined. Not on WEBGPU: SwiftShader showed no defects there, even before we reflected points at
// borders.
/**
 * At the right edge of the plane, where x is 0.5, slopes are infinite or, if the domain ends 0.004 beyond the edge, steep: the normal is
 * nearly the x axis there. It is nearly the z axis on the left and, if undefined values are not handled, outside.
 */
const offsets = {
  sqrt: ({ glsl, position }) => glsl.vec3(0, 0, glsl.val(0.5).sub(position.x()).sqrt().mult(2)),
  pow: ({ glsl, position }) => glsl.vec3(0, 0, glsl.val(0.5).sub(position.x()).pow(0.3)),
  log: ({ glsl, position }) => glsl.vec3(0, 0, glsl.val(0.504).sub(position.x()).log().mult(0.2)),
  acos: ({ glsl, position }) => glsl.vec3(0, 0, position.x().mult(2).acos()),
  asin: ({ glsl, position }) => glsl.vec3(0, 0, position.x().mult(-2).asin()),
  atanh: ({ glsl, position }) => glsl.vec3(0, 0, position.x().mult(-1.99).atanh().mult(0.2)),
  acosh: ({ glsl, position }) => glsl.vec3(0, 0, glsl.val(1.5).sub(position.x()).acosh()),
  dome: ({ glsl, position }) =>
    glsl.vec3(0, 0, glsl.val(0.25).sub(position.x().mult(position.x())).sqrt().mult(2)),
  // Its normal also depends on the value of the root.
  slanted: ({ glsl, position }) =>
    glsl.vec3(0, 0, glsl.val(0.5).sub(position.x()).sqrt().mult(position.y().add(2))),
}

/** The rotation of the plane. */
const [cosine, sine] = [Math.cos(0.3), Math.sin(0.3)]
/** The pixels at the right border, with x and y from -0.5 to 0.5 across the plane. */
const border = Array.from({ length: size * size }, (_, pixel) => {
  const [x, y] = [(pixel % size) + 0.5 - size / 2, Math.floor(pixel / size) + 0.5 - size / 2]
  return { pixel, x: (cosine * x + sine * y) / 60, y: (cosine * y - sine * x) / 60 }
}).filter(({ x, y }) => Math.abs(x - 0.5) < 0.7 / 60 && Math.abs(y) < 0.45)

/**
 * Draws the plane with each offset, rotated so that its edges pass pixel centers at all distances. The background has the color of the
 * border.
 */
function drawBorders(version, p5, attributes) {
  const draw = (name) => `background(249, 165, 128); warps.${name}(); noStroke()
    ${lookFromAfar(size)}
    rotateZ(0.3); scale(60); plane(1, 1, 40, 40)`
  const names = Object.keys(offsets)
  const warps = names.map(
    (name) =>
      `warps.${name} = createWarp(${offsets[name]}, { shader: ${shaderOfNormals(version, 'WEBGL')}, normals: 'pixel' })`,
  )
  return drawScenes(browsers.WEBGL, server, [p5, '/dist/p5.warpjet.min.js'], {
    size,
    setup: [`setAttributes({ ${attributes} })`, ...warps].join('\n'),
    scenes: Object.fromEntries(names.map((name) => [name, draw(name)])),
  })
}

const colorsOf = ({ data }) =>
  border.map(({ pixel, x, y }) => ({ x, y, color: [...data.subarray(4 * pixel, 4 * pixel + 3)] }))

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: borders of antialiased warps do not flash`, async () => {
    const images = await drawBorders(version, p5, 'antialias: true')
    assert.ok(border.length > 60, `${border.length} pixels`)
    for (const [name, image] of Object.entries(images))
      for (const { x, y, color } of colorsOf(image)) {
        const [red, , blue] = color
        assert.ok(red > 225 && blue < 190, `${name} at ${x}, ${y}: ${color}`)
      }
  })

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: borders are finite in WebGL 1, which has no derivatives on the screen`, async () => {
    const images = await drawBorders(version, p5, 'antialias: true, version: 1')
    for (const [name, image] of Object.entries(images))
      for (const { x, y, color } of colorsOf(image)) {
        // Each color is an average of colors of normals that face the eye, and of the background.
        assert.ok(color[2] > 120, `${name} at ${x}, ${y}: ${color}`)
      }
  })

// The normal of a surface that a warp collapses is the geometric normal of the triangle that faces the eye. In a parallel projection, the
// direction to the eye is z, whereas the direction to the origin of view space may be on the other side of a steep triangle.
/** Does not move the four vertices of the plane; but its derivatives collapse any surface to a point. */
const collapse = ({ position }) => position.mult(2).round().div(2).sub(position)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  for (const projection of [`ortho(-60, 60, -60, 60, -500, 500)`, 'perspective(1, 1, 10, 2000)'])
    test(`p5 ${version} on ${renderer}: a collapsed surface has the geometric normal, ${projection}`, async () => {
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
                `warps.${name} = createWarp(${collapse}, { shader: ${shaderOfNormals(version, renderer)}, normals: '${name}' })`,
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
        // Leaves out the edges, where antialiasing mixes colors with the background.
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
