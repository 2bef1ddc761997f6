// A page with two renderers: in one, compute passes divide meshes; in the other, the CPU does.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import 'warpjet/three/webgpu'
import { readDrawn } from './indirect.js'
import { camera, countBeyond, sceneOf, size, warpBy } from './pictures.js'
import { countOpenSides } from './sides.js'

/** Maps a renderer → its render target: two devices cannot share a texture. */
const targets = new Map()
const errors = []
/** The buffers of our passes that are not destroyed. */
const buffers = new Set()

function watchBuffers(device) {
  const { createBuffer } = device
  device.createBuffer = (settings) => {
    const buffer = createBuffer.call(device, settings)
    if (!settings.label?.startsWith('warpjet detail')) return buffer
    buffers.add(buffer)
    const { destroy } = buffer
    buffer.destroy = () => {
      buffers.delete(buffer)
      destroy.call(buffer)
    }
    return buffer
  }
}

async function makeRenderer() {
  const renderer = new THREE.WebGPURenderer({ antialias: false })
  await renderer.init()
  if (!renderer.backend.isWebGPUBackend) throw new Error('this browser has no WebGPU')
  renderer.setClearColor(0, 0)
  const { device } = renderer.backend
  device.addEventListener('uncapturederror', ({ error }) => errors.push(error.message))
  watchBuffers(device)
  targets.set(renderer, new THREE.RenderTarget(size, size))
  return renderer
}

const passRenderer = await makeRenderer()
const cpuRenderer = await makeRenderer()
// Without compute passes, the CPU divides meshes.
cpuRenderer.backend.device.createComputePipelineAsync = () =>
  Promise.reject(new Error('this renderer has no compute passes'))

function render(renderer, scene, view) {
  renderer.setRenderTarget(targets.get(renderer))
  renderer.render(scene, view)
  renderer.setRenderTarget(null)
}

const pictureOf = (renderer) =>
  renderer.readRenderTargetPixelsAsync(targets.get(renderer), 0, 0, size, size)

const wait = (time) => new Promise((resolve) => setTimeout(resolve, time))

/** Warps a mesh. Returns functions that draw it, and that return or read the geometry with which it was drawn last. */
function start(renderer, { shape, name, offset, uniforms, detail = 1, space, material }) {
  const { scene, mesh } = sceneOf(shape, { material })
  let drawn
  mesh.onBeforeRender = () => (drawn = mesh.geometry)
  const warped = offset
    ? warp(mesh, offset, { uniforms, detail, space })
    : warpBy(mesh, name, detail, { space })
  return {
    mesh,
    warped,
    drawn: () => drawn,
    read: () => readDrawn(renderer, drawn),
    async draw(view) {
      render(renderer, scene, view)
      return pictureOf(renderer)
    },
    /** Draws until compute passes divide the mesh. Returns the number of pictures. */
    async begin(view = camera()) {
      for (let i = 1; i < 1000; i++) {
        render(renderer, scene, view)
        if (drawn.indirect) return i
        await wait(100)
      }
      throw new Error(`compute passes did not begin: ${errors}`)
    },
  }
}

/** Returns cameras around the mesh, near and far. */
const makeCameras = (count) =>
  Array.from({ length: count }, (_, i) => {
    const view = camera()
    view.position.setFromSphericalCoords(1.7 + 3 * ((i * 0.382) % 1), 0.4 + 0.3 * i, 2.4 * i)
    view.lookAt(0, 0, 0)
    return view
  })

/** Draws the mesh until its buffers are large enough. For a few frames, the mesh of an earlier frame is drawn. */
async function drawOften(mesh, view) {
  for (let i = 0; i < 6; i++) {
    await mesh.draw(view)
    await wait(10)
  }
}

/** Counts the triangles whose vertices differ. */
function countDifferingTriangles(a, b) {
  let count = 0
  for (let i = 0; i < a.length; i += 3)
    if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) count++
  return count
}

/** Divides a mesh by passes and by the CPU, for the same views. Returns what differs in each view. */
async function divide({ frames = 6, ...options }) {
  const all = [start(passRenderer, options), start(cpuRenderer, options)]
  const [byPasses, byCpu] = all
  await byPasses.begin()
  await byCpu.draw(camera())
  const found = []
  for (const [i, view] of makeCameras(frames).entries()) {
    for (const { warped, mesh } of all) {
      warped.update(40 * i)
      if (options.space === 'world') mesh.rotation.z = i / 20
    }
    await drawOften(byPasses, view)
    const [picture, expectedPicture] = [await byPasses.draw(view), await byCpu.draw(view)]
    const { indices, numbers } = await byPasses.read()
    const { index, attributes, drawRange } = byCpu.drawn()
    const expected = index.array.subarray(0, drawRange.count)
    const isAsLong = indices.length === expected.length
    const positions = attributes.position.array
    found.push({
      triangles: indices.length / 3,
      expected: expected.length / 3,
      differing: isAsLong ? countDifferingTriangles(indices, expected) : undefined,
      farthest: isAsLong && numbers.reduce((a, x, k) => Math.max(a, Math.abs(x - positions[k])), 0),
      openSides: countOpenSides(indices, numbers),
      beyond: countBeyond(picture, expectedPicture),
    })
  }
  for (const { warped } of all) warped.dispose()
  return { found, errors: errors.splice(0) }
}

