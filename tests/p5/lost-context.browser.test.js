// The browser loses and restores a WebGL context: three.js resumes automatically, p5 needs a line in the sketch, and warps behave like
// drawings without warps.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { launchBrowser, leavePage } from '../support/browser/browser.js'
import {
  differingPixels,
  litPixels,
  readPixels,
  readWebGPUPixels,
} from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { p5InThisRun, runSketch } from '../support/browser/sketch.js'
import { threePages } from '../support/browser/three/open.js'

const addon = '/dist/p5.warpjet.min.js'

/** The function that web/docs/uptime.md recommends. */
const [, keepContext] = /```js\n(function keepContext[^]*?)```/.exec(
  readFileSync(new URL('../../web/docs/uptime.md', import.meta.url), 'utf8'),
)

/** Loses the context of the page's canvas, waits, and restores it. */
const lose = `async () => {
  const canvas = document.querySelector('canvas')
  const gl = canvas.getContext('webgl2')
  const extension = gl.getExtension('WEBGL_lose_context')
  const nextEvent = (event) => new Promise((found) => canvas.addEventListener(event, found, { once: true }))
  const lost = nextEvent('webglcontextlost')
  extension.loseContext()
  await lost
  await draw()
  // restoreContext() would throw while the browser still reports the loss.
  await new Promise((later) => setTimeout(later, 50))
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
  let browser, server
  before(async () => {
    server = await servePages()
    browser = await launchBrowser()
  })
  after(async () => {
    await browser.close()
    await server.close()
  })

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
          await page.evaluate(`(${lose.replaceAll('draw()', 'redraw()')})()`)
          const differing = differingPixels(await readPixels(page), first, 0)
          assert.equal(differing, 0, `${isWarped ? 'warps' : 'no warp'}, ${time}`)
        }
        firsts.push(first)
        await leavePage(page)
      }
      assert.ok(differingPixels(...firsts, 30) > 1000, 'the warps are seen')
    })

    if (isRun('unusual p5 pages'))
      test(`p5 ${version} without keepContext() draws nothing after a loss, with and without warps`, async () => {
        for (const isWarped of [false, true]) {
          const { page } = await open(isWarped, false)
          await page.evaluate(`(${lose.replaceAll('draw()', 'redraw()')})()`)
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
        await page.evaluate(`(${lose})()`)
        const then = await readWebGPUPixels(page, 'draw()')
        assert.equal(differingPixels(then, first, 0), 0, isWarped ? 'a warp' : 'no warp')
        assert.deepEqual(messages, [
          'THREE.WebGLRenderer: Context Lost.',
          'THREE.WebGLRenderer: Context Restored.',
        ])
        firsts.push(first)
        await leavePage(page)
      }
      assert.ok(differingPixels(...firsts, 30) > 1000, 'the warp is seen')
    } finally {
      await pages.close()
    }
  })
})
