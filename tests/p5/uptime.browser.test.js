// Sketches that run for a long time: a page that makes a new warp in each frame, a tab that sleeps, and a browser that loses and restores a
// WebGL context. After a restored context, three.js resumes automatically, p5 needs a line in the sketch, and warps behave like drawings
// without warps.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { leavePage } from '../support/browser/browser.js'
import { addon } from '../support/browser/p5-hosts.js'
import {
  differingPixels,
  litPixels,
  readPixels,
  readWebGPUPixels,
} from '../support/browser/pixels.js'
import { openHost, p5InThisRun, p5Versions, runSketch } from '../support/browser/sketch.js'
import { threePages } from '../support/browser/three/open.js'

const { browser, server } = await openHost()

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
      // In several tasks, since programs are freed in the task after that of their warp.
      for (let i = 0; i < count; i += 10) await page.evaluate('live(10)')
      await devtools.send('HeapProfiler.collectGarbage')
      // This is exact to the byte; performance.memory may not change for minutes.
      return (await devtools.send('Runtime.getHeapUsage')).usedSize / 1e6
    }
    const before = await heap(60)
    const later = await heap(40)
    await leavePage(page)
    // If warps leaked, each would take 14 KB. The engine itself grows by 1.2 KB for each of the next 100 warps, and by 0.8 KB for each of
    // the following 300.
    assert.ok(later - before < 0.15, `${(later - before).toFixed(2)} MB for 40 warps`)
  })

