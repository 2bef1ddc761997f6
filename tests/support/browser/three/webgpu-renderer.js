// Makes a WebGPURenderer for each of its backends, and draws pictures as bytes.
import * as THREE from 'three/webgpu'
import * as scenes from './scenes.js'

const { size } = scenes
const renderers = {}
let target

/** Returns the renderer for a backend. Without `hasPasses`, the option `detail` cannot create its compute passes, as on some devices. */
export async function rendererFor(backend, { hasPasses = true } = {}) {
  const key = `${backend} ${hasPasses}`
  if (renderers[key]) return renderers[key]
  const made = new THREE.WebGPURenderer({ antialias: false, forceWebGL: backend === 'webgl' })
  await made.init()
  if ((made.backend.isWebGPUBackend === true) !== (backend === 'webgpu'))
    throw new Error(`this browser has no ${backend}`)
  made.setSize(size, size)
  made.shadowMap.enabled = true
  document.body.append(made.domElement)
  if (backend === 'webgpu' && !hasPasses)
    made.backend.device.createComputePipelineAsync = () => Promise.reject(new Error('none'))
  return (renderers[key] = made)
}

export async function draw(renderer, scene, camera = scenes.camera()) {
  target ??= new THREE.RenderTarget(size, size)
  renderer.setRenderTarget(target)
  renderer.render(scene, camera)
  renderer.setRenderTarget(null)
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
}
