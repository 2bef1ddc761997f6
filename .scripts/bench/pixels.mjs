// npm run bench -- pixels: what normals at pixels cost. Times the fragment shader alone, beside normals by differences in it, and frames
// of p5 with normals at vertices and at pixels.
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { servePages } from '../../tests/support/browser/server.js'

/** Sources of offset functions of a sphere of radius 1. */
export const warps = {
  twist: `({ glsl, position }) => glsl.rotateY(position.y().mult(1.5)).mult(position).sub(position)`,
  wave: `({ glsl, position }) => glsl.vec3(position.y().mult(7).sin().mult(0.05), 0, 0)`,
  'three sines': `({ glsl, position: p }) => glsl.vec3(p.y().mult(7).sin(), p.z().mult(7).sin(), p.x().mult(7).sin()).mult(0.05)`,
  simplex: `({ glsl, position: p }) => p.mult(glsl.simplex(p.mult(2)).mult(0.2))`,
  worley: `({ glsl, position: p }) => p.mult(glsl.worley(p.mult(2)).x().mult(0.2))`,
  fbm: `({ glsl, position: p }) => p.mult(glsl.fbm(p.mult(2)).mult(0.3))`,
  'fbm of fbm': `({ glsl, position: p }) => p.mult(glsl.fbm(p.add(glsl.fbm(p.mult(2)))).mult(0.3))`,
}

/** The page: `fragments(source, size, frames)` and `frames(source, size, count)` return milliseconds, medians. */
const html = `<!doctype html><meta charset="utf-8"><body>
<script src="/node_modules/p5/lib/p5.min.js"></script><script src="/dist/p5.warpjet.min.js"></script>
<script type="module">
import { compileWarp } from '/dist/warpjet.js'
const offsetOf = (source) => (0, eval)(source)
const median = (times) => times.sort((a, b) => a - b)[times.length >> 1]

const vertex = \`#version 300 es
out vec3 rest;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  rest = vec3(corner, 0.7);
  gl_Position = vec4(corner, 0.0, 1.0);
}\`
const fragment = (declarations, body) => \`#version 300 es
precision highp float;
in vec3 rest;
out vec4 color;
\${declarations}
void main() {
  vec3 normal = normalize(rest);
  \${body}
}\`

/** The normal by central differences along two tangents: four evaluations of the offset. */
function byDifferences(warp) {
  const move = \`vec3 move(vec3 position, vec3 normal) { \${warp.code} return warpedPosition; }\`
  return fragment(warp.declarations + move, \`vec3 u = normalize(cross(normal, vec3(0.3, 0.8, 0.5))) * 1e-3;
    vec3 v = cross(normal, u);
    vec3 across = cross(move(rest + u, normal) - move(rest - u, normal), move(rest + v, normal) - move(rest - v, normal));
    color = vec4(normalize(across), 1.0);\`)
}

function bySlopes({ declarations, code }) {
  return fragment(declarations, 'vec3 position = rest;' + code + 'color = vec4(warpedNormal, 1.0);')
}

function timeFragment(source, size, frames) {
  const canvas = new OffscreenCanvas(size, size)
  const gl = canvas.getContext('webgl2')
  const program = gl.createProgram()
  const start = performance.now()
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, source]]) {
    const shader = gl.createShader(type)
    gl.shaderSource(shader, text)
    gl.compileShader(shader)
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader))
    gl.attachShader(program, shader)
  }
  gl.linkProgram(program)
  gl.useProgram(program)
  const pixel = new Uint8Array(4)
  const draw = () => {
    gl.drawArrays(gl.TRIANGLES, 0, 3)
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel)
  }
  draw()
  const first = performance.now() - start
  const times = []
  for (let i = 0; i < frames; i++) { const begin = performance.now(); draw(); times.push(performance.now() - begin) }
  gl.getExtension('WEBGL_lose_context').loseContext()
  return { frame: median(times), first }
}

window.fragments = (source, size, frames) => {
  const warp = compileWarp(offsetOf(source), { normals: 'pixel' })
  const slopes = warp.emitFragment()
  const plain = timeFragment(fragment('', 'color = vec4(normal, 1.0);'), size, frames)
  const jacobian = timeFragment(bySlopes(slopes), size, frames)
  const differences = timeFragment(byDifferences(warp), size, frames)
  return { characters: slopes.code.length + slopes.declarations.length, plain, jacobian, differences }
}

window.frames = async (source, size, count) => {
  const results = {}
  for (const normals of ['vertex', 'pixel']) {
    const sketch = await new Promise((resolve) => new p5((s) => {
      s.setup = () => { s.pixelDensity(1); s.createCanvas(size, size, s.WEBGL); s.noLoop(); s.noStroke(); resolve(s) }
    }))
    const start = performance.now()
    const distort = sketch.createWarp(offsetOf(source), { normals })
    const { GL } = sketch._renderer
    const pixel = new Uint8Array(4)
    const draw = () => {
      sketch.background(0)
      sketch.directionalLight(255, 255, 255, 0.5, 0.6, -1)
      distort(); sketch.sphere(size * 0.4)
      GL.readPixels(0, 0, 1, 1, GL.RGBA, GL.UNSIGNED_BYTE, pixel)
    }
    draw()
    results[normals + ' first'] = performance.now() - start
    const times = []
    for (let i = 0; i < count; i++) { const begin = performance.now(); draw(); times.push(performance.now() - begin) }
    results[normals] = median(times)
    sketch.remove()
  }
  const auto = compileWarp(offsetOf(source), { normals: 'auto' }).normals
  return { ...results, auto }
}
window.ready = true
</script>`

const round = (x) => Number(x.toPrecision(3))

export async function measure() {
  const server = await servePages()
  const browser = await launchBrowser()
  const { page } = await openPage(browser, server.page(html))
  await page.waitForFunction(() => window.ready)
  const [small, large] = [{}, {}]
  for (const [name, source] of Object.entries(warps)) {
    const at = await page.evaluate(([text]) => fragments(text, 240, 5), [source])
    small[name] = {
      characters: at.characters,
      'ms, no warp': round(at.plain.frame),
      'ms, Jacobian': round(at.jacobian.frame),
      'ms, differences': round(at.differences.frame),
      ratio: round(at.jacobian.frame / at.differences.frame),
      'ms, first': round(at.jacobian.first),
    }
    const frames = await page.evaluate(([text]) => window.frames(text, 600, 3), [source])
    large[name] = {
      'ms, vertex': round(frames.vertex),
      'ms, pixel': round(frames.pixel),
      ratio: round(frames.pixel / frames.vertex),
      'ms first, vertex': round(frames['vertex first']),
      'ms first, pixel': round(frames['pixel first']),
      auto: frames.auto,
    }
  }
  console.log('The fragment shader alone, 240 × 240 pixels, medians:')
  console.table(small)
  console.log('A frame of p5, 600 × 600 pixels, a sphere of 240 pixels, medians:')
  console.table(large)
  await browser.close()
  await server.close()
}
