// glsl.texture in p5 sketches: heights that displace a plane, with its normals, and an image sampled at warped positions in a
// fragment shader. Compares the picture on the canvas with the interpolant in double.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { randomImage, sample } from '../operations/textures.js'
import { leavePage } from '../support/browser/browser.js'
import { normalize } from '../support/browser/matrix.js'
import { colorAt, differingPixels } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

const { browser, server } = await openHost()

const [size, side, height] = [200, 160, 30]
const image = randomImage(7, 5, 4)
// p5 stores images with premultiplied alpha.
image.data = image.data.map((byte, i) => (i % 4 === 3 ? 255 : byte))

/** Creates the image in each of p5's pixel containers. */
const sources = {
  image: `warps.image = createImage(${image.width}, ${image.height})
    fillPixels(warps.image)`,
  graphics: `warps.graphics = createGraphics(${image.width}, ${image.height})
    warps.graphics.pixelDensity(1)
    fillPixels(warps.graphics)`,
  framebuffer: `warps.framebuffer = createFramebuffer({
      width: ${image.width}, height: ${image.height}, density: 1, format: UNSIGNED_BYTE, depth: false, antialias: false,
    })
    fillPixels(warps.framebuffer)`,
  drawn: `warps.drawn = createFramebuffer({
      width: ${image.width}, height: ${image.height}, density: 1,
    })
    warps.drawn.begin()
    noStroke()
    image(warps.image, ${-image.width / 2}, ${-image.height / 2})
    warps.drawn.end()`,
}

const setupOf = (...chosen) => `
  const fillPixels = (target) => {
    target.loadPixels()
    const bytes = ${JSON.stringify(image.data)}
    bytes.forEach((byte, i) => (target.pixels[i] = byte))
    target.updatePixels()
  }
  ${chosen.join('\n')}
  ortho()`

const setup = setupOf(...Object.values(sources))

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

