// `<Warp>` of 'warpjet/react' in a page with @react-three/fiber: around a mesh and inside one, with changing values and offsets, and
// without leaks after it is unmounted.
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
import { measureHeap } from '../../tests/support/browser/three/heap.js'

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
/**
 * Stores react-three-fiber's state. Its invisible mesh keeps the program for unwarped meshes, which would otherwise be recompiled each
 * time.
 */
const Spy = () => {
  useFrame((current) => (state = current))
  return e('mesh', { scale: 0, frustumCulled: false }, e('sphereGeometry'), e('meshBasicMaterial'))
}

const offsets = {
  right: ({ glsl, uniforms }) => glsl.vec3(uniforms.amount, 0, 0),
  up: ({ glsl, uniforms }) => glsl.vec3(0, uniforms.amount, 0),
  clock: ({ glsl, millis }) => glsl.vec3(0, 0, millis.mult(0)),
}

const ball = (...more) =>
  e('mesh', {}, e('sphereGeometry', { args: [0.3, 16, 12] }), e('meshBasicMaterial', { color: 'white' }), ...more)

/** A material that is passed to a mesh as a property. */
const passedMaterial = new THREE.MeshBasicMaterial()

const pages = {
  plain: () => ball(),
  in: ({ offset = 'right', amount = 0 }) => ball(e(Warp, { offset: offsets[offset], uniforms: { amount } })),
  around: ({ offset = 'right', amount = 0 }) =>
    e(Warp, { offset: offsets[offset], uniforms: { amount } }, ball()),
  'with a passed material': ({ amount = 0 }) =>
    e('mesh', { material: passedMaterial }, e('sphereGeometry', { args: [0.3, 16, 12] }), e(Warp, { offset: offsets.right, uniforms: { amount } })),
}

const late = { promise: null, done: false }
const Late = () => {
  if (!late.done) throw (late.promise ??= new Promise((resolve) => setTimeout(() => resolve((late.done = true)), 50)))
  return null
}
pages.suspended = ({ amount = 0 }) =>
  e(Suspense, { fallback: null }, e(Warp, { offset: offsets.right, uniforms: { amount } }, ball(), e(Late)))

/** Renders a page. Returns the centre of the bright pixels, from -1 to 1, and their number. */
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

/**
 * Mounts and unmounts the warp repeatedly; draws every tenth time, which compiles the shaders. Returns three's counts of resources and the
 * size of the heap.
 */
window.cycle = async (times) => {
  for (let i = 0; i < times; i++) {
    if (i % 10 === 0) await show('around', { amount: i / times })
    else await act(async () => root.render(e(StrictMode, null, e(Spy), e(pages.around, { amount: i / times }))))
    await show('plain')
  }
  const heap = await measureHeap()
  const { memory, programs } = state.gl.info
  return { ...memory, programs: programs.length, heap }
}
window.isMaterialUnchanged = () => !Object.hasOwn(passedMaterial, 'onBeforeCompile')
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

/** Half the height of the camera's view at the distance of the ball. */
const half = 3 * Math.tan((75 / 2) * (Math.PI / 180))

for (const name of ['in', 'around', 'with a passed material', 'suspended'])
  test(`${name}: the ball follows the offset, a new uniform value, and another offset`, async () => {
    const assertBallAt = async (props, x, y) => {
      const first = await show(name, props)
      // A suspended component appears only after its promise has resolved.
      const shown = Number.isNaN(first.x)
        ? (await page.waitForTimeout(200), await show(name, props))
        : first
      assert.ok(
        Math.abs(shown.x - x / half) < 0.02 && Math.abs(shown.y - y / half) < 0.02,
        JSON.stringify(shown),
      )
      assert.ok(shown.count > 50)
    }
    await assertBallAt({ amount: 0 }, 0, 0)
    await assertBallAt({ amount: 1 }, 1, 0)
    if (name === 'in' || name === 'around') await assertBallAt({ amount: 1, offset: 'up' }, 0, 1)
    if (name === 'with a passed material')
      assert.ok(await page.evaluate(() => isMaterialUnchanged()))
    await show(null)
  })

test('mounting and unmounting a thousand times leaks nothing', async (t) => {
  const cycle = (times) => page.evaluate((times) => window.cycle(times), times)
  // The first cycles compile all code, so that the heap grows by a megabyte even without a <Warp>.
  const { heap: before, ...counts } = await cycle(400)
  const { heap, ...countsAfter } = await cycle(1000)
  t.diagnostic(`heap ${before} before, ${heap} after; ${JSON.stringify(counts)}`)
  assert.deepEqual(countsAfter, counts)
  // A leaked warp would take about 10 KB, and React's StrictMode mounts each twice.
  assert.ok(heap < before + 2e6, `the heap grew from ${before} to ${heap}`)
})
