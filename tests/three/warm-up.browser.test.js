// After 'warpjet/three/webgpu' is imported, the compiler starts in idle callbacks. The pages of these tests call the callbacks themselves.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { threePages } from '../support/browser/three/open.js'

let pages
before(async () => (pages = await threePages()))
after(() => pages.close())

/**
 * Opens a page that counts wasm modules, and queues idle callbacks. Returns what `code` passes to `note()`. `code` runs after the import,
 * and may call `draw()` and `idle()`.
 */
async function run(code) {
  const { page, messages } = await pages.listing(`
    const { Module } = WebAssembly
    let modules = 0
    WebAssembly.Module = class extends Module { constructor(...args) { super(...args); modules++ } }
    const callbacks = []
    window.requestIdleCallback = (work) => callbacks.push(work)
    /** Calls the callbacks, including those that they add; returns their number. */
    function idle() {
      let count = 0
      for (; callbacks.length; count++) callbacks.shift()()
      return count
    }
    const THREE = await import('three/webgpu')
    const { exactNormals } = await import('warpjet/three/webgpu')
    async function draw() {
      const { positionLocal, sin, vec3 } = THREE.TSL
      const material = new THREE.MeshStandardNodeMaterial()
      material.positionNode = positionLocal.add(vec3(0, sin(positionLocal.x), 0))
      const scene = new THREE.Scene().add(new THREE.Mesh(new THREE.BoxGeometry(), exactNormals(material)))
      const renderer = new THREE.WebGPURenderer({ forceWebGL: true })
      await renderer.init()
      renderer.render(scene, new THREE.PerspectiveCamera())
    }
    const result = []
    const note = (...values) => result.push(values)
    ${code}
    window.result = result`)
  await page.waitForFunction(() => window.result, null, { timeout: 30_000 })
  assert.deepEqual(messages, [])
  return page.evaluate(() => window.result)
}

test('an idle page starts the front end and the compiler, in short steps', async () => {
  const code = `note('imported', modules); note('steps', idle(), modules); await draw(); note('drawn', modules)`
  assert.deepEqual(await run(code), [
    ['imported', 0],
    ['steps', 30, 2],
    ['drawn', 2],
  ])
})

test('drawing a positionNode first starts the compiler at once, so that nothing is left to do when idle', async () => {
  const code = `await draw(); note('drawn', modules); note('steps', idle(), modules)`
  assert.deepEqual(await run(code), [
    ['drawn', 2],
    ['steps', 1, 2],
  ])
})

test('a page that forbids WebAssembly gets no message when idle', async () => {
  const code = `WebAssembly.Module = () => { throw new Error('forbidden') }; note('steps', idle())`
  const [[, steps]] = await run(code)
  assert.ok(steps < 4, `${steps} steps`)
})
