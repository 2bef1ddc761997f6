// Normals at pixels: a picture of normals as colours, in floats, against exact normals at the rest place of each pixel.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import * as m from '../support/browser/matrix.js'
import { anglesOf, exactNormals, pixelWarps } from '../support/browser/pixel-normals.js'
import { openHosts, p5HostsInThisRun, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 160
const radius = 60

const { browsers, server } = await openHosts(p5HostsInThisRun)

/** Maps a name → p5 code that draws the shape, of about radius 1, and the warps that it is drawn with. */
const shapes = {
  sphere: { code: 'sphere(1)', with: Object.keys(pixelWarps) },
  box: { code: 'box(1)', with: ['fbm', 'waves', 'blob'] },
  plane: { code: 'plane(1, 1)', with: ['waves', 'flag'] },
  torus: { code: 'torus(1, 0.3)', with: ['simplex', 'twist'] },
}

const turn = m.product(m.rotation(0.5, 1, 2), m.rotation(0.4, 2, 0))

/** Inputs of the warp that shaders of the sketch pass to pixels, in front of the warp: the GPU's own rest places. */
const restInputs = ['position', 'normal', 'texCoord']

const glslOfRest = (variables) => ({
  vertexDeclarations: 'OUT highp vec3 rest;',
  fragmentDeclarations: 'IN highp vec3 rest;',
  ...variables,
})

/** Maps a host → the hooks of the sketch's shaders. Half floats need two pictures: rounded to 1/1024, and the remainder. */
const restHooks = {
  '2.x WEBGL': restInputs.map((input) =>
    glslOfRest({
      'Vertex getObjectInputs': `(Vertex v) { rest.xy = v.${input}.xy; ${input === 'texCoord' ? '' : `rest.z = v.${input}.z;`} return v; }`,
      'vec4 getFinalColor': '(vec4 color, vec2 texCoord) { return vec4(rest, 1.0); }',
    }),
  ),
  '1.11 WEBGL': [
    ['vec3 getLocalPosition', 'vec3 v', 'v'],
    ['vec3 getLocalNormal', 'vec3 v', 'v'],
    ['vec2 getUV', 'vec2 v', 'vec3(v, 0.0)'],
  ].map(([hook, parameter, value]) =>
    glslOfRest({
      [hook]: `(${parameter}) { rest = ${value}; return v; }`,
      'vec4 getFinalColor': '(vec4 color) { return vec4(rest, 1.0); }',
    }),
  ),
  '2.x WEBGPU': restInputs.flatMap((input) =>
    ['round(rest * 1024.0) / 1024.0', 'rest * 1024.0 - round(rest * 1024.0)'].map((value) => ({
      varyingVariables: ['rest: vec3<f32>'],
      'Vertex getObjectInputs': `(v: Vertex) { rest = vec3<f32>(v.${input}${input === 'texCoord' ? ', 0.0' : ''}); return v; }`,
      'vec4<f32> getFinalColor': `(color: vec4<f32>, texCoord: vec2<f32>) { return vec4<f32>(${value}, 1.0); }`,
    })),
  ),
}

/** Draws each shape with each warp → { geometries, pictures }, where a picture has the normals in view space, from the top row. */
async function drawNormals([version, renderer, scripts], normals) {
  const isGPU = renderer === 'WEBGPU'
  const hooks = restHooks[`${version} ${renderer}`]
  const { page, messages } = await runSketch(
    browsers[renderer],
    server,
    [...scripts, addon],
    `${version === '1.11' ? '' : 'async '}function setup() {
      pixelDensity(1)
      ${isGPU ? 'await ' : ''}createCanvas(${size}, ${size}, ${renderer})
      noLoop(); noStroke()
      window.buffer = createFramebuffer({ format: ${isGPU ? 'HALF_FLOAT' : 'FLOAT'}, antialias: false,
        density: 1, width: ${size}, height: ${size}, depth: true })
      window.eye = buffer.createCamera()
      window.geometries = { ${Object.entries(shapes).map(([name, { code }]) => `${name}: buildGeometry(() => ${code})`)} }
      window.warps = { ${Object.entries(pixelWarps).map(([name, { offset }]) => `${name}: createWarp(${offset}, { type: 'normal', normals: '${normals}' })`)} }
      const base = ${isGPU ? 'baseColorShader()' : 'baseNormalShader()'};
      ${JSON.stringify(hooks)}.forEach((hooks, i) => {
        ${Object.entries(pixelWarps).map(([name, { offset }]) => `warps.${name + 'Rest'} = [...warps.${name + 'Rest'} ?? [], createWarp(${offset}, { shader: base.modify(hooks), normals: 'vertex' })]`).join('\n')}
      })
      window.done = true
    }
    window.shoot = async (shape, warp) => {
      const pictures = []
      for (const distort of [warps[warp], ...warps[warp + 'Rest']]) {
        buffer.begin()
        clear()
        setCamera(eye)
        eye.ortho(${-size / 2}, ${size / 2}, ${-size / 2}, ${size / 2}, 1, 2000)
        noStroke()
        push()
        rotateX(0.5); rotateY(0.4); scale(${radius})
        distort(); model(geometries[shape])
        pop()
        buffer.end()
        await buffer.loadPixels()
        // One string is transferred without conversion.
        const bytes = new Uint8Array(Float32Array.from(buffer.pixels).buffer)
        let encoded = ''
        for (let i = 0; i < bytes.length; i += 8192) encoded += String.fromCharCode(...bytes.subarray(i, i + 8192))
        pictures.push(btoa(encoded))
      }
      return pictures
    }
    window.describeShape = (shape) => {
      const { vertices, vertexNormals, uvs, faces } = geometries[shape]
      const list = (vectors) => vectors.map(({ x, y, z }) => [x, y, z])
      const names = ['normalXGradient', 'normalYGradient', 'normalZGradient', 'uGradient', 'vGradient']
      return { vertices: list(vertices), normals: list(vertexNormals), uvs: [...uvs].flat(), faces,
        gradients: names.map((name) => [...geometries[shape]['warpjet_' + name] ?? []]) }
    }`,
  )
  assert.deepEqual(messages, [])
  const pictures = {}
  const geometries = {}
  for (const shape of Object.keys(shapes)) {
    for (const warp of shapes[shape].with) {
      const [normals, ...rest] = (
        await page.evaluate(([s, w]) => shoot(s, w), [shape, warp])
      ).map((text) => new Float32Array(new Uint8Array(Buffer.from(text, 'base64')).buffer))
      pictures[`${shape} ${warp}`] = { normals, rest }
    }
    geometries[shape] = await page.evaluate((s) => describeShape(s), shape)
  }
  await leavePage(page)
  assert.deepEqual(messages, [])
  return { geometries, pictures }
}

const toScreen = (p) => {
  const [x, y, z] = m.movePoint(turn, p)
  return [size / 2 + radius * x, size / 2 + radius * y, -z]
}

for (const host of p5HostsInThisRun)
  describe(`p5 ${host[0]} by ${host[1]}, normals at pixels`, async () => {
    const drawn = { pixel: undefined, vertex: undefined }
    const draw = async (normals) => (drawn[normals] ??= await drawNormals(host, normals))
    const bound = 0.1
    for (const warp of Object.keys(pixelWarps))
      test(`${warp}: within ${bound} degrees at 99.9% of pixels, on each shape`, async () => {
        const { geometries, pictures } = await draw('pixel')
        for (const shape of Object.keys(shapes).filter((each) => shapes[each].with.includes(warp))) {
          const { normals, rest } = pictures[`${shape} ${warp}`]
          const perInput = rest.length / restInputs.length
          const restAt = (pixel) =>
            Array.from({ length: 9 }, (_, i) =>
              Array.from(
                { length: perInput },
                (_, k) => rest[perInput * Math.floor(i / 3) + k][4 * pixel + (i % 3)] / 1024 ** k,
              ).reduce((a, b) => a + b),
            )
          const shownAt = (pixel) => normals.slice(4 * pixel, 4 * pixel + 3)
          const { exact, share } = exactNormals(warp, geometries[shape], {
            toScreen,
            restAt,
            width: size,
            height: size,
          })
          const inView = exact.map(({ pixel, normal }) => ({
            pixel,
            normal: m.turnNormal(turn, normal),
          }))
          const best = { ...anglesOf(inView, shownAt), share }
          console.log(host.slice(0, 2).join(' '), shape, warp, best)
          assert.ok(best.count > 500 && best.share > 0.97, `${shape}: ${best.count} pixels`)
          assert.ok(best.most < bound, `${shape}: ${best.most} degrees off`)
        }
      })
  })
