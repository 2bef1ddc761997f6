// A page on which compute passes divide meshes, beside a renderer that leaves it to the CPU.
import * as THREE from 'three/webgpu'
import 'warpjet/three/webgpu'
import { camera, countBeyond, countHoles, sceneOf, size, warpBy } from './pictures.js'

/** Maps a renderer → its target: a texture cannot belong to two devices. */
const targets = new Map()

async function makeRenderer() {
  const renderer = new THREE.WebGPURenderer({ antialias: false })
  await renderer.init()
  if (!renderer.backend.isWebGPUBackend) throw new Error('this browser has no WebGPU')
  renderer.setSize(size, size)
  renderer.setClearColor(0, 0)
  renderer.shadowMap.enabled = true
  targets.set(renderer, new THREE.RenderTarget(size, size))
  return renderer
}

const renderers = { passes: await makeRenderer(), cpu: await makeRenderer() }
const errors = []
for (const { backend } of Object.values(renderers))
  backend.device.addEventListener('uncapturederror', ({ error }) => errors.push(error.message))
const { device } = renderers.cpu.backend
device.createComputePipelineAsync = () => Promise.reject(new Error('left to the CPU'))

function render(renderer, scene, view) {
  renderer.setRenderTarget(targets.get(renderer))
  renderer.render(scene, view)
  renderer.setRenderTarget(null)
}

async function draw(renderer, scene, view) {
  render(renderer, scene, view)
  return renderer.readRenderTargetPixelsAsync(targets.get(renderer), 0, 0, size, size)
}

/** Warps a mesh → { draw(view) → picture, geometry(), update(), dispose() } with the geometry that was drawn last. */
function start(renderer, { shape, name, ...options }) {
  const { scene, mesh } = sceneOf(shape, options)
  let geometry
  mesh.onBeforeRender = () => (geometry = mesh.geometry)
  const warped = warpBy(mesh, name, 1, { space: options.space })
  return {
    scene,
    mesh,
    warped,
    geometry: () => geometry,
    draw: (view) => draw(renderer, scene, view),
  }
}

/** Draws until compute passes divide the mesh. */
async function untilComputed(started, view = camera()) {
  for (let i = 0; i < 600; i++) {
    await started.draw(view)
    if (started.geometry().indirect) return i
    await new Promise((resolve) => setTimeout(resolve, 20))
  }
  throw new Error(`compute passes did not begin: ${errors}`)
}

async function read(attribute, Numbers, bytes) {
  const { backend } = renderers.passes
  const { buffer } = backend.get(attribute)
  const size = bytes ?? buffer.size
  const copy = backend.device.createBuffer({ size, usage: 9 })
  const encoder = backend.device.createCommandEncoder()
  encoder.copyBufferToBuffer(buffer, 0, copy, 0, size)
  backend.device.queue.submit([encoder.finish()])
  await copy.mapAsync(1)
  const numbers = new Numbers(copy.getMappedRange().slice())
  copy.destroy()
  return numbers
}

/** Reads what compute passes wrote → { indices, vertices }, with the numbers of an attribute. */
async function written(geometry, name = 'position') {
  const [count] = await read(geometry.indirect, Uint32Array)
  const indices = await read(geometry.index, Uint32Array, 4 * count)
  const { data, offset, itemSize } = geometry.attributes[name]
  const all = await read(data, Float32Array)
  const vertices = indices.reduce((a, b) => Math.max(a, b), 0) + 1
  const numbers = []
  for (let i = 0; i < vertices; i++)
    for (let k = 0; k < itemSize; k++) numbers.push(all[data.stride * i + offset + k])
  return { indices, numbers }
}

/** Cameras around the mesh, near and far. */
function cameras(count) {
  return Array.from({ length: count }, (_, i) => {
    const view = camera()
    view.position.setFromSphericalCoords(1.6 + 3 * ((i * 0.382) % 1), 0.4 + 0.3 * i, 2.4 * i)
    view.lookAt(0, 0, 0)
    return view
  })
}

/** Divides by passes and by the CPU for the same cameras → for each the numbers of triangles, and what differs. */
async function divide({ frames = 6, ...options }) {
  const byPasses = start(renderers.passes, options)
  const byCpu = start(renderers.cpu, options)
  const waited = await untilComputed(byPasses)
  await byCpu.draw(camera())
  const found = []
  let frame = 0
  for (const view of cameras(frames)) {
    for (const { warped, mesh } of [byPasses, byCpu]) {
      warped.update(40 * frame)
      mesh.rotation.z = options.space === 'world' ? frame / 20 : 0
    }
    frame++
    const picture = await byPasses.draw(view)
    const expected = await byCpu.draw(view)
    const { indices, numbers } = await written(byPasses.geometry())
    const { index, attributes, drawRange } = byCpu.geometry()
    const expectedIndices = index.array.subarray(0, drawRange.count)
    let farthest = 0
    numbers.forEach((x, i) => {
      farthest = Math.max(farthest, Math.abs(x - attributes.position.array[i]))
    })
    found.push({
      triangles: indices.length / 3,
      expected: expectedIndices.length / 3,
      isEqual: indices.length === expectedIndices.length && indices.every((x, i) => x === expectedIndices[i]),
      farthest,
      beyond: countBeyond(picture, expected),
    })
  }
  byPasses.warped.dispose()
  byCpu.warped.dispose()
  return { waited, found, errors: errors.splice(0) }
}

globalThis.compute = { divide }
void countHoles
void THREE
document.title = 'ready'
