// Normals at pixels on WebGPU, as those of WebGL. p5's own framebuffers of floats cannot be read there, so each number is drawn as
// three bytes on the canvas.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowserWithWebGPU, leavePage } from '../support/browser/browser.js'
import {
  checkNormals,
  describeShape,
  drawShape,
  geometries,
  shapes,
  size,
} from '../support/browser/p5-pixel-normals.js'
import { pixelWarps } from '../support/browser/pixel-normals.js'
import { readWebGPUPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { p5Versions, p5WebGPU, runSketch } from '../support/browser/sketch.js'

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowserWithWebGPU()
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Numbers are between -range and range. */
const range = 1.5

/** Expressions for the three bytes of the vector `shown`, from the highest. */
const bytes = [0, 1, 2].map((digit) => {
  const rest = `fract((shown / ${2 * range}.0 + 0.5) * ${255 ** digit}.0)`
  return `floor(${rest} * 255.0) / 255.0`
})

/** The vectors that shaders of the sketch draw: the light's normal, after the warp, and inputs in front of the warp. */
const shownVectors = ['', 'position', 'normal', 'texCoord']

const hooks = shownVectors.flatMap((input) =>
  bytes.map((value) => ({
    ...(input
      ? {
          varyingVariables: ['shown: vec3<f32>'],
          'Vertex getObjectInputs': `(v: Vertex) { shown = vec3<f32>(v.${input}${input === 'texCoord' ? ', 0.0' : ''}); return v; }`,
        }
      : {
          fragmentDeclarations: 'var<private> shown: vec3<f32>;',
          'Inputs getPixelInputs': '(inputs: Inputs) { shown = inputs.normal; return inputs; }',
        }),
    'vec4f getFinalColor': `(color: vec4<f32>, texCoord: vec2<f32>) { return vec4<f32>(${value}, 1.0); }`,
  })),
)

test('p5 on WebGPU: normals at pixels are exact', async (t) => {
  const warps = Object.entries(pixelWarps).map(
    ([name, { offset }]) => `${name}: hooks.map((each) =>
      createWarp(${offset}, { shader: baseMaterialShader().modify(each), normals: 'pixel', fadeNoise: false }))`,
  )
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x'], p5WebGPU, '/dist/p5.warpjet.min.js'],
    `let scene = () => {}
    async function setup() {
      pixelDensity(1)
      // p5 2.3 cannot set this attribute on WebGPU.
      p5.instance._webgpuAttributes = { antialias: false }
      await createCanvas(${size}, ${size}, WEBGPU)
      noLoop(); noStroke()
      window.eye = createCamera()
      window.geometries = ${geometries}
      const hooks = ${JSON.stringify(hooks)}
      window.warps = { ${warps} }
      window.done = true
    }
    const drawShape = ${drawShape}
    window.describeShape = ${describeShape}
    function draw() { scene() }`,
  )
  assert.deepEqual(messages, [])
  const shoot = async (shape, warp, i) => {
    await page.evaluate(
      `scene = () => { push(); warps.${warp}[${i}](); drawShape('${shape}'); pop() }`,
    )
    return readWebGPUPixels(page, 'redraw()')
  }
  for (const [shape, { with: names }] of Object.entries(shapes))
    for (const warp of names)
      await t.test(`${warp} on a ${shape}`, async () => {
        const images = []
        for (let i = 0; i < hooks.length; i++) images.push(await shoot(shape, warp, i))
        const vectorAt = (i, pixel) =>
          [0, 1, 2].map((k) => {
            const digits = bytes.map(
              (_, part) => images[bytes.length * i + part].data[4 * pixel + k],
            )
            const share = digits.reduceRight((rest, digit) => (digit + rest) / 255, 0.5)
            return (share - 0.5) * 2 * range
          })
        const mesh = await page.evaluate((name) => describeShape(name), shape)
        checkNormals(warp, shape, mesh, {
          restAt: (pixel) => [1, 2, 3].flatMap((i) => vectorAt(i, pixel)),
          shownAt: (pixel) => vectorAt(0, pixel),
        })
      })
  await leavePage(page)
  assert.deepEqual(messages, [])
})
