// `<Warp>` of 'warpjet/react' in a page with @react-three/fiber: around and in a mesh, with new values and new offsets, and
// nothing of it left when it is gone.
import assert from 'node:assert/strict'
import { mkdirSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowser, openPage } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const project = '.build/react'

const code = `
import { createElement as e, Suspense, StrictMode, act } from 'react'
import { createRoot, extend, useFrame } from '@react-three/fiber'
import * as THREE from 'three'
import { Warp } from 'warpjet/react'
import { settledHeap } from '../support/browser/three/heap.js'

extend(THREE)
globalThis.IS_REACT_ACT_ENVIRONMENT = true

const canvas = document.body.appendChild(document.createElement('canvas'))
const size = 64
const root = createRoot(canvas)
await root.configure({
  size: { width: size, height: size, top: 0, left: 0 },
  frameloop: 'never',
  dpr: 1,
  gl: { antialias: false, preserveDrawingBuffer: true },
  camera: { position: [0, 0, 3] },
  flat: true,
})

let state
/** Keeps the program of what is not warped, too, with a mesh that nobody sees: each time it came back it would be compiled. */
const Spy = () => {
  useFrame((now) => (state = now))
  return e('mesh', { scale: 0, frustumCulled: false }, e('sphereGeometry'), e('meshBasicMaterial'))
}

const offsets = {
  right: ({ glsl, uniforms }) => glsl.vec3(uniforms.amount, 0, 0),
  up: ({ glsl, uniforms }) => glsl.vec3(0, uniforms.amount, 0),
  clock: ({ glsl, millis }) => glsl.vec3(0, 0, millis.mult(0)),
}

const ball = (...more) =>
  e('mesh', {}, e('sphereGeometry', { args: [0.3, 16, 12] }), e('meshBasicMaterial', { color: 'white' }), ...more)

const shared = new THREE.MeshBasicMaterial()

const pages = {
  plain: () => ball(),
  in: ({ offset = 'right', amount = 0 }) => ball(e(Warp, { offset: offsets[offset], uniforms: { amount } })),
  around: ({ offset = 'right', amount = 0 }) =>
    e(Warp, { offset: offsets[offset], uniforms: { amount } }, ball()),
  given: ({ amount = 0 }) =>
    e('mesh', { material: shared }, e('sphereGeometry', { args: [0.3, 16, 12] }), e(Warp, { offset: offsets.right, uniforms: { amount } })),
}

const late = { promise: null, done: false }
const Late = () => {
  if (!late.done) throw (late.promise ??= new Promise((resolve) => setTimeout(() => resolve((late.done = true)), 50)))
  return null
}
pages.suspended = ({ amount = 0 }) =>
  e(Suspense, { fallback: null }, e(Warp, { offset: offsets.right, uniforms: { amount } }, ball(), e(Late)))

/** Draws and gives the middle of what is white, from -1 to 1, and how much there is. */
window.show = async (name, props = {}) => {
  await act(async () => root.render(e(StrictMode, null, e(Spy), name && e(pages[name], props))))
  const { advance } = await import('@react-three/fiber')
  advance(performance.now())
  const gl = state.gl.getContext()
  const bytes = new Uint8Array(4 * size * size)
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, bytes)
  let [x, y, count] = [0, 0, 0]
  for (let i = 0; i < size * size; i++)
    if (bytes[4 * i] > 128) {
      x += ((i % size) + 0.5) / (size / 2) - 1
      y += (Math.floor(i / size) + 0.5) / (size / 2) - 1
      count++
    }
  return { x: x / count, y: y / count, count }
}
/** Mounts and unmounts → what three.js counts and the heap. Every tenth time it is drawn, which compiles what it is drawn with. */
window.cycle = async (times) => {
  for (let i = 0; i < times; i++) {
    if (i % 10 === 0) await show('around', { amount: i / times })
    else await act(async () => root.render(e(StrictMode, null, e(Spy), e(pages.around, { amount: i / times }))))
    await show('plain')
  }
  const heap = await settledHeap()
  const { memory, programs } = state.gl.info
  return { ...memory, programs: programs.length, heap }
}
window.isShared = () => !Object.hasOwn(shared, 'onBeforeCompile')
document.title = 'ready'
`

let browser, pages, page, messages
before(async () => {
  mkdirSync(`${root}${project}`, { recursive: true })
  writeFileSync(`${root}${project}/page.js`, code)
  await build({
    configFile: false,
    logLevel: 'error',
    root: `${root}${project}`,
    resolve: { dedupe: ['three', 'react'] },
    define: { 'process.env.NODE_ENV': '"development"' },
    build: {
      outDir: 'dist',
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: `${root}${project}/page.js`,
        output: { entryFileNames: 'page.js' },
      },
    },
  })
  browser = await launchBrowser(['--js-flags=--expose-gc', '--enable-precise-memory-info'])
  pages = await servePages()
  const html = `<!doctype html><body><script type="module" src="/${project}/dist/page.js"></script>`
  ;({ page, messages } = await openPage(browser, pages.page(html)))
  await page
    .waitForFunction(() => document.title === 'ready')
    .catch((error) => {
      throw new Error(`${error.message}\n${messages.join('\n')}`)
    })
})
after(async () => {
  await browser.close()
  await pages.close()
})

const show = (name, props) => page.evaluate(([name, props]) => show(name, props), [name, props])

/** Half of what the camera sees at the distance of the ball. */
const half = 3 * Math.tan((75 / 2) * (Math.PI / 180))

for (const name of ['in', 'around', 'given', 'suspended'])
  test(`${name}: the offset, a new value of a uniform, and another offset`, async () => {
    const isAt = async (props, x, y) => {
      const at = await show(name, props)
      // Suspended, it comes when what is waited for is there.
      const there = Number.isNaN(at.x)
        ? (await page.waitForTimeout(200), await show(name, props))
        : at
      assert.ok(
        Math.abs(there.x - x / half) < 0.02 && Math.abs(there.y - y / half) < 0.02,
        JSON.stringify(there),
      )
      assert.ok(there.count > 50)
    }
    await isAt({ amount: 0 }, 0, 0)
    await isAt({ amount: 1 }, 1, 0)
    if (name === 'in' || name === 'around') await isAt({ amount: 1, offset: 'up' }, 0, 1)
    if (name === 'given') assert.ok(await page.evaluate(() => isShared()))
    await show(null)
  })

test('mounted and unmounted a thousand times, nothing is left', async (t) => {
  const cycle = (times) => page.evaluate((times) => window.cycle(times), times)
  // Until all code is compiled: until then the heap grows by a megabyte without a <Warp>, too.
  const { heap: before, ...counts } = await cycle(400)
  const { heap, ...countsAfter } = await cycle(1000)
  t.diagnostic(`heap ${before} before, ${heap} after; ${JSON.stringify(counts)}`)
  assert.deepEqual(countsAfter, counts)
  // A warp that stayed would be some ten kilobytes, and React mounts each twice.
  assert.ok(heap < before + 2e6, `the heap grew from ${before} to ${heap}`)
})
