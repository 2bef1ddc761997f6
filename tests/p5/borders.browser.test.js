// A warp that ends where its mesh ends, on an antialiased canvas: the centers of pixels at the border are outside of the mesh.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { drawScenes, openHosts, p5InThisRun } from '../support/browser/sketch.js'

const size = 120

// The square root has its vertical tangent at the right edge of the plane: the normal is nearly that of x there, and that of z outside.
const offset = ({ glsl, position }) =>
  glsl.vec3(0, 0, glsl.val(0.5).sub(position.x()).sqrt().mult(2))

const { browsers, server } = await openHosts([['2.x', 'WEBGL']])

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: the border of an antialiased warp does not flash`, async () => {
    const parameters = version === '1.11' ? '(vec4 color)' : '(vec4 color, vec2 texCoord)'
    const hooks = {
      fragmentDeclarations: 'vec3 shown;',
      'Inputs getPixelInputs': '(Inputs inputs) { shown = inputs.normal; return inputs; }',
      'vec4 getFinalColor': `${parameters} { return vec4(shown * 0.5 + 0.5, 1.0); }`,
    }
    // The background has the color of the border.
    const draw = `background(249, 165, 128); warps.root(); noStroke()
      perspective(2 * atan(${size / 2 / 1000}), 1, 100, 5000)
      camera(0, 0, 1000, 0, 0, 0, 0, 1, 0)
      rotateZ(0.3); scale(60); plane(1, 1, 40, 40)`
    const { root } = await drawScenes(browsers.WEBGL, server, [p5, '/dist/p5.warpjet.min.js'], {
      size,
      setup: `setAttributes({ antialias: true })
        warps.root = createWarp(${offset}, { shader: baseMaterialShader().modify(${JSON.stringify(hooks)}), normals: 'pixel' })`,
      scenes: { root: draw },
    })
    const [cosine, sine] = [Math.cos(0.3), Math.sin(0.3)]
    let border = 0
    for (let pixel = 0; pixel < size * size; pixel++) {
      const [x, y] = [(pixel % size) + 0.5 - size / 2, Math.floor(pixel / size) + 0.5 - size / 2]
      const [along, across] = [(cosine * x + sine * y) / 60, (cosine * y - sine * x) / 60]
      if (Math.abs(along - 0.5) > 0.7 / 60 || Math.abs(across) > 0.45) continue
      border++
      const [red, green, blue] = root.data.subarray(4 * pixel, 4 * pixel + 3)
      assert.ok(red > 225 && blue < 185, `at ${x}, ${y}: ${[red, green, blue]}`)
    }
    assert.ok(border > 60, `${border} pixels`)
  })