test('a tab that slept for an hour wakes up with the picture of the current time, and without artefacts', async () => {
  const sketch = `
    let clock = 0
    performance.now = () => clock
    const created = {}
    for (const name of ['Buffer', 'Texture', 'Program', 'Shader', 'VertexArray', 'Framebuffer']) {
      const { prototype } = WebGL2RenderingContext
      const create = prototype['create' + name]
      prototype['create' + name] = function (...kind) { created[name] = (created[name] ?? 0) + 1; return create.apply(this, kind) }
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
    function redrawAt(time) { clock = time; redraw() }`
  const hour = 3_600_000
  const pictures = async (times) => {
    const { page, messages } = await runSketch(browser, server, [p5Versions['2.x'], addon], sketch)
    const images = []
    const counts = []
    for (const time of times) {
      await page.evaluate(`redrawAt(${time})`)
      images.push(await readPixels(page))
      counts.push(await page.evaluate('({ ...created })'))
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
  const [after16, after250] = [4, 5].map((i) =>
    differingPixels(slept.images[3], slept.images[i], 4),
  )
  assert.ok(
    after16 > 0 && after16 < after250,
    `${after16} pixels differ after 16 ms, ${after250} after 250 ms`,
  )
  assert.deepEqual(slept.counts.at(-1), slept.counts[1])
})

/** The function that web/docs/uptime.md recommends. */
const [, keepContext] = /```js\n(function keepContext[^]*?)```/.exec(
  readFileSync(new URL('../../web/docs/uptime.md', import.meta.url), 'utf8'),
)

/** Code that loses the context of the page's canvas, draws, restores it, and draws again. */
const loseAndRestore = `async () => {
  const canvas = document.querySelector('canvas')
  const gl = canvas.getContext('webgl2')
  const extension = gl.getExtension('WEBGL_lose_context')
  const nextEvent = (event) => new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }))
  const lost = nextEvent('webglcontextlost')
  extension.loseContext()
  await lost
  await draw()
  // restoreContext() would throw while the browser still reports the loss.
  await new Promise((resolve) => setTimeout(resolve, 50))
  const restored = nextEvent('webglcontextrestored')
  extension.restoreContext()
  await restored
  await draw()
}`

const sketch = (isWarped, keepsContext) => `
  const shown = ${isWarped}
  let bumps, lines, map
  function setup() {
    pixelDensity(1)
    createCanvas(200, 200, WEBGL)
    noLoop()
    map = createImage(8, 8)
    for (let y = 0; y < 8; y++) for (let x = 0; x < 8; x++) map.set(x, y, color(30 * x, 30 * y, 90))
    map.updatePixels()
    bumps = createWarp(({ glsl, normal, uv, uniforms }) =>
      normal.mult(glsl.texture(uniforms.map, uv, { filter: 'bicubic' }).x.mult(0.3)), { uniforms: { map } })
    lines = createWarp(({ glsl, position }) => glsl.vec3(position.y.div(20).sin().mult(20), 0, 0), { stroke: true, space: 'world' })
    ${keepsContext ? 'keepContext()' : `document.querySelector('canvas').addEventListener('webglcontextlost', (event) => event.preventDefault())`}
  }
  ${keepContext}
  window.draw = () => {
    background(0); lights(); translate(-40, 0)
    noStroke(); fill('coral'); push(); if (shown) bumps(); sphere(45); pop()
    stroke(255); strokeWeight(3); noFill(); translate(90, 0); if (shown) lines(); sphere(30, 8, 6)
    resetShader()
    window.done = true
  }`

describe('a lost context', () => {
  for (const [version, p5] of p5InThisRun) {
    const open = (isWarped, keepsContext) =>
      runSketch(browser, server, [p5, addon], sketch(isWarped, keepsContext))

    test(`p5 ${version} with keepContext() of the docs draws the same again after two losses, with and without warps`, async () => {
      const firsts = []
      for (const isWarped of [false, true]) {
        const { page, messages } = await open(isWarped, true)
        const first = await readPixels(page)
        assert.ok(litPixels(first).length > 4000)
        for (const time of ['once', 'twice']) {
          messages.length = 0
          await page.evaluate(`(${loseAndRestore.replaceAll('draw()', 'redraw()')})()`)
          const differing = differingPixels(await readPixels(page), first, 0)
          assert.equal(differing, 0, `${isWarped ? 'warps' : 'no warp'}, ${time}`)
        }
        firsts.push(first)
        await leavePage(page)
      }
      assert.ok(differingPixels(...firsts, 30) > 1000, 'the warps do not change the picture')
    })

    if (isRun('unusual p5 pages'))
      test(`p5 ${version} without keepContext() draws nothing after a loss, with and without warps`, async () => {
        for (const isWarped of [false, true]) {
          const { page } = await open(isWarped, false)
          await page.evaluate(`(${loseAndRestore.replaceAll('draw()', 'redraw()')})()`)
          assert.equal(litPixels(await readPixels(page)).length, 0)
          await leavePage(page)
        }
      })
  }

  test('three.js draws the same again after a loss, with and without warps', async () => {
    const pages = await threePages()
    try {
      const firsts = []
      for (const isWarped of [false, true]) {
        const { page, messages } = await pages.listing(`
          import * as THREE from 'three'
          import { addSurfaceVariation, warp } from 'warpjet/three'
          const renderer = new THREE.WebGLRenderer()
          renderer.setSize(200, 200)
          renderer.shadowMap.enabled = true
          document.body.append(renderer.domElement)
          const scene = new THREE.Scene()
          const camera = new THREE.PerspectiveCamera(40, 1, 1, 20)
          camera.position.z = 6
          const light = new THREE.DirectionalLight(0xffffff, 3)
          light.position.set(2, 3, 4)
          light.castShadow = true
          const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 32, 24), new THREE.MeshStandardMaterial({ color: 0xff8866 }))
          const floor = new THREE.Mesh(new THREE.PlaneGeometry(6, 6), new THREE.MeshStandardMaterial())
          floor.position.z = -1.5
          ball.castShadow = floor.receiveShadow = true
          scene.add(light, ball, floor)
          const texels = Uint8Array.from({ length: 4 * 64 }, (_, i) => (37 * i) % 256)
          const map = new THREE.DataTexture(texels, 8, 8)
          map.needsUpdate = true
          await addSurfaceVariation(ball.geometry)
          if (${isWarped})
            warp(ball, ({ glsl, normal, uv, uniforms }) =>
              normal.mult(glsl.texture(uniforms.map, uv, { filter: 'bicubic' }).x.mult(0.3)), { uniforms: { map } })
          window.draw = () => renderer.render(scene, camera)
          draw()
          window.drawn = true`)
        await page.waitForFunction(() => window.drawn)
        const first = await readWebGPUPixels(page, 'draw()')
        assert.ok(litPixels(first).length > 4000)
        assert.deepEqual(messages.splice(0), [])
        await page.evaluate(`(${loseAndRestore})()`)
        const again = await readWebGPUPixels(page, 'draw()')
        assert.equal(differingPixels(again, first, 0), 0, isWarped ? 'a warp' : 'no warp')
        assert.deepEqual(messages, [
          'THREE.WebGLRenderer: Context Lost.',
          'THREE.WebGLRenderer: Context Restored.',
        ])
        firsts.push(first)
        await leavePage(page)
      }
      assert.ok(differingPixels(...firsts, 30) > 1000, 'the warp does not change the picture')
    } finally {
      await pages.close()
    }
  })
})
