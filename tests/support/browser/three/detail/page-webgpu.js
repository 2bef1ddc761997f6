// A page with WebGPURenderer, on both its backends, that draws with the option `detail`.
import * as THREE from 'three/webgpu'
import 'warpjet/three/webgpu'
import { rendererFor } from '../webgpu-renderer.js'
import * as checks from './checks.js'
import { size } from './pictures.js'

const target = new THREE.RenderTarget(size, size)

async function hostFor(backend) {
  const renderer = await rendererFor(backend)
  renderer.setClearColor(0, 0)
  // Each animation frame would reset the counts, too.
  renderer.info.autoReset = false
  return {
    async draw(scene, view) {
      renderer.setRenderTarget(target)
      renderer.info.reset()
      try {
        renderer.render(scene, view)
      } finally {
        renderer.setRenderTarget(null)
      }
      return renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
    },
    triangles: () => renderer.info.render.triangles,
    geometries: () => renderer.info.memory.geometries,
  }
}

globalThis.detail = Object.fromEntries(
  Object.entries(checks).map(([name, check]) => [
    name,
    async ({ backend, ...settings }) => check(await hostFor(backend), settings),
  ]),
)
document.title = 'ready'
