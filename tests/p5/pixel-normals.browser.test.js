// Normals at pixels: compares pictures of normals with the exact normals that follow from the unwarped position, normal and uv of each
// pixel. On WebGL, pictures consist of floats. On WebGPU, p5's framebuffers of floats cannot be read, so each number is drawn as three
// bytes on the canvas.
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

/** Returns the shapes and warps that a host draws. */
const getPairs = ({ isV1, isWebGPU }) => (isV1 || isWebGPU ? somePairs : allPairs)

/** Returns code that makes a list of warps for each offset; `make(offset)` is the code of the list. */
const makeWarps = (make) =>
  `window.warps = { ${Object.entries(pixelWarps).map(([name, { offset }]) => `${name}: ${make(offset)}`)} }`

/** The inputs of warps. Shaders of the sketch pass their unwarped values to pixels, interpolated by the GPU. */
const restInputs = ['position', 'normal', 'texCoord']

/** Returns hooks in GLSL that pass the variable `rest` to pixels. */
const passRest = (hooks) => ({
  vertexDeclarations: 'OUT highp vec3 rest;',
  fragmentDeclarations: 'IN highp vec3 rest;',
  ...hooks,
})

/** Maps a version of p5 → hooks of shaders that draw these inputs as colors. */
const restHooks = {
  '2.x': restInputs.map((input) =>
    passRest({
      'Vertex getObjectInputs': `(Vertex v) { rest.xy = v.${input}.xy; ${input === 'texCoord' ? '' : `rest.z = v.${input}.z;`} return v; }`,
      'vec4 getFinalColor': '(vec4 color, vec2 texCoord) { return vec4(rest, 1.0); }',
    }),
  ),
  1.11: [
    ['vec3 getLocalPosition', 'vec3 v', 'v'],
    ['vec3 getLocalNormal', 'vec3 v', 'v'],
    ['vec2 getUV', 'vec2 v', 'vec3(v, 0.0)'],
  ].map(([hook, parameter, value]) =>
    passRest({
      [hook]: `(${parameter}) { rest = ${value}; return v; }`,
      'vec4 getFinalColor': '(vec4 color) { return vec4(rest, 1.0); }',
    }),
  ),
}

/** Draws pictures in a framebuffer of floats. */
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
      ${makeWarps(
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
    const pictures = await page.evaluate((names) => shoot(names), [shape, warp])
    const [normals, ...rest] = pictures.map(
      (base64) => new Float32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer),
    )
    const colorOf = (picture, pixel) => [...picture.subarray(4 * pixel, 4 * pixel + 3)]
    return {
      restAt: (pixel) => rest.flatMap((picture) => colorOf(picture, pixel)),
      shownAt: (pixel) => colorOf(normals, pixel),
    }
  },
}

/** The numbers to draw are between -range and range. */
const range = 1.5

/** Expressions for the three bytes of the components of the vector `shown`, the highest byte first. */
const bytes = [0, 1, 2].map((digit) => {
  const remainder = `fract((shown / ${2 * range}.0 + 0.5) * ${255 ** digit}.0)`
  return `floor(${remainder} * 255.0) / 255.0`
})

/** The vectors that shaders of the sketch draw: the normal of the light, which is warped, and inputs before the warp. */
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

/** Draws pictures of the bytes of each number on the canvas. */
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
      ${makeWarps(
        (offset) => `hooks.map((one) =>
          createWarp(${offset}, { shader: baseMaterialShader().modify(one), normals: 'pixel', fadeNoise: false }))`,
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
        const digits = bytes.map((_, digit) => images[bytes.length * i + digit].data[4 * pixel + k])
        const fraction = digits.reduceRight((lower, digit) => (digit + lower) / 255, 0.5)
        return (fraction - 0.5) * 2 * range
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
    for (const [shape, warpsOfShape] of Object.entries(getPairs(host)))
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
      p5.instance.shader = (current) => shader.call(p5.instance, (used = current))
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
