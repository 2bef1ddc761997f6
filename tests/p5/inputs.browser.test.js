// The inputs of warps in sketches, on each host. For uniforms, checks the position of the drawing, in both versions of WebGL. For images,
// which glsl.texture samples as heights of a plane, or at warped positions in a fragment shader, compares pictures with values and normals
// that are interpolated in double.
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
import { colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import { bend, turningShader } from './scenes/shader.js'

/** Returns the distance of the drawing from the centre of the canvas to the right and down, in pixels. */
function positionIn(picture) {
  const lit = litPixels(picture)
  const mean = (axis) => lit.reduce((sum, pixel) => sum + pixel[axis], 0) / lit.length
  return [mean('x'), mean('y')].map(Math.round)
}

/** Returns the arguments of createWarp for a warp in pixels. */
const moves = (offset, uniforms, more = '') =>
  `(({ glsl, uniforms }) => ${offset}), { space: 'world', uniforms: { ${uniforms} }, ${more} }`

const hosts = await openP5Hosts()

/** The hosts, on WebGL once for each version of WebGL; `choose` is code for setup() that selects the version and checks it. */
const variants = hosts.flatMap((host) =>
  host.isWebGPU
    ? [{ ...host, choose: '' }]
    : [2, 1].map((webgl) => ({
        ...host,
        name: `${host.name} ${webgl}`,
        choose: `${webgl === 1 ? 'setAttributes({ version: 1 })' : ''}
          if (drawingContext instanceof WebGL2RenderingContext !== ${webgl === 2}) throw 'wrong version of WebGL'`,
      })),
)

for (const { name: host, isWebGPU, choose, draw } of variants)
  describe(`uniforms on ${host}`, () => {
    const shape = `fill('red'); plane(20)`

    /** Draws scenes. Returns an object that maps their names to positions. `warps` maps names to arguments of createWarp. */
    async function drawnPositions(warps, scenes, before = '') {
      const setup = Object.entries(warps).map(
        ([name, args]) => `warps.${name} = createWarp(${args})`,
      )
      const images = await draw({
        setup: [choose, before, ...setup].join('\n'),
        scenes: Object.fromEntries(
          Object.entries(scenes).map(([name, code]) => [name, `${code}; ${shape}`]),
        ),
      })
      return Object.fromEntries(
        Object.entries(images).map(([name, image]) => [name, positionIn(image)]),
      )
    }

    test('of each type reach the shader', async () => {
      const warps = {
        number: moves('glsl.vec3(uniforms.a, 0, 0)', 'a: 40'),
        truth: moves('glsl.vec3(uniforms.a.mult(40).add(uniforms.b), 0, 0)', 'a: true, b: false'),
        vec2: moves('glsl.vec3(uniforms.a, 0)', 'a: [40, 0]'),
        vec3: moves('uniforms.a', 'a: [40, 0, 0]'),
        vec4: moves('uniforms.a.wyz()', 'a: [9, 0, 0, 40]'),
        typed: moves('uniforms.a', 'a: new Float32Array([40, 0, 0])'),
        mat3: moves('uniforms.a.mult(glsl.vec3(0, -40, 0))', 'a: [0, 1, 0, -1, 0, 0, 0, 0, 1]'),
        mat4: moves(
          'uniforms.a.mult(glsl.vec4(0, 0, 0, 1)).xyz()',
          'a: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 40, 0, 0, 1]',
        ),
        vector: moves('uniforms.a', 'a: createVector(40, 0, 0)'),
        color: moves('glsl.vec3(uniforms.a.g().mult(40), uniforms.a.r(), 0)', `a: color('lime')`),
        many: moves(
          'glsl.vec3(uniforms.a.sub(uniforms.b), uniforms.c.x(), 0)',
          'a: 60, b: 20, c: [0, 3]',
        ),
      }
      const scenes = Object.fromEntries(Object.keys(warps).map((name) => [name, `warps.${name}()`]))
      for (const [name, found] of Object.entries(await drawnPositions(warps, scenes)))
        assert.deepEqual(found, [40, 0], name)
    })

    test('are read at each call of a warp, and can be overridden for one call', async () => {
      const warps = {
        fixed: moves('glsl.vec3(uniforms.a, 0)', 'a: [40, 0]'),
        follow: moves('glsl.vec3(uniforms.at, 0)', 'at: () => [mouseX, frame]'),
        grow: moves('glsl.vec3(uniforms.x, uniforms.y, 0)', 'x: 10, y: () => frame'),
      }
      const found = await drawnPositions(
        warps,
        {
          fixed: 'warps.fixed()',
          replaced: 'warps.fixed({ a: [20, 30] })',
          'as before': 'warps.fixed()',
          'by a vector': 'warps.fixed({ a: createVector(15, 25) })',
          'by functions': 'frame = 5; warps.follow()',
          'by functions, again': 'frame = 50; warps.follow()',
          'one overridden, one by a function': 'frame = 7; warps.grow({ x: 33 })',
          'the function overridden': 'frame = 7; warps.grow({ y: 8 })',
          'twice in a frame': 'warps.fixed({ a: [60, 60] }); warps.fixed()',
          'by the material': 'warps.fixed({ a: [20, 30] }); normalMaterial()',
        },
        'globalThis.frame = 0',
      )
      assert.deepEqual(found, {
        fixed: [40, 0],
        replaced: [20, 30],
        'as before': [40, 0],
        'by a vector': [15, 25],
        'by functions': [30, 5],
        'by functions, again': [30, 50],
        'one overridden, one by a function': [33, 7],
        'the function overridden': [10, 8],
        'twice in a frame': [40, 0],
        'by the material': [20, 30],
      })
    })

    test('may have any name, and can be combined with defs', async () => {
      const names =
        'uModelViewMatrix,float,aPosition,offset,gl_Position,a__b,größe,a b,main,toString'.split(
          ',',
        )
      const any = names.map((name) => `uniforms[${JSON.stringify(name)}]`)
      const warps = {
        any: moves(
          `glsl.vec3(${any.slice(1).reduce((sum, name) => `${sum}.add(${name})`, any[0])}, 0, 0)`,
          names.map((name) => `${JSON.stringify(name)}: 4`).join(', '),
        ),
        defs: moves(
          `glsl.vec3(uniforms.a.add(glsl.param('half_of(b)')), glsl.param('b'), 0)`,
          'a: 10, unread: [1, 2]',
          isWebGPU
            ? `defs: 'uniform float b; fn half_of(a: f32) -> f32 { return 0.5 * a; }'`
            : `defs: 'uniform float b; float half_of(float a) { return 0.5 * a; }'`,
        ),
      }
      const found = await drawnPositions(warps, {
        any: 'warps.any()',
        'any given': 'warps.any({ "a b": 14 })',
        defs: 'warps.defs({ a: 20, b: 40 })',
        // A uniform that defs declares keeps its last value.
        again: 'warps.defs({ unread: [3, 4] })',
      })
      assert.deepEqual(found, {
        any: [40, 0],
        'any given': [50, 0],
        defs: [40, 40],
        again: [30, 40],
      })
    })
  })

for (const host of hosts)
  test(`${host.name}: uniforms of the sketch's shader have the values that setUniform() or the call of the warp sets`, async () => {
    const { whole, half, quarter } = await host.draw({
      setup: `${turningShader(host)}; distort = createWarp(${bend}, { shader: warps.turning })`,
      scenes: {
        whole: `noStroke(); distort(); fill(200, 0, 0); sphere(60)`,
        half: `shader(warps.turning); warps.turning.setUniform('red', 0.5); noStroke(); distort(); fill(200, 0, 0); sphere(60)`,
        quarter: `noStroke(); distort({ red: 0.25 }); fill(200, 0, 0); sphere(60)`,
      },
    })
    const red = (image) => colorAt(image, 100, 100)[0]
    assert.deepEqual([red(whole), red(half), red(quarter)], [200, 100, 50])
  })

const size = 200

/** Returns points from 0 to 1. */
const grid = (count) =>
  Array.from({ length: count * count }, (_, i) => [
    ((i % count) + 0.37) / count,
    (Math.floor(i / count) + 0.41) / count,
  ])

/** Converts a coordinate on the plane, from 0 to 1, to pixels. */
const onCanvas = (u) => (size - side) / 2 + side * u

function assertColor(picture, [u, v], expected, tolerance, what) {
  const color = colorAt(picture, onCanvas(u), onCanvas(v))
  const error = Math.max(...expected.map((x, i) => Math.abs(color[i] - x)))
  assert.ok(error <= tolerance, `${what} at ${[u, v]}: expected ${expected}, got ${color}`)
}

for (const host of hosts) {
  const { isWebGPU, draw } = host
  // In p5 2.3, updatePixels() of a framebuffer fails on WEBGPU.
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
            const expected = normal.map((x) => 255 * Math.max(x, 0))
            assertColor(picture, [u, v], expected, 4, name)
          }
      })

    // The remaining tests are about GLSL.
    if (isWebGPU) return

    test("images wrap according to p5's textureWrap()", async () => {
      const options = '{ filter: "bspline" }'
      const displaced = `createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().mult(3), ${options}).r().mult(${height / 3})),
        { type: 'normal', uniforms: { heights: () => warps.image } })`
      const wraps = { REPEAT: 'repeat', MIRROR: 'mirror', CLAMP: 'clamp' }
      const pictures = await draw({
        setup: `${setup}\nwarps.displace = ${displaced}`,
        scenes: Object.fromEntries(
          Object.keys(wraps).map((name) => [
            name,
            `textureWrap(${name}); warps.displace(); plane(${side}, ${side}, 240, 240)`,
          ]),
        ),
      })
      for (const [name, wrap] of Object.entries(wraps)) {
        const heightAt = (u, v) =>
          (height / 3) * sample(image, 3 * (u - 0.5), 3 * (v - 0.5), { wrap, filter: 'bspline' })[0]
        const step = 1e-4
        // A pixel shows the normal at its centre.
        for (const [u, v] of grid(12).map((place) =>
          place.map((t) => (Math.floor(t * side) + 0.5) / side),
        )) {
          const normal = normalize([
            -(heightAt(u + step, v) - heightAt(u - step, v)) / (2 * step * side),
            -(heightAt(u, v + step) - heightAt(u, v - step)) / (2 * step * side),
            1,
          ])
          assertColor(
            pictures[name],
            [u, v],
            normal.map((x) => 255 * Math.max(x, 0)),
            4,
            name,
          )
        }
      }
    })

    test('in WebGL 1 the warp reads the size of an image from a uniform', async () => {
      const displaced = `warps.displace = createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
        .texture(uniforms.heights, position.xy().add(0.5), { filter: 'bicubic' }).r()
        .mult(${height})), { type: 'normal', uniforms: { heights: () => warps.image } })`
      const scenes = { shown: `warps.displace(); plane(${side}, ${side}, 60, 60)` }
      const [first, second] = [
        // Uses only an image, since p5 warns about framebuffers in WebGL 1.
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
      const warpUv = (u, v) => [u + 0.1 * Math.sin(5 * v), v + 0.1 * Math.sin(5 * u)]
      const options = { wrap: 'mirror', filter: 'bicubic' }
      // A pixel shows the value at its centre.
      for (const [u, v] of grid(20).map((place) =>
        place.map((t) => (Math.floor(t * side) + 0.5) / side),
      )) {
        const color = sample(image, ...warpUv(u, v), options).slice(0, 3)
        const expected = color.map((channel) => 255 * Math.min(Math.max(channel, 0), 1))
        assertColor(pictures.image, [u, v], expected, 1.5, 'color')
      }
    })
  })
}
