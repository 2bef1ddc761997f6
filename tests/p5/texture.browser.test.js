// glsl.texture in p5 sketches: heights that displace a plane, with its normals, and an image sampled at warped positions in a
// fragment shader. Compares the picture on the canvas with the interpolant in double.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { sample } from '../operations/textures.js'
import { normalize } from '../support/browser/matrix.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import {
  planeHeight as height,
  heightImage as image,
  imageSources,
  setupOfImages,
  planeSide as side,
} from '../support/browser/p5-images.js'
import { colorAt, differingPixels } from '../support/browser/pixels.js'

const size = 200

const grid = (count) =>
  Array.from({ length: count * count }, (_, i) => [
    ((i % count) + 0.37) / count,
    (Math.floor(i / count) + 0.41) / count,
  ])

const onCanvas = (u) => (size - side) / 2 + side * u

function assertColor(picture, [u, v], wanted, tolerance, what) {
  const color = colorAt(picture, onCanvas(u), onCanvas(v))
  const error = Math.max(...wanted.map((x, i) => Math.abs(color[i] - x)))
  assert.ok(error <= tolerance, `${what} at ${[u, v]}: expected ${wanted}, got ${color}`)
}

for (const host of await openP5Hosts()) {
  const { isWebGPU, draw } = host
  // In p5 2.3 updatePixels() of a framebuffer fails on WEBGPU.
  const { framebuffer, ...others } = imageSources
  const sources = isWebGPU ? others : { framebuffer, ...others }
  const setup = setupOfImages(host, ...Object.values(sources))

  describe(`glsl.texture on ${host.name}`, () => {
    for (const filter of ['bicubic', 'bspline'])
      test(`a height map displaces a plane, with its normals: ${filter}`, async () => {
        const pictures = await draw({
          setup: `${setup}
          warps.displace = createWarp(({ glsl, position }) => {
            const uv = position.xy().add(0.5)
            const heights = glsl.texture('heights', uv, { filter: '${filter}' })
            return glsl.vec3(0, 0, heights.r().mult(${height}))
          }, { type: 'normal', defs: 'uniform sampler2D heights;' })`,
          scenes: Object.fromEntries(
            Object.keys(sources).map((name) => [
              name,
              `warps.displace({ heights: warps.${name} }); plane(${side}, ${side}, 160, 160)`,
            ]),
          ),
        })
        const heightAt = (u, v) => height * sample(image, u, v, { filter })[0]
        const step = 1e-4
        for (const [name, picture] of Object.entries(pictures))
          for (const [u, v] of grid(12)) {
            const normal = normalize([
              -(heightAt(u + step, v) - heightAt(u - step, v)) / (2 * step * side),
              -(heightAt(u, v + step) - heightAt(u, v - step)) / (2 * step * side),
              1,
            ])
            const wanted = normal.map((x) => 255 * Math.max(x, 0))
            assertColor(picture, [u, v], wanted, 4, name)
          }
      })

    // The rest is about GLSL.
    if (isWebGPU) return

    test('in WebGL 1 the warp reads the size of an image from a uniform', async () => {
      const displaced = `warps.displace = createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().add(0.5), { filter: 'bicubic' }).r()
        .mult(${height})), { type: 'normal', uniforms: { heights: () => warps.image } })`
      const scenes = { shown: `warps.displace(); plane(${side}, ${side}, 60, 60)` }
      const [first, second] = [
        // p5 warns about framebuffers there.
        await draw({
          setup: `setAttributes({ version: 1 })\nif (webglVersion !== 'webgl') throw new Error('no WebGL 1')\n${setupOfImages(host, sources.image)}\n${displaced}`,
          scenes,
        }),
        await draw({ setup: `${setup}\n${displaced}`, scenes }),
      ]
      assert.ok(differingPixels(first.shown, second.shown, 2) < 40)
    })

    test('a fragment shader can sample an image at a warped position', async () => {
      const { code, declarations, uniforms } = compile((glsl) => {
        const uv = glsl.vec2Param('vTexCoord')
        const moved = uv.add(uv.yx().mult(5).sin().mult(0.1))
        return { color: glsl.texture('picture', moved, { wrap: 'mirror', filter: 'bicubic' }) }
      })
      assert.deepEqual(uniforms, [
        { name: 'vTexCoord', type: 'vec2' },
        { name: 'picture', type: 'sampler2D' },
      ])
      const vertex = `#version 300 es
precision highp float;
in vec3 aPosition;
in vec2 aTexCoord;
uniform mat4 uModelViewMatrix, uProjectionMatrix;
out vec2 vTexCoord;
void main() {
  vTexCoord = aTexCoord;
  gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(aPosition, 1.0);
}`
      const fragment = `#version 300 es
precision highp float;
in vec2 vTexCoord;
uniform sampler2D picture;
out vec4 result;
${declarations}
void main() {
  ${code}
  result = color;
}`
      const pictures = await draw({
        setup: `${setup}
        noStroke()
        warps.show = createShader(${JSON.stringify(vertex)}, ${JSON.stringify(fragment)})`,
        scenes: {
          image: `shader(warps.show); warps.show.setUniform('picture', warps.image); plane(${side}, ${side})`,
        },
      })
      const moved = (u, v) => [u + 0.1 * Math.sin(5 * v), v + 0.1 * Math.sin(5 * u)]
      const options = { wrap: 'mirror', filter: 'bicubic' }
      // A pixel shows the value at its centre.
      for (const [u, v] of grid(20).map((place) =>
        place.map((t) => (Math.floor(t * side) + 0.5) / side),
      )) {
        const color = sample(image, ...moved(u, v), options).slice(0, 3)
        const wanted = color.map((channel) => 255 * Math.min(Math.max(channel, 0), 1))
        assertColor(pictures.image, [u, v], wanted, 1.5, 'color')
      }
    })
  })
}
