// npm run bench -- glsl: compares webgl-noise's 3D simplex noise, translated to an offset with exact normals, with our own: translation
// time, length of the shader code, time to the first frame. Also measures a frame of a ray-marched field whose normals come from four
// evaluations of the field or from one evaluation of its gradient.
import { readFileSync } from 'node:fs'
import { glslOffset } from '../../dist/glsl.js'
import { compileWarp } from '../../dist/warpjet.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { servePages } from '../../tests/support/browser/server.js'
import { path } from '../lib/files.mjs'
import { median, time } from '../lib/median.mjs'
import { openShaderPage } from '../lib/shader-page.mjs'

export async function measure() {
  const original = readFileSync(path('node_modules/glsl-noise/simplex/3d.glsl'), 'utf8')
  const source = `${original}\nvec3 offset(vec3 p) { return vec3(snoise(p), 0.0, 0.0); }`
  const ourOffset = ({ glsl, position }) => glsl.vec3(position.simplex(), 0, 0)
  const compileSource = (options) => compileWarp(glslOffset(source), options)

  const times = Array.from({ length: 150 }, () => time(() => compileSource()))
  const length = ({ code, declarations }) => code.length + declarations.length
  console.table({
    'source → offset, ms': { median: median(times), best: Math.min(...times), first: times[0] },
  })
  console.table({
    characters: {
      original: original.length,
      'as an offset': length(compileSource({ normals: false })),
      'with exact normals': length(compileSource()),
      'our own simplex': length(compileWarp(ourOffset)),
    },
  })
  await measureInBrowser({
    'webgl-noise, unchanged': { declarations: source, code: 'vec3 moved = p + offset(p), n = p;' },
    'webgl-noise, exact normals': writeShader(compileSource({ surfaceVariation: false })),
    'our own, exact normals': writeShader(compileWarp(ourOffset, { surfaceVariation: false })),
  })
}

function writeShader({ code, declarations }) {
  const inputs = 'vec3 position = p, normal = normalize(p);'
  return {
    declarations,
    code: `${inputs}\n${code}\nvec3 moved = warpedPosition, n = warpedNormal;`,
  }
}

async function measureInBrowser(shaders) {
  const server = await servePages()
  const browser = await launchBrowser()
  const page = await openShaderPage(browser, server)
  console.log('\nTime to the first frame (compile, link, draw), median of 15 runs in ms')
  console.table(await page.evaluate(measureFirstDraws, shaders))

  const field = await openPage(browser, `${server.url}/examples/ray-marched-field/index.html`)
  await field.page.waitForFunction(() => globalThis.frameCount > 1)
  // Uses the variables of the sketch; its function `panel` waits for the GPU.
  const frames = await field.page.evaluate(`{
    noLoop()
    const pairs = Array.from({ length: 9 }, () => [panel(-160, sampled), panel(160, exact)])
    pairs
  }`)
  const [four, one] = [0, 1].map((i) => median(frames.map((pair) => pair[i])))
  console.log('\nA frame of the ray-marched field, median of 9 runs in ms')
  console.table({ 'four evaluations': four, 'one evaluation': one })
  await browser.close()
  await server.close()
}

/** Runs in the page: measures the first draw with each shader. Each program has another constant, so that it is in no cache of a driver. */
function measureFirstDraws(shaders) {
  const scene = new Scene(document.createElement('canvas'), 300)
  const version = '#version 300 es\nprecision highp float;\n'
  let salt = 1
  const timeDraw = ({ declarations, code }) => {
    const vertex = `${version}out vec3 light;\n${declarations}
      void main() {
        vec3 p = vec3(gl_VertexID % 64, gl_VertexID / 64, ${salt++}.5) / 32.0;
        ${code}
        light = n;
        gl_PointSize = 1.0;
        gl_Position = vec4(moved * 0.3, 1.0);
      }`
    const fragment = `${version}in vec3 light; out vec4 color; void main() { color = vec4(light, 1.0); }`
    const start = performance.now()
    scene.gl.useProgram(scene.program(vertex, fragment))
    scene.gl.drawArrays(scene.gl.POINTS, 0, 4096)
    scene.finish()
    return performance.now() - start
  }
  const times = Object.fromEntries(Object.keys(shaders).map((name) => [name, []]))
  for (let i = 0; i < 16; i++)
    for (const [name, shader] of Object.entries(shaders)) {
      const time = timeDraw(shader)
      // The first draw also starts the renderer.
      if (i > 0) times[name].push(time)
    }
  return Object.fromEntries(Object.entries(times).map(([name, list]) => [name, quantile(list)]))
}