for (const [version, p5] of p5InThisRun) {
  const draw = (options) => drawScenes(browser, server, [p5, addon], { size, ...options })

  describe(`glsl.texture on p5 ${version}`, () => {
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

    test('an image uniform can be a value or a function, and can be overridden in a call', async () => {
      const offset = `({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().add(0.5), { filter: 'bspline' }).r()
        .mult(uniforms.amount))`
      const pictures = await draw({
        setup: `${setup}
          const flat = createImage(1, 1)
          const uniforms = (heights) => ({ type: 'normal', uniforms: { amount: ${height}, heights } })
          warps.value = createWarp(${offset}, uniforms(warps.image))
          warps.follow = createWarp(${offset}, uniforms(() => warps.graphics))
          warps.other = createWarp(${offset}, uniforms(flat))
          warps.byName = createWarp(({ glsl, position }) => glsl.vec3(0, 0, glsl
            .texture('heights', position.xy().add(0.5), { filter: 'bspline' }).r()
            .mult(${height})), { type: 'normal', defs: 'uniform sampler2D heights;' })`,
        scenes: {
          byName: `warps.byName({ heights: warps.image }); plane(${side}, ${side}, 160, 160)`,
          value: `warps.value(); plane(${side}, ${side}, 160, 160)`,
          follow: `warps.follow(); plane(${side}, ${side}, 160, 160)`,
          other: `warps.other({ heights: warps.image }); plane(${side}, ${side}, 160, 160)`,
          flat: `warps.other(); plane(${side}, ${side}, 160, 160)`,
        },
      })
      const { byName, flat, ...others } = pictures
      for (const [name, picture] of Object.entries(others))
        assert.equal(differingPixels(picture, byName, 1), 0, name)
      assert.ok(differingPixels(flat, byName, 30) > 5000, 'the image shows')
    })

    test('by default, an image uses the wrap mode of textureWrap() and its own filter', async () => {
      const offset = (options) => `({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().mult(2.6)${options}).r().mult(${height}))`
      const made = (name, options) =>
        `warps.${name} = createWarp(${offset(options)}, { type: 'normal', uniforms: { heights: warps.image } })`
      const draws = (name, wrap) =>
        `textureWrap(${wrap}); warps.${name}(); plane(${side}, ${side}, 160, 160)`
      const pictures = await draw({
        setup: `${setup}
          ${made('host', '')}
          ${made('clamp', ", { wrap: 'clamp', filter: 'bilinear' }")}
          ${made('repeat', ", { wrap: 'repeat', filter: 'bilinear' }")}
          ${made('mirror', ", { wrap: 'mirror', filter: 'bilinear' }")}`,
        scenes: {
          clamp: draws('clamp', 'CLAMP'),
          repeat: draws('repeat', 'CLAMP'),
          mirror: draws('mirror', 'CLAMP'),
          clampOfHost: draws('host', 'CLAMP'),
          repeatOfHost: draws('host', 'REPEAT'),
          mirrorOfHost: draws('host', 'MIRROR'),
        },
      })
      for (const wrap of ['clamp', 'repeat', 'mirror'])
        assert.equal(differingPixels(pictures[`${wrap}OfHost`], pictures[wrap], 1), 0, wrap)
      assert.ok(differingPixels(pictures.clamp, pictures.repeat, 30) > 3000)
      assert.ok(differingPixels(pictures.mirror, pictures.repeat, 30) > 3000)
    })

    test('in WebGL 1 the warp reads the size of an image from a uniform', async () => {
      const displaced = `warps.displace = createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().add(0.5), { filter: 'bicubic' }).r()
        .mult(${height})), { type: 'normal', uniforms: { heights: () => warps.image } })`
      const scenes = { shown: `warps.displace(); plane(${side}, ${side}, 60, 60)` }
      const [first, second] = [
        // p5 warns about framebuffers there.
        await draw({
          setup: `setAttributes({ version: 1 })\nif (webglVersion !== 'webgl') throw new Error('no WebGL 1')\n${setupOf(sources.image)}\n${displaced}`,
          scenes,
        }),
        await draw({ setup: `${setup}\n${displaced}`, scenes }),
      ]
      assert.ok(differingPixels(first.shown, second.shown, 2) < 40)
    })

    // plane(160, 160) is a plane of 1 by 1 that is scaled in two directions, but not in the third.
    test('a displaced plane is lit the same whether plane() or scale() sets its size', async () => {
      const warp = (amount) => `createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().add(0.5), { filter: 'bspline' }).r()
        .mult(${amount})), { uniforms: { heights: warps.image } })`
      const light = 'ambientLight(60); directionalLight(255, 255, 255, 0.8, 0.2, -0.5); fill(200);'
      const pictures = await draw({
        setup: `${setup}
          warps.flat = ${warp(height)}
          warps.even = ${warp(height / side)}`,
        scenes: {
          flat: `${light} warps.flat(); plane(${side}, ${side}, 60, 60)`,
          even: `${light} scale(${side}); warps.even(); plane(1, 1, 60, 60)`,
        },
      })
      assert.ok(differingPixels(pictures.flat, pictures.even, 3) < 40)
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

    test('throws a WarpError for a value that is not an image', async () => {
      const cases = {
        'createWarp(warp)': /reads "heights", .* "uniform highp sampler2D heights;"/,
        'distort({ heights: 5 })':
          /expected an image, such as one of loadImage or createGraphics, for the uniform "heights", got the number 5/,
        'inUniforms({ heights: 5 })':
          /expected an image, .* for the uniform "heights", got the number 5/,
        'distort({ heights: null })': /expected an image, .* for the uniform "heights", got null/,
        'distort({ heights: "a.png" })': /expected an image, .* got the text "a.png"/,
        'distort({ heights: Promise.resolve() })': /expected an image, .* got a promise/,
      }
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, addon],
        `const warp = ({ glsl, position }) =>
          glsl.vec3(0, 0, glsl.texture('heights', position.xy()).r())
        function setup() {
          createCanvas(100, 100, WEBGL)
          distort = createWarp(warp, { defs: 'uniform sampler2D heights;' })
          inUniforms = createWarp(
            ({ glsl, position, uniforms }) =>
              glsl.vec3(0, 0, glsl.texture(uniforms.heights, position.xy()).r()),
            { uniforms: { heights: createImage(2, 2) } },
          )
          noLoop()
        }
        function draw() {
          distort({ heights: createImage(2, 2) })
          sphere(20)
          window.done = true
        }`,
      )
      for (const [code, message] of Object.entries(cases)) {
        const error = await page.evaluate(`(() => {
          try { ${code} } catch (error) { return { name: error.name, message: error.message } }
        })()`)
        assert.equal(error?.name, 'WarpError', code)
        assert.match(error.message, message)
      }
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })
}
