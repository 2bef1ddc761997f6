// Normals at pixels: a picture of normals as colours against exact normals at the rest place of each pixel. Pictures on WebGL have
// floats. p5's own framebuffers of floats cannot be read on WebGPU, so each number is drawn as three bytes on the canvas there.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import {
  allPairs,
  checkNormals,
  describeShape,
  drawShape,
  geometries,
  size,
  somePairs,
} from '../support/browser/p5-pixel-normals.js'
import { pixelWarps } from '../support/browser/pixel-normals.js'
import { readWebGPUPixels } from '../support/browser/pixels.js'

const hosts = await openP5Hosts()

const pairsOf = ({ isV1, isWebGPU }) => (isV1 || isWebGPU ? somePairs : allPairs)

/** Returns code that makes createWarp's functions for each warp: `make(offset)` is the code of a list of them. */
const warpsBy = (make) =>
  `window.warps = { ${Object.entries(pixelWarps).map(([name, { offset }]) => `${name}: ${make(offset)}`)} }`

/** Inputs of the warp that shaders of the sketch pass to pixels, in front of the warp: the GPU's own rest places. */
const restInputs = ['position', 'normal', 'texCoord']

const glslOfRest = (variables) => ({
  vertexDeclarations: 'OUT highp vec3 rest;',
  fragmentDeclarations: 'IN highp vec3 rest;',
  ...variables,
})

/** Maps a version of p5 → the hooks of the sketch's shaders, which draw these inputs. */
const restHooks = {
  '2.x': restInputs.map((input) =>
    glslOfRest({
      'Vertex getObjectInputs': `(Vertex v) { rest.xy = v.${input}.xy; ${input === 'texCoord' ? '' : `rest.z = v.${input}.z;`} return v; }`,
      'vec4 getFinalColor': '(vec4 color, vec2 texCoord) { return vec4(rest, 1.0); }',
    }),
  ),
  1.11: [
    ['vec3 getLocalPosition', 'vec3 v', 'v'],
    ['vec3 getLocalNormal', 'vec3 v', 'v'],
    ['vec2 getUV', 'vec2 v', 'vec3(v, 0.0)'],
  ].map(([hook, parameter, value]) =>
    glslOfRest({
      [hook]: `(${parameter}) { rest = ${value}; return v; }`,
      'vec4 getFinalColor': '(vec4 color) { return vec4(rest, 1.0); }',
    }),
  ),
}

/** Draws into a framebuffer of floats. */
const floatPictures = {
  sketch: ({ version }) => `function setup() {
      pixelDensity(1)
      createCanvas(${size}, ${size}, WEBGL)
      noLoop(); noStroke()
      window.buffer = createFramebuffer({ format: FLOAT, antialias: false,
        density: 1, width: ${size}, height: ${size}, depth: true })
      window.eye = buffer.createCamera()
      window.geometries = ${geometries}
      const restHooks = ${JSON.stringify(restHooks[version])}
      ${warpsBy(
        (offset) => `[createWarp(${offset}, { type: 'normal', normals: 'pixel', fadeNoise: false }),
          ...restHooks.map((hooks) =>
            createWarp(${offset}, { shader: baseNormalShader().modify(hooks), normals: 'vertex' }))]`,
      )}
      window.done = true
    }
    const drawShape = ${drawShape}
    window.describeShape = ${describeShape}
    window.shoot = ([shape, warp]) =>
      warps[warp].map((distort) => {
        buffer.begin()
        push(); distort(); drawShape(shape); pop()
        buffer.end()
        buffer.loadPixels()
        return new Uint8Array(Float32Array.from(buffer.pixels).buffer).toBase64()
      })`,
  async shoot(page, shape, warp) {
    const texts = await page.evaluate((names) => shoot(names), [shape, warp])
    const [normals, ...rest] = texts.map(
      (text) => new Float32Array(new Uint8Array(Buffer.from(text, 'base64')).buffer),
    )
    const colorOf = (picture, pixel) => [...picture.subarray(4 * pixel, 4 * pixel + 3)]
    return {
      restAt: (pixel) => rest.flatMap((picture) => colorOf(picture, pixel)),
      shownAt: (pixel) => colorOf(normals, pixel),
    }
  },
}

