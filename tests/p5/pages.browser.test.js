// Warps wherever a sketch draws: in a p5.Framebuffer, on built shapes, next to other sketches and other versions of p5, and after
// its canvas changed; and a page that makes a new warp in each frame.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage, openPage } from '../support/browser/browser.js'
import { differingPixels, litPixels, readPixels } from '../support/browser/pixels.js'
import {
  drawScenes,
  openHosts,
  p5HostsInThisRun,
  p5Versions,
  runSketch,
} from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

const { browsers, server } = await openHosts(p5HostsInThisRun)
const browser = browsers.WEBGL

/** Moves by the same distance to the right as p5's own translate. */
const toTheRight = `({ glsl }) => glsl.vec3(40, 0, 0), { space: 'world' }`

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`a warp on p5 ${version}, ${renderer}`, () => {
    test('moves drawings in a framebuffer, and shapes of each kind, under each light', async () => {
      const shapes = {
        'in a framebuffer': (move) =>
          `target.begin(); clear(); ${move}; fill('red'); sphere(30); target.end(); resetShader(); image(target, -100, -100)`,
        'built by buildGeometry': (move) => `lights(); ${move}; fill('red'); model(built)`,
        'made by createModel': (move) => `lights(); ${move}; fill('red'); scale(30); model(made)`,
        ...(isRun('unusual p5 pages') && {
          'under an imageLight': (move) =>
            `imageLight(sky); ${move}; specularMaterial(200); shininess(90); sphere(30)`,
          // p5 draws this shape with a separate shader.
          'before a panorama': (move) =>
            `panorama(sky); lights(); ${move}; fill('red'); sphere(30)`,
        }),
        'between vertices': (move) =>
          `${move}; fill('red'); beginShape(); vertex(-20, -20); vertex(20, -20); vertex(0, 20); endShape(CLOSE)`,
      }
      // Seen head-on from far away, so that a shape shows the same side after it moves.
      const look = 'ortho(); noStroke()'
      const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
        renderer,
        setup: `
          right = createWarp(${toTheRight})
          target = createFramebuffer({ width: 200, height: 200, density: 1 })
          built = buildGeometry(() => { translate(0, 20, 0); sphere(30) })
          built.normalize && (built.gid = 'built')
          made = createModel('v -1 -1 0\\nv 1 -1 0\\nv 0 1 0\\nvn 0 0 1\\nvt 0 0\\nf 1/1/1 2/1/1 3/1/1\\n', '.obj')
          sky = createImage(32, 16)
          for (let y = 0; y < 16; y++)
            for (let x = 0; x < 32; x++) sky.set(x, y, color(8 * x, 200 - 9 * y, 90))
          sky.updatePixels()`,
        scenes: Object.fromEntries(
          Object.entries(shapes).flatMap(([name, shape]) => [
            [name, `${look}; ${shape('right()')}`],
            [`${name} by p5`, `${look}; ${shape('translate(40, 0, 0)')}`],
            [`${name} unmoved`, `${look}; ${shape('')}`],
          ]),
        ),
      })
      for (const name of Object.keys(shapes)) {
        const right = images[`${name} by p5`]
        assert.ok(differingPixels(images[`${name} unmoved`], right, 30) > 300, `${name} moves`)
        const differing = differingPixels(images[name], right, 8)
        assert.ok(differing < 40, `${name}: ${differing} pixels differ`)
      }
    })
  })

const instance = (name, code) => `
  const ${name} = new P5(p => {
    let right
    p.setup = () => {
      p.pixelDensity(1)
      p.createCanvas(100, 100, p.WEBGL)
      right = p.createWarp(({ glsl }) => glsl.vec3(20, 0, 0), { space: 'world' })
      p.noLoop()
    }
    p.draw = () => { p.background(0); right(); p.fill('red'); p.plane(20); ${code} }
  })`

/** Returns [red at the centre, red 20 pixels to the right] of a sketch's canvas. */
const redsOf = (name) => `(() => {
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = 100
  const context = canvas.getContext('2d', { willReadFrequently: true })
  ${name}.redraw()
  context.drawImage(${name}.canvas, 0, 0, 100, 100)
  return [50, 70].map((x) => context.getImageData(x, 50, 1, 1).data[0])
})()`

test('works on several canvases, after remove() and a new sketch, and on a resized canvas', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x'], addon],
    `window.P5 = p5
    window.ready = 0
    ${instance('mine', 'ready++')}
    ${instance('yours', 'ready++')}
    const timer = setInterval(() => { if (ready >= 2) { clearInterval(timer); window.done = true } })`,
  )
  assert.deepEqual(await page.evaluate(redsOf('mine')), [0, 255])
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate('yours.resizeCanvas(60, 60); yours.resizeCanvas(100, 100)')
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate('mine.remove()')
  assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
  await page.evaluate(`ready = 0; ${instance('window.theirs', 'ready++').replace('const ', '')}`)
  await page.waitForFunction('ready > 0')
  assert.deepEqual(await page.evaluate(redsOf('theirs')), [0, 255])
  await leavePage(page)
  assert.deepEqual(messages, [])
})

