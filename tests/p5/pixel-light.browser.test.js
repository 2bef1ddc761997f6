// Normals at pixels with p5's materials, spaces and shaders. Compares the light of a coarse shape with that of a dense one; and noise that
// is finer than a pixel, which must fade, with the mean of 64 exact normals per pixel.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { leavePage } from '../support/browser/browser.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { litPixels, readPixels } from '../support/browser/pixels.js'

const hosts = await openP5Hosts()
/** The hosts whose shaders are GLSL. */
const glslHosts = hosts.filter(({ isWebGPU }) => !isWebGPU)

/**
 * Returns the source of an offset with bumps that are smaller than the triangles of p5's sphere. `length` is their size in the warp's
 * space.
 */
const bumps = (length, height) => `({ glsl, position, normal }) => {
  const bump = glsl.simplex(position.div(${length}))
  return ${length === 1 / 3 ? 'position' : 'glsl.vec3(0, 0, 1)'}.mult(bump.mult(${height})) }`

const spaces = {
  local: bumps(1 / 3, 0.05),
  world: bumps(25, 4),
  camera: bumps(25, 4),
}

const light = `directionalLight(255, 255, 255, 0.5, 0.6, -1); ambientLight(40); fill(220, 160, 90)`

/** Returns scenes with a coarse sphere with normals at vertices and at pixels, and with a dense sphere. */
const makeScenes = (name, more = '') =>
  Object.fromEntries(
    [
      ['vertex', 24, 16],
      ['pixel', 24, 16],
      ['dense', 240, 160],
    ].map(([kind, columns, rows]) => [
      `${name} ${kind}`,
      `noStroke(); ${light}; ${more}; warps['${name} ${kind}'](); rotateX(0.5); sphere(75, ${columns}, ${rows})`,
    ]),
  )

/** Returns code that makes the warps of these scenes. */
const makeWarps = (name, offset, options) =>
  Object.entries({ vertex: 'vertex', pixel: 'pixel', dense: 'vertex' })
    .map(
      ([kind, normals]) =>
        `warps['${name} ${kind}'] = createWarp(${offset}, { ...${options}, normals: '${normals}' })`,
    )
    .join('\n')

/** Returns the mean difference from the dense picture over pixels within 55 of the center. Leaves out the outline, which is coarse. */
function meanDifference(image, dense) {
  const inside = litPixels(dense).filter(({ x, y }) => Math.hypot(x, y) < 55)
  assert.ok(inside.length > 5000, `${inside.length} pixels`)
  const sum = inside.reduce((total, { x, y, color }) => {
    const at = 4 * ((y - 0.5 + dense.height / 2) * dense.width + (x - 0.5 + dense.width / 2))
    return total + [0, 1, 2].reduce((all, k) => all + Math.abs(image.data[at + k] - color[k]), 0)
  }, 0)
  return sum / (3 * inside.length)
}

for (const { name: host, draw } of hosts)
  describe(`${host}: a sphere of 24 by 16 pieces has the light of one of 240 by 160`, () => {
    for (const [space, offset] of Object.entries(spaces))
      for (const [material, more] of Object.entries({ specular: '', normal: '' }))
        test(`in ${space} space, as ${material}`, async () => {
          const name = `${space} ${material}`
          const images = await draw({
            setup: makeWarps(name, offset, `{ space: '${space}', type: '${material}' }`),
            scenes: makeScenes(name, more),
          })
          const [vertex, pixel] = ['vertex', 'pixel'].map((kind) =>
            meanDifference(images[`${name} ${kind}`], images[`${name} dense`]),
          )
          assert.ok(
            pixel < 0.35 * vertex,
            `mean difference ${pixel} with normals at pixels, ${vertex} at vertices`,
          )
        })

    test('a surface that a warp collapses is lit by the normals of its triangles, with normals at vertices and at pixels', async () => {
      const floor = '({ glsl, position }) => position.mult(3).floor().div(3).sub(position)'
      const images = await draw({
        setup: makeWarps('floor', floor, '{}'),
        scenes: makeScenes('floor'),
      })
      for (const [name, { data }] of Object.entries(images)) {
        const shades = new Set(Array.from({ length: data.length / 4 }, (_, i) => data[4 * i]))
        assert.ok(shades.size > 3, `${name}: ${shades.size} shades`)
      }
    })
  })

