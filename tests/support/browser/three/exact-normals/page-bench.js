// Measures frame times of two of three's showcases with normals by hand and by `exactNormals`, for `npm run bench -- nodes`.
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'
import { rendererFor } from '../webgpu-renderer.js'
import { showcases } from './showcases.js'

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

function sceneOf(name, kind) {
  const { geometry, parameters, material: make } = showcases[name]
  const material = make(parameters(), kind === 'by hand')
  if (kind.startsWith('exact')) exactNormals(material, { normals: kind.split(' ')[1] })
  const scene = new THREE.Scene()
  scene.add(new THREE.Mesh(geometry(), material), new THREE.DirectionalLight(0xffffff, 3))
  const size = name === 'sea' ? 2 : 10
  const camera = new THREE.PerspectiveCamera(50, 1, 0.01, 100)
  camera.position.set(0.6 * size, 0.5 * size, 0.6 * size)
  camera.lookAt(0, 0, 0)
  return { scene, camera }
}

/** Draws frames of the kinds in turn → the medians in milliseconds, `side` pixels square. */
async function measure(name, backend, side, frames) {
  const renderer = await rendererFor(backend)
  const target = new THREE.RenderTarget(side, side)
  const kinds = ['by hand', 'exact vertex', 'exact pixel']
  // Waits for a pixel, so that the frame is drawn.
  const draw = async ({ scene, camera }) => {
    const start = performance.now()
    renderer.setRenderTarget(target)
    renderer.render(scene, camera)
    renderer.setRenderTarget(null)
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, 1, 1)
    return performance.now() - start
  }
  const firsts = Object.fromEntries(kinds.map((kind) => [kind, []]))
  const times = Object.fromEntries(kinds.map((kind) => [kind, []]))
  // The first round also starts the compiler.
  for (let round = 0; round < 4; round++) {
    const scenes = kinds.map((kind) => [kind, sceneOf(name, kind)])
    for (const [kind, scene] of scenes) {
      const first = await draw(scene)
      if (round > 0) firsts[kind].push(first)
    }
    for (let i = 0; i < frames; i++)
      for (const [kind, scene] of scenes) times[kind].push(await draw(scene))
  }
  return kinds.map((kind) => ({
    kind,
    frame: median(times[kind]),
    ratio: median(times[kind]) / median(times['by hand']),
    first: median(firsts[kind]),
    firstMore: median(firsts[kind]) - median(firsts['by hand']),
  }))
}

window.bench = { measure }
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
