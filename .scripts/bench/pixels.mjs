// npm run bench -- pixels: times p5 with normals at pixels, and with normals at vertices. The bench `gpu` times only the shaders.
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

/** The page. Its function `frames(source, size, count)` returns medians of `count` frames, in milliseconds. */
const html = `<!doctype html><meta charset="utf-8"><body>
<script src="/node_modules/p5/lib/p5.min.js"></script><script src="/dist/p5.warpjet.min.js"></script>
<script type="module">
import { compileWarp } from '/dist/warpjet.js'
const offsetOf = (source) => (0, eval)(source)
const median = (times) => times.sort((a, b) => a - b)[times.length >> 1]

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
  const rows = {}
  for (const [name, source] of Object.entries(warps)) {
    const frames = await page.evaluate(([text]) => window.frames(text, 600, 3), [source])
    rows[name] = {
      'ms, vertex': round(frames.vertex),
      'ms, pixel': round(frames.pixel),
      ratio: round(frames.pixel / frames.vertex),
      'ms first, vertex': round(frames['vertex first']),
      'ms first, pixel': round(frames['pixel first']),
      auto: frames.auto,
    }
  }
  console.log(
    'Median times of frames in p5: 600 × 600 pixels, a sphere with a radius of 240 pixels:',
  )
  console.table(rows)
  await browser.close()
  await server.close()
}
