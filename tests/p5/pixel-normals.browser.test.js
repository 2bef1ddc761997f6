// Normals at pixels on WebGL: a picture of normals as colours, in floats, against exact normals at the rest place of each pixel.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import {
  checkNormals,
  describeShape,
  drawShape,
  geometries,
  shapes,
  size,
} from '../support/browser/p5-pixel-normals.js'
import { pixelWarps } from '../support/browser/pixel-normals.js'
import { openHosts, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const { browsers, server } = await openHosts([['2.x', 'WEBGL']])

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

/** Draws each shape with each warp → { meshes, pictures }. A picture has floats: `normals` in view space, and `rest` by input. */
async function drawNormals([version, p5], normals) {
  const warps = Object.entries(pixelWarps).map(
    ([
      name,
      { offset },
    ]) => `${name}: [createWarp(${offset}, { type: 'normal', normals: '${normals}', fadeNoise: false }),
      ...restHooks.map((hooks) =>
        createWarp(${offset}, { shader: baseNormalShader().modify(hooks), normals: 'vertex' }))]`,
  )
  const { page, messages } = await runSketch(
    browsers.WEBGL,
    server,
    [p5, '/dist/p5.warpjet.min.js'],
    `function setup() {
      pixelDensity(1)
      createCanvas(${size}, ${size}, WEBGL)
      noLoop(); noStroke()
      window.buffer = createFramebuffer({ format: FLOAT, antialias: false,
        density: 1, width: ${size}, height: ${size}, depth: true })
      window.eye = buffer.createCamera()
      window.geometries = ${geometries}
      const restHooks = ${JSON.stringify(restHooks[version])}
      window.warps = { ${warps} }
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
  )
  assert.deepEqual(messages, [])
  const [pictures, meshes] = [{}, {}]
  for (const shape of Object.keys(shapes)) {
    for (const warp of shapes[shape].with) {
      const texts = await page.evaluate((names) => shoot(names), [shape, warp])
      const [normals, ...rest] = texts.map(
        (text) => new Float32Array(new Uint8Array(Buffer.from(text, 'base64')).buffer),
      )
      pictures[`${shape} ${warp}`] = { normals, rest }
    }
    meshes[shape] = await page.evaluate((name) => describeShape(name), shape)
  }
  await leavePage(page)
  assert.deepEqual(messages, [])
  return { meshes, pictures }
}

for (const [version, p5] of p5InThisRun)
  describe(`p5 ${version}: normals at pixels are exact`, () => {
    let drawn
    for (const warp of Object.keys(pixelWarps))
      test(`${warp}, on each shape`, async () => {
        const { meshes, pictures } = await (drawn ??= drawNormals([version, p5], 'pixel'))
        for (const shape of Object.keys(shapes)) {
          if (!shapes[shape].with.includes(warp)) continue
          const { normals, rest } = pictures[`${shape} ${warp}`]
          const colorOf = (picture, pixel) => [...picture.subarray(4 * pixel, 4 * pixel + 3)]
          checkNormals(warp, shape, meshes[shape], {
            restAt: (pixel) => rest.flatMap((picture) => colorOf(picture, pixel)),
            shownAt: (pixel) => colorOf(normals, pixel),
          })
        }
      })
  })