/** Moves the camera close to a mesh that was small, so that the buffers have to grow. Compares the pictures with those by the CPU. */
async function approach(options) {
  const all = [start(passRenderer, options), start(cpuRenderer, options)]
  const [byPasses, byCpu] = all
  const [far, near] = [camera(), camera()]
  far.position.setLength(20)
  await byPasses.begin(far)
  const before = await byPasses.read()
  const first = byPasses.drawn()
  const pictures = []
  for (let i = 0; i < 6; i++) {
    pictures.push(await byPasses.draw(near))
    await wait(10)
  }
  const expected = await byCpu.draw(near)
  const { indices } = await byPasses.read()
  const isSame = byPasses.drawn() === first
  for (const { warped } of all) warped.dispose()
  return {
    ...{ before: before.indices.length / 3, after: indices.length / 3, isSame },
    beyond: pictures.map((picture) => countBeyond(picture, expected)),
    errors: errors.splice(0),
  }
}

/** Makes waves along x shorter, so that the mesh must be cut anew. */
async function refine() {
  const offset = ({ glsl, position, uniforms }) =>
    glsl.vec3(0, position.x().mult(uniforms.waves).sin().mult(0.1), 0)
  const options = { shape: 'box', offset, uniforms: { waves: 4 } }
  const all = [start(passRenderer, options), start(cpuRenderer, options)]
  await all[0].begin()
  await all[1].draw(camera())
  for (const { warped } of all) warped.uniforms.waves.value = 60
  const picture = await all[0].draw(camera())
  const expected = await all[1].draw(camera())
  await all[0].begin()
  const later = await all[0].draw(camera())
  const { indices } = await all[0].read()
  for (const { warped } of all) warped.dispose()
  return {
    triangles: indices.length / 3,
    beyond: [picture, later].map((each) => countBeyond(each, expected)),
    errors: errors.splice(0),
  }
}

/** Draws with two cameras in turn, on a larger target, as a wireframe, and with groups. Counts triangles and buffers. */
async function countOverTime() {
  const before = buffers.size
  const material = new THREE.MeshNormalMaterial()
  const started = start(passRenderer, { shape: 'box', name: 'twist', material })
  await started.begin()
  const [near, far] = [camera(), camera()]
  near.position.setLength(2)
  far.position.setLength(30)
  const triangles = async () => (await started.read()).indices.length / 3
  const counts = { held: buffers.size - before, pairs: [] }
  // The first picture starts from the pieces that the CPU chose, and its buffers may be too small.
  await drawOften(started, near)
  await started.draw(far)
  for (let i = 0; i < 2; i++)
    for (const view of [near, far]) {
      await started.draw(view)
      counts.pairs.push(await triangles())
    }
  const target = targets.get(passRenderer)
  target.setSize(4 * size, 4 * size)
  await drawOften(started, near)
  counts.large = await triangles()
  target.setSize(size, size)
  material.wireframe = true
  await started.draw(near)
  counts.isIndirectAsLines = started.drawn().indirect !== null
  material.wireframe = false
  await started.draw(near)
  counts.isIndirectAgain = started.drawn().indirect !== null
  started.mesh.material = [material]
  started.mesh.geometry.clearGroups()
  started.mesh.geometry.addGroup(0, 36, 0)
  await started.draw(near)
  counts.isIndirectByGroups = started.drawn().indirect !== null
  started.warped.dispose()
  const options = { tolerance: 1, curved: true }
  const curved = start(passRenderer, { shape: 'sphere', name: 'twist', detail: options })
  for (let i = 0; i < 10; i++) {
    await curved.draw(near)
    await wait(10)
  }
  counts.isIndirectIfCurved = curved.drawn().indirect !== null
  curved.warped.dispose()
  await wait(20)
  // The buffer of tessellations remains for other meshes.
  counts.left = buffers.size - before
  return { counts, errors: errors.splice(0) }
}

globalThis.compute = { divide, approach, refine, countOverTime }
document.title = 'ready'