for (const { name: host, isV1, open } of glslHosts)
  describe(`${host}: shaders of the sketch`, () => {
    const hooksAfterWarp = isV1
      ? `{ 'vec3 getWorldNormal': '(vec3 n) { return -n; }' }`
      : `{ 'Vertex getCameraInputs': '(Vertex v) { v.normal = -v.normal; return v; }' }`
    const noise = `({ glsl, position }) => position.mult(glsl.simplex(position).mult(0.2))`

    test('with a hook that changes normals after the warp, they are computed at vertices, with a message if the option is pixel', async () => {
      const { page, messages } = await open(
        `function setup() {
          createCanvas(100, 100, WEBGL)
          const mine = baseMaterialShader().modify(${hooksAfterWarp})
          const warps = [{}, { normals: 'pixel' }].map((options) =>
            createWarp(${noise}, { shader: mine, ...options }))
          for (const warp of warps) {
            warp()
            sphere(20)
          }
          window.stages = warps.map(({ normals }) => normals)
          noLoop()
          window.done = true
        }`,
      )
      assert.deepEqual(await page.evaluate('stages'), ['vertex', 'vertex'])
      await leavePage(page)
      assert.equal(messages.length, 1)
      assert.match(
        messages[0],
        /createWarp: the normals of this warp are computed at vertices, although its option "normals" is 'pixel': the hook get(World|Camera)(Normal|Inputs) of its shader changes normals after the warp\./,
      )
    })

    test('the property normals is the stage that was selected', async () => {
      const { page, messages } = await open(
        `function setup() {
          createCanvas(100, 100, WEBGL)
          noLoop()
          window.stages = [createWarp(${noise}), createWarp(({ glsl, position }) => glsl.vec3(0, 0, position.x())),
            createWarp(${noise}, { normals: 'vertex' })].map(({ normals }) => normals)
          window.done = true
        }`,
      )
      assert.deepEqual(await page.evaluate('stages'), ['pixel', 'vertex', 'vertex'])
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })

for (const { open } of hosts.filter(({ isV1 }) => isV1))
  test('p5 1.11 on WebGL 1 draws as on WebGL 2', async () => {
    const draw = async (version) => {
      const { page, messages } = await open(
        `function setup() {
          pixelDensity(1)
          createCanvas(200, 200, WEBGL)
          setAttributes({ version: ${version}, antialias: false })
          noLoop(); noStroke()
          ${light}
          createWarp(${spaces.local}, { normals: 'pixel' })()
          sphere(75)
          window.done = true
        }`,
      )
      const image = await readPixels(page)
      await leavePage(page)
      assert.deepEqual(messages, [])
      return image
    }
    const [one, two] = [await draw(1), await draw(2)]
    assert.ok(meanDifference(one, two) < 0.5)
  })

// Tests of noise that is finer than a pixel.

const size = 120
/**
 * The length of the plane's edges, in pixels. Waves of the coarsest octave are 3.7 pixels long, those of the finest a quarter of a pixel.
 */
const edge = 80

const offset = ({ glsl, position }) => glsl.vec3(0, 0, glsl.fbm(position.mult(30)).mult(0.02))

/** Hooks that draw the normal as a color. */
const hooks = {
  WEBGL: {
    fragmentDeclarations: 'vec3 shown;',
    'Inputs getPixelInputs': '(Inputs inputs) { shown = inputs.normal; return inputs; }',
    'vec4 getFinalColor': '(vec4 color) { return vec4(shown * 0.5 + 0.5, 1.0); }',
  },
  WEBGPU: {
    fragmentDeclarations: 'var<private> shown: vec3<f32>;',
    'Inputs getPixelInputs': '(inputs: Inputs) { shown = inputs.normal; return inputs; }',
    'vec4f getFinalColor':
      '(color: vec4<f32>, texCoord: vec2<f32>) { return vec4<f32>(shown * 0.5 + 0.5, 1.0); }',
  },
}

/** Returns the hooks for a host. In p5 2.x, texture coordinates are a second parameter. */
function hooksFor({ isV1, isWebGPU, renderer }) {
  if (isV1 || isWebGPU) return hooks[renderer]
  const color = hooks.WEBGL['vec4 getFinalColor'].replace(')', ', vec2 texCoord)')
  return { ...hooks.WEBGL, 'vec4 getFinalColor': color }
}

/** The pixels that the plane covers, except those near its edges. */
const pixels = Array.from({ length: size * size }, (_, i) => [
  i % size,
  Math.floor(i / size),
]).filter((pixel) => pixel.every((x) => Math.abs(x + 0.5 - size / 2) < edge / 2 - 2))

/** Converts a coordinate in the picture to one on the plane. */
const toPlane = (x) => (x - size / 2) / edge

/** Returns the sum of 64 normals for each pixel. It has the direction of their mean, which is all that we compare. */
function meanNormals() {
  const positions = pixels.flatMap(([x, y]) =>
    Array.from({ length: 64 }, (_, i) => [
      toPlane(x + ((i % 8) + 0.5) / 8),
      toPlane(y + (Math.floor(i / 8) + 0.5) / 8),
      0,
    ]).flat(),
  )
  const normals = Float32Array.from(positions, (_, i) => (i % 3 === 2 ? 1 : 0))
  const warped = compileWarp(offset).evaluate({ positions: Float32Array.from(positions), normals })
  return pixels.map((_, pixel) => {
    const sum = [0, 0, 0]
    for (let i = 0; i < 3 * 64; i++) sum[i % 3] += warped.normals[3 * 64 * pixel + i]
    return sum
  })
}

function degreesBetween(a, b) {
  const dot = a.reduce((sum, x, i) => sum + x * b[i], 0)
  return (Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b)))) * 180) / Math.PI
}

