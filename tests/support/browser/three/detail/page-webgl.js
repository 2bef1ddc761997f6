// A page that draws with the option `detail` by WebGLRenderer.
import * as THREE from 'three'
import * as checks from './checks.js'
import { camera, sceneOf, size, warpBy } from './pictures.js'

const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
renderer.setSize(size, size)
renderer.setClearColor(0, 0)
renderer.shadowMap.enabled = true
document.body.append(renderer.domElement)
const target = new THREE.WebGLRenderTarget(size, size)

const host = {
  async draw(scene, view) {
    renderer.setRenderTarget(target)
    renderer.render(scene, view)
    renderer.setRenderTarget(null)
    const bytes = new Uint8Array(4 * size * size)
    renderer.readRenderTargetPixels(target, 0, 0, size, size, bytes)
    return bytes
  },
  triangles: () => renderer.info.render.triangles,
  geometries: () => renderer.info.memory.geometries,
}

/** Counts the triangles on canvases of several sizes, while a second renderer draws in between. */
function countOnCanvases(sizes) {
  const { scene, mesh } = sceneOf('box')
  const warped = warpBy(mesh, 'twist', 1)
  const second = new THREE.WebGLRenderer()
  second.setSize(64, 64)
  const counts = sizes.map((size) => {
    renderer.setSize(size, size)
    renderer.render(scene, camera())
    const { triangles } = renderer.info.render
    second.render(scene, camera())
    return [triangles, second.info.render.triangles]
  })
  renderer.setSize(size, size)
  warped.dispose()
  second.dispose()
  return counts
}

/** Shows a twisted box on the canvas, for screenshots. */
function show(detail) {
  const { scene, mesh } = sceneOf('box', { hasShadow: true })
  warpBy(mesh, 'twist', detail)
  renderer.setSize(512, 512)
  renderer.render(scene, camera())
  return renderer.info.render.triangles
}

globalThis.detail = {
  ...Object.fromEntries(
    Object.entries(checks).map(([name, check]) => [
      name,
      (settings) => check(host, settings ?? {}),
    ]),
  ),
  countOnCanvases,
  show,
}
document.title = 'ready'
