// Tests glsl.texture on every pipeline: compares values, gradients and second derivatives with an interpolation in double precision and its
// finite differences. Also tests wrapping, several images at once, and continuity at texels.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { differentiate } from '../../dist/glsl.js'
import { compile } from '../../dist/warpjet.js'
import { filters, randomImage, sample, wraps } from '../operations/textures.js'
import { randomOf } from '../random/generate.js'
import { openPipelines, targetsInThisRun as targets } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

const image = randomImage(7, 5)
const inputs = [{ name: 'uv', shape: 2 }]

/** Evaluates the results of `build` at points. `shapes` maps the name of a result → its shape. Returns, for each point, name → numbers. */
async function run(target, shapes, build, points, images = { heights: image }) {
  const { code, declarations } = compile((glsl) => build(glsl, glsl.vec2Param('uv')), { target })
  const outputs = Object.entries(shapes).map(([name, shape]) => ({ name, shape }))
  const results = await pipelines.run(
    target,
    { code, declarations, inputs, outputs, images },
    points,
  )
  return results.map((floats) => {
    let at = 0
    return Object.fromEntries(
      outputs.map(({ name, shape }) => {
        const size = shape === 'mat2' ? 4 : shape
        return [name, [...floats.slice(at, (at += size))]]
      }),
    )
  })
}

/** Returns random float32 points in the image and two images around it, at least 1/64 texel from the borders of the polynomial pieces. */
function smoothPoints(count) {
  const random = randomOf(11)
  const along = (size) => {
    const texel = Math.floor((random() * 5 - 2) * size) + 0.5
    return Math.fround((texel + 1 / 64 + (31 / 32) * random()) / size)
  }
  return Array.from({ length: count }, () => [along(image.width), along(image.height)])
}

const points = smoothPoints(150)
/** The steps of finite differences in u and in v, a small fraction of a texel. */
const steps = [image.width, image.height].map((size) => 1 / (128 * size))

/** Computes derivatives of red from finite differences that are exact for polynomials of third degree in u and in v. */
function derivatives([u, v], options) {
  const at = (i, j) => sample(image, u + i * steps[0], v + j * steps[1], options)[0]
  const slope = (f, step) => (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * step)
  const secondDerivative = (f, step) => (f(1) - 2 * f(0) + f(-1)) / step ** 2
  const mixed = slope((j) => slope((i) => at(i, j), steps[0]), steps[1])
  return {
    gradient: [slope((i) => at(i, 0), steps[0]), slope((j) => at(0, j), steps[1])],
    hessian: [
      secondDerivative((i) => at(i, 0), steps[0]),
      mixed,
      mixed,
      secondDerivative((j) => at(0, j), steps[1]),
    ],
  }
}

const maxDifference = (actual, expected) =>
  Math.max(...actual.map((x, i) => Math.abs(x - expected[i])))

function assertClose(actual, expected, tolerance, what) {
  assert.equal(actual.length, expected.length)
  const error = maxDifference(actual, expected)
  assert.ok(error <= tolerance, `${what}: ${actual}, not ${expected}, off by ${error}`)
}