/** Numbers are between -range and range. */
const range = 1.5

/** Expressions for the three bytes of the vector `shown`, from the highest. */
const bytes = [0, 1, 2].map((digit) => {
  const rest = `fract((shown / ${2 * range}.0 + 0.5) * ${255 ** digit}.0)`
  return `floor(${rest} * 255.0) / 255.0`
})

/** The vectors that shaders of the sketch draw: the light's normal, after the warp, and inputs in front of the warp. */
const shownVectors = ['', 'position', 'normal', 'texCoord']

const bytesHooks = shownVectors.flatMap((input) =>
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

/** Draws the bytes of each number on the canvas. */
const bytePictures = {
  sketch: () => `let scene = () => {}
    async function setup() {
      pixelDensity(1)
      // p5 2.3 cannot set this attribute on WebGPU.
      p5.instance._webgpuAttributes = { antialias: false }
      await createCanvas(${size}, ${size}, WEBGPU)
      noLoop(); noStroke()
      window.eye = createCamera()
      window.geometries = ${geometries}
      const hooks = ${JSON.stringify(bytesHooks)}
      ${warpsBy(
        (offset) => `hooks.map((each) =>
          createWarp(${offset}, { shader: baseMaterialShader().modify(each), normals: 'pixel', fadeNoise: false }))`,
      )}
      window.done = true
    }
    const drawShape = ${drawShape}
    window.describeShape = ${describeShape}
    function draw() { scene() }`,
  async shoot(page, shape, warp) {
    const images = []
    for (let i = 0; i < bytesHooks.length; i++) {
      await page.evaluate(
        `scene = () => { push(); warps.${warp}[${i}](); drawShape('${shape}'); pop() }`,
      )
      images.push(await readWebGPUPixels(page, 'redraw()'))
    }
    const vectorAt = (i, pixel) =>
      [0, 1, 2].map((k) => {
        const digits = bytes.map((_, part) => images[bytes.length * i + part].data[4 * pixel + k])
        const share = digits.reduceRight((rest, digit) => (digit + rest) / 255, 0.5)
        return (share - 0.5) * 2 * range
      })
    return {
      restAt: (pixel) => [1, 2, 3].flatMap((i) => vectorAt(i, pixel)),
      shownAt: (pixel) => vectorAt(0, pixel),
    }
  },
}

for (const host of hosts)
  test(`${host.name}: normals at pixels are exact`, async (t) => {
    const { sketch, shoot } = host.isWebGPU ? bytePictures : floatPictures
    const { page, messages } = await host.open(sketch(host))
    assert.deepEqual(messages, [])
    for (const [shape, warpsOfShape] of Object.entries(pairsOf(host)))
      for (const warp of warpsOfShape)
        await t.test(`${warp} on a ${shape}`, async (t) => {
          const picture = await shoot(page, shape, warp)
          const mesh = await page.evaluate((name) => describeShape(name), shape)
          t.diagnostic(`${checkNormals(warp, shape, mesh, picture)}°`)
        })
    await leavePage(page)
    assert.deepEqual(messages, [])
  })

for (const { name, open } of hosts.filter(({ isWebGPU }) => isWebGPU))
  test(`${name}: an unlit shader of the sketch gets no varyings that it does not read`, async () => {
    const { page, messages } = await open(
      `async function setup() {
      await createCanvas(50, 50, WEBGPU)
      noLoop(); noStroke()
      const { shader } = p5.instance
      let used
      p5.instance.shader = (each) => shader.call(p5.instance, (used = each))
      const show = (base) => {
        createWarp(${pixelWarps.fbm.offset}, { shader: base.modify({}), normals: 'pixel' })()
        sphere(20)
        return /warpjet(Pixel|View)[A-Za-z]*/.exec(used.vertSrc() + used.fragSrc())?.[0] ?? ''
      }
      window.found = [baseColorShader(), baseMaterialShader()].map(show)
      window.done = true
    }`,
    )
    assert.deepEqual(messages, [])
    const [unlit, lit] = await page.evaluate('found')
    await leavePage(page)
    assert.deepEqual([unlit, !!lit], ['', true])
  })