if (isRun('unusual p5 pages'))
  test('works with two versions of p5 on one page, each followed by the script', async () => {
    const script = (src) => `<script src="${src}"></script>`
    const { page, messages } = await openPage(
      browser,
      server.page(`<!doctype html><body>
        ${script(p5Versions['1.11'])}${script(addon)}<script>const older = p5; p5 = undefined</script>
        ${script(p5Versions['2.x'])}${script(addon)}
        <script>
          window.ready = 0
          const newer = p5
          window.P5 = older
          ${instance('mine', 'ready++')}
          P5 = newer
          ${instance('yours', 'ready++')}
        </script>`),
    )
    await page.waitForFunction('ready >= 2')
    assert.deepEqual(await page.evaluate(redsOf('mine')), [0, 255])
    assert.deepEqual(await page.evaluate(redsOf('yours')), [0, 255])
    await leavePage(page)
    assert.deepEqual(messages, [])
  })

if (isRun('unusual p5 pages'))
  test('leaks no memory if each frame makes a new warp, as in live coding', async () => {
    const { page } = await runSketch(
      browser,
      server,
      [p5Versions['2.x'], addon],
      `function setup() { createCanvas(60, 60, WEBGL); noLoop(); noStroke() }
      function live(count) {
        for (let i = 0; i < count; i++) {
          const distort = createWarp(({ glsl, position, millis }) =>
            glsl.vec3(position.y.mult(4 + i % 7).add(millis.div(500)).sin().mult(0.1), position.x.mult(i).sin(), 0))
          resetMatrix()
          background(0); lights(); distort(); sphere(20, 12, 8)
        }
      }
      function draw() { window.done = true }`,
    )
    const devtools = await page.context().newCDPSession(page)
    await devtools.send('HeapProfiler.enable')
    const heap = async (count) => {
      // A program is freed in a separate task after its owner.
      for (let i = 0; i < count; i += 10) await page.evaluate('live(10)')
      await devtools.send('HeapProfiler.collectGarbage')
      // Exact to the byte, unlike performance.memory, which may not change for minutes.
      return (await devtools.send('Runtime.getHeapUsage')).usedSize / 1e6
    }
    const before = await heap(60)
    const later = await heap(40)
    await leavePage(page)
    // A warp in use has 14 KB. The rest is growth of the engine: 1.2 KB for each of the next 100 warps, 0.8 for the 300 after.
    assert.ok(later - before < 0.15, `${(later - before).toFixed(2)} MB for 40 warps`)
  })

test('a tab that slept for an hour wakes up with the picture of the current time, and without artefacts', async () => {
  const sketch = `
    let clock = 0
    performance.now = () => clock
    const made = {}
    for (const name of ['Buffer', 'Texture', 'Program', 'Shader', 'VertexArray', 'Framebuffer']) {
      const { prototype } = WebGL2RenderingContext
      const create = prototype['create' + name]
      prototype['create' + name] = function (...kind) { made[name] = (made[name] ?? 0) + 1; return create.apply(this, kind) }
    }
    let wave
    function setup() {
      pixelDensity(1)
      createCanvas(100, 100, WEBGL)
      noLoop(); noStroke()
      wave = createWarp(({ glsl, normal, position, millis, uniforms }) =>
        normal.mult(position.y.mult(4).add(millis.div(500)).sin().mult(uniforms.height)), { uniforms: { height: 0.3 } })
    }
    function draw() {
      background(0); lights(); wave(); fill('coral'); sphere(30)
      window.done = true
    }
    function at(time) { clock = time; redraw() }`
  const hour = 3_600_000
  const pictures = async (times) => {
    const { page, messages } = await runSketch(browser, server, [p5Versions['2.x'], addon], sketch)
    const images = []
    const counts = []
    for (const time of times) {
      await page.evaluate(`at(${time})`)
      images.push(await readPixels(page))
      counts.push(await page.evaluate('({ ...made })'))
    }
    await leavePage(page)
    assert.deepEqual(messages, [])
    return { images, counts }
  }
  const slept = await pictures([100, 116, 132, hour, hour + 16, hour + 250, hour + 16])
  const awake = await pictures([hour, hour + 16])
  assert.ok(litPixels(slept.images[3]).length > 1000)
  assert.equal(differingPixels(slept.images[3], awake.images[0], 0), 0)
  assert.equal(differingPixels(slept.images[4], awake.images[1], 0), 0)
  assert.equal(differingPixels(slept.images[6], awake.images[1], 0), 0)
  // Motion during 16 ms is small, but not zero.
  const [step, way] = [4, 5].map((i) => differingPixels(slept.images[3], slept.images[i], 4))
  assert.ok(step > 0 && step < way, `${step} pixels in 16 ms, ${way} in 250`)
  assert.deepEqual(slept.counts.at(-1), slept.counts[1])
})
