// npm run bench:glsl: how long webgl-noise's 3D simplex takes to become an offset with exact normals, how long its text is then, and
// how soon it is drawn first, beside our own simplex; and a frame of a ray-marched field, its light by four evaluations and by one
// function.
import { readFileSync } from 'node:fs'
import { performance } from 'node:perf_hooks'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { median } from './lib/median.mjs'
import { main } from './lib/terminal.mjs'

const times = (count, work) =>
  Array.from({ length: count }, () => {
    const start = performance.now()
    work()
    return performance.now() - start
  })

await main(async () => {
  if (!process.argv.includes('--no-build')) await build()
  const { compileWarp } = await import('../dist/warpjet.js')
  const { glslOffset } = await import('../dist/glsl.js')
  const original = readFileSync(path('node_modules/glsl-noise/simplex/3d.glsl'), 'utf8')
  const text = `${original}\nvec3 offset(vec3 p) { return vec3(snoise(p), 0.0, 0.0); }`
  const own = ({ glsl, position }) => glsl.vec3(position.simplex(), 0, 0)
  const compiled = (options) => compileWarp(glslOffset(text), options)

  const all = times(150, () => compiled())
  console.log(
    `webgl-noise's 3D simplex as an offset: median ${median(all).toFixed(1)} ms, best ${Math.min(...all).toFixed(1)} ms, first ${all[0].toFixed(1)} ms`,
  )
  const length = ({ code, declarations }) => code.length + declarations.length
  const [plain, exact] = [{ normals: false }, {}].map((options) => length(compiled(options)))
  console.log(
    `${original.length} characters; as an offset ${plain}, with exact normals ${exact}; our own simplex ${length(compileWarp(own))}`,
  )
  await inBrowser({
    "webgl-noise's, as it is": { declarations: text, code: 'vec3 moved = p + offset(p), n = p;' },
    "webgl-noise's, exact normals": shaderOf(compiled({ surfaceVariation: false })),
    'our own, exact normals': shaderOf(compileWarp(own, { surfaceVariation: false })),
  })
})

function shaderOf({ code, declarations }) {
  const given = 'vec3 position = p, normal = normalize(p);'
  return { declarations, code: `${given}\n${code}\nvec3 moved = warpedPosition, n = warpedNormal;` }
}

async function inBrowser(shaders) {
  const { launchBrowser, openPage } = await import('../tests/support/browser/browser.js')
  const { servePages } = await import('../tests/support/browser/server.js')
  const server = await servePages()
  const browser = await launchBrowser()
  const { page } = await openPage(browser, server.page('<!doctype html><meta charset="utf-8">'))
  console.log('\nto the first picture, median ms of 15: compiled, linked, drawn')
  for (const [name, time] of Object.entries(await page.evaluate(firstDraws, shaders)))
    console.log(`${name.padEnd(30)} ${time.toFixed(1).padStart(6)}`)

  const field = await openPage(browser, `${server.url}/examples/ray-marched-field/index.html`)
  await field.page.waitForFunction(() => globalThis.frameCount > 1)
  // The sketch's own variables. It waits for the processor of graphics.
  const frames = await field.page.evaluate(`{
    noLoop()
    const all = Array.from({ length: 9 }, () => [panel(-160, usual), panel(160, exact)])
    all
  }`)
  const [usual, exact] = [0, 1].map((i) => median(frames.map((pair) => pair[i])).toFixed(0))
  console.log(
    `\na frame of the ray-marched field, median ms of 9: light by four evaluations ${usual}, by one function ${exact}`,
  )
  await browser.close()
  await server.close()
}

/** In a page. Each program has a number of its own, so that no driver knows it; the order changes. */
function firstDraws(shaders) {
  const gl = document.createElement('canvas').getContext('webgl2')
  const stage = (program, type, source) => {
    const shader = gl.createShader(type)
    gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${source}`)
    gl.compileShader(shader)
    gl.attachShader(program, shader)
  }
  let salt = 1
  const draw = ({ declarations, code }) => {
    const start = performance.now()
    const program = gl.createProgram()
    stage(
      program,
      gl.VERTEX_SHADER,
      `out vec3 light;\n${declarations}
      void main() {
        vec3 p = vec3(gl_VertexID % 64, gl_VertexID / 64, ${salt++}.5) / 32.0;
        ${code}
        light = n;
        gl_PointSize = 1.0;
        gl_Position = vec4(moved * 0.3, 1.0);
      }`,
    )
    stage(
      program,
      gl.FRAGMENT_SHADER,
      'in vec3 light; out vec4 color; void main() { color = vec4(light, 1.0); }',
    )
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getShaderInfoLog(gl.getAttachedShaders(program)[0]))
    gl.useProgram(program)
    gl.drawArrays(gl.POINTS, 0, 4096)
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
    return performance.now() - start
  }
  const found = Object.fromEntries(Object.keys(shaders).map((name) => [name, []]))
  for (let i = 0; i < 16; i++)
    for (const [name, shader] of Object.entries(shaders)) {
      const time = draw(shader)
      // The first of all starts what draws.
      if (i > 0) found[name].push(time)
    }
  return Object.fromEntries(
    Object.entries(found).map(([name, all]) => [name, all.sort((a, b) => a - b)[7]]),
  )
}
