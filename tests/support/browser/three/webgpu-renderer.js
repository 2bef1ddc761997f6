// Makes a WebGPURenderer for each of its backends, and reads its pictures as bytes.
import * as THREE from 'three/webgpu'
import * as scenes from './scenes.js'

const { size } = scenes
const renderers = {}
let target

export async function rendererFor(backend) {
  if (renderers[backend]) return renderers[backend]
  const made = new THREE.WebGPURenderer({ antialias: false, forceWebGL: backend === 'webgl' })
  await made.init()
  if ((made.backend.isWebGPUBackend === true) !== (backend === 'webgpu'))
    throw new Error(`this browser has no ${backend}`)
  made.setSize(size, size)
  made.shadowMap.enabled = true
  document.body.append(made.domElement)
  return (renderers[backend] = made)
}

export async function draw(renderer, scene, camera = scenes.camera()) {
  target ??= new THREE.RenderTarget(size, size)
  renderer.setRenderTarget(target)
  renderer.render(scene, camera)
  renderer.setRenderTarget(null)
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
}