for (const host of hosts)
  test(`${host.name}: noise finer than a pixel fades to its mean`, async (t) => {
    const shader = `baseMaterialShader().modify(${JSON.stringify(hooksFor(host))})`
    const scene = (name) => `background(0); warps.${name}(); noStroke()
      perspective(2 * atan(${size / 2 / 1000}), 1, 100, 5000)
      camera(0, 0, 1000, 0, 0, 0, 0, 1, 0)
      scale(${edge}); plane(1, 1)`
    const images = await host.draw({
      size,
      setup: `warps.fading = createWarp(${offset}, { shader: ${shader}, normals: 'pixel' })
        warps.notFading = createWarp(${offset}, { shader: ${shader}, normals: 'pixel', fadeNoise: false })`,
      scenes: { fading: scene('fading'), notFading: scene('notFading') },
    })
    const means = meanNormals()
    const rmsError = ({ data }) => {
      const angles = pixels.map(([x, y], i) => {
        const at = 4 * (y * size + x)
        const shown = [...data.subarray(at, at + 3)].map((byte) => byte / 127.5 - 1)
        return degreesBetween(shown, means[i])
      })
      return Math.hypot(...angles) / Math.sqrt(angles.length)
    }
    const [fading, notFading] = [rmsError(images.fading), rmsError(images.notFading)]
    t.diagnostic(
      `${fading} degrees from the mean where noise fades, ${notFading} where it does not`,
    )
    assert.ok(notFading > 5, `${notFading} degrees: the noise is too weak for a comparison`)
    assert.ok(
      fading < notFading / 2,
      `${fading} degrees if noise fades, ${notFading} if it does not`,
    )
  })