for (const target of targets)
  describe(`glsl.texture in ${target}`, () => {
    for (const filter of filters)
      for (const wrap of wraps)
        test(`${filter} and ${wrap}: value, gradient and second derivatives agree with the interpolation in double precision`, async () => {
          const options = { filter, wrap }
          const results = await run(
            target,
            { color: 4, gradient: 2, hessian: 'mat2' },
            (glsl, uv) => {
              const color = glsl.texture('heights', uv, options)
              const gradient = glsl.gradient(color.r(), uv)
              return { color, gradient, hessian: glsl.jacobian(gradient, uv) }
            },
            points,
          )
          results.forEach(({ color, gradient, hessian }, i) => {
            const where = `at ${points[i]}`
            assertClose(color, sample(image, ...points[i], options), 1e-5, `value ${where}`)
            const expected = derivatives(points[i], options)
            assertClose(gradient, expected.gradient, 2e-4, `gradient ${where}`)
            assertClose(hessian, expected.hessian, 5e-3, `second derivatives ${where}`)
          })
        })

    test('the filter nearest returns the texel itself, and so does GLSL source with texelFetch and textureSize', async () => {
      const text = `uniform sampler2D heights;
        vec4 fetched(vec2 uv) {
          ivec2 size = textureSize(heights, 0);
          ivec2 ij = clamp(ivec2(floor(uv * vec2(size))), ivec2(0), size - 1);
          return texelFetch(heights, ij, 0);
        }`
      const { width, height } = image
      const inside = [0.1, 0.3, 0.6, 0.9].flatMap((part) =>
        Array.from({ length: width + 2 }, (_, i) => [
          (i - 1 + part) / width,
          ((3 * i + 1) % height) / height + (1 - part) / height,
        ]),
      )
      const results = await run(
        target,
        { nearest: 4, fetched: 4, slope: 2 },
        (glsl, uv) => {
          const nearest = glsl.texture('heights', uv, { filter: 'nearest' })
          const fetched = glsl.source(text)(uv)
          return { nearest, fetched, slope: glsl.gradient(fetched.r().add(nearest.g()), uv) }
        },
        inside,
      )
      results.forEach(({ nearest, fetched, slope }, i) => {
        const expected = sample(image, ...inside[i], { filter: 'nearest' })
        assertClose(nearest, expected, 1e-6, `nearest at ${inside[i]}`)
        assertClose(fetched, expected, 1e-6, `fetched at ${inside[i]}`)
        assertClose(slope, [0, 0], 0, 'slope')
      })
    })

    test('GLSL source with texture() has the right value, gradient and second derivatives, also if the image is an argument', async () => {
      const text = `#version 300 es
        uniform sampler2D heights;
        float heightOf(sampler2D image, vec2 at) { return texture(image, at).r; }
        vec4 read(vec2 uv) { return vec4(heightOf(heights, uv), textureLod(heights, uv, 0.0).gba); }`
      const results = await run(
        target,
        { color: 4, gradient: 2, hessian: 'mat2' },
        (glsl, uv) => {
          const color = glsl.source(text)(uv)
          const gradient = glsl.gradient(color.r(), uv)
          return { color, gradient, hessian: glsl.jacobian(gradient, uv) }
        },
        points,
      )
      results.forEach(({ color, gradient, hessian }, i) => {
        assertClose(color, sample(image, ...points[i]), 1e-5, `value at ${points[i]}`)
        const expected = derivatives(points[i], {})
        assertClose(gradient, expected.gradient, 2e-4, `gradient at ${points[i]}`)
        assertClose(hessian, expected.hessian, 5e-3, `second derivatives at ${points[i]}`)
      })
    })

    test('GLSL 1.00 source with texture2D can be differentiated to GLSL 1.00', async () => {
      const text = `#version 100
        uniform sampler2D heights;
        float height(vec2 uv) { return texture2D(heights, uv).r; }`
      const declarations = differentiate(text, { by: 'uv', target })
      const results = await pipelines.run(
        target,
        {
          code: `${target === 'wgsl' ? 'let' : 'vec3'} both = heightGradient(uv);`,
          declarations,
          inputs,
          outputs: [{ name: 'both', shape: 3 }],
          images: { heights: image },
        },
        points,
      )
      results.forEach(([height, ...gradient], i) => {
        assertClose([height], sample(image, ...points[i]).slice(0, 1), 1e-5, `at ${points[i]}`)
        assertClose(gradient, derivatives(points[i], {}).gradient, 2e-4, `gradient at ${points[i]}`)
      })
    })

    test('is continuous at texels, and smooth if cubic', async () => {
      // The points are just before and just after a line through the centers of texels.
      const side = 2 ** -20
      const lines = [0.5, 1.5, 3.5, 6.5, 7.5, -0.5].map((x) => x / image.width)
      const pairs = lines.flatMap((u) => [
        [u - side, 0.37],
        [u + side, 0.37],
      ])
      for (const filter of filters)
        for (const wrap of wraps) {
          const results = await run(
            target,
            { red: 1, slope: 1, second: 1 },
            (glsl, uv) => {
              const red = glsl.texture('heights', uv, { filter, wrap }).r()
              const slope = glsl.derivative(red, uv.x())
              return { red, slope, second: glsl.derivative(slope, uv.x()) }
            },
            pairs,
          )
          for (let i = 0; i < results.length; i += 2) {
            const [before, after] = results.slice(i, i + 2)
            const jump = (name) => Math.abs(before[name] - after[name])
            const where = `${filter}, ${wrap}, at ${pairs[i]}`
            assert.ok(jump('red') < 1e-4, `${where}: the value jumps by ${jump('red')}`)
            if (filter === 'bilinear') continue
            assert.ok(jump('slope') < 2e-3, `${where}: the slope jumps by ${jump('slope')}`)
            if (filter === 'bicubic') continue
            assert.ok(
              jump('second') < 2e-2,
              `${where}: the second derivative jumps by ${jump('second')}`,
            )
          }
        }
    })

    test('the bicubic and the bilinear filter return the color of a texel at its center', async () => {
      const centres = Array.from({ length: image.width * image.height }, (_, i) => [
        ((i % image.width) + 0.5) / image.width,
        (Math.floor(i / image.width) + 0.5) / image.height,
      ])
      for (const filter of ['bilinear', 'bicubic']) {
        const build = (glsl, uv) => ({ color: glsl.texture('heights', uv, { filter }) })
        const results = await run(target, { color: 4 }, build, centres)
        results.forEach(({ color }, i) => {
          const texel = image.data.slice(4 * i, 4 * i + 4).map((byte) => byte / 255)
          assertClose(color, texel, 1e-5, `${filter}, texel ${i}`)
        })
      }
    })

    test('several images, filters and wrap modes can be combined', async () => {
      const images = { a: image, B: randomImage(4, 8, 2), b: randomImage(1, 1, 3) }
      const results = await run(
        target,
        { color: 4, slope: 1 },
        (glsl, uv) => {
          const moved = uv.add(glsl.texture('a', uv, { filter: 'bspline' }).rg())
          const color = glsl
            .texture('B', moved, { filter: 'bicubic', wrap: 'repeat' })
            .add(glsl.texture('b', uv), glsl.texture('B', uv, { wrap: 'mirror' }))
          return { color, slope: glsl.derivative(color.g(), uv.y()) }
        },
        points,
        images,
      )
      const at = ([u, v]) => {
        const [red, green] = sample(images.a, u, v, { filter: 'bspline' })
        const samples = [
          sample(images.B, u + red, v + green, { filter: 'bicubic', wrap: 'repeat' }),
          sample(images.b, u, v),
          sample(images.B, u, v, { wrap: 'mirror' }),
        ]
        return [0, 1, 2, 3].map((i) => samples[0][i] + samples[1][i] + samples[2][i])
      }
      let compared = 0
      results.forEach(({ color, slope }, i) => {
        const [u, v] = points[i]
        assertClose(color, at([u, v]), 3e-5, `at ${points[i]}`)
        const along = [-2, -1, 1, 2].map((k) => at([u, v + k * 1e-5])[1])
        const expected = (8 * (along[2] - along[1]) - (along[3] - along[0])) / 12e-5
        const coarse = (along[2] - along[1]) / 2e-5
        // The difference does not approximate the derivative if it crosses a line through centers of texels.
        if (Math.abs(coarse - expected) > 1e-4) return
        assertClose([slope], [expected], 1e-3, `slope at ${points[i]}`)
        compared++
      })
      assert.ok(compared > 0.9 * points.length, `${compared} slopes compared`)
    })
  })
