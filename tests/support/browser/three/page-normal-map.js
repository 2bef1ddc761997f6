// A page that draws GLB files by three.js.
import * as THREE from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const size = 600

const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
renderer.setSize(size, size)
document.body.append(renderer.domElement)

const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 20)
camera.position.set(1, 1.5, 4)
camera.lookAt(0, 0, 0)

/** Returns the pixels, with an alpha of 0 where nothing is drawn. `change(mesh)` is called before. */
async function draw(glb, change = () => {}) {
  const { buffer } = Uint8Array.fromBase64(glb)
  const { scene } = await new GLTFLoader().parseAsync(buffer, '')
  change(scene.getObjectByProperty('isMesh', true))
  const light = new THREE.DirectionalLight(0xffffff, 2)
  light.position.set(3, 2, 2)
  scene.add(light, new THREE.HemisphereLight(0xffffff, 0x808080, 1))
  renderer.setClearColor(0, 0)
  renderer.render(scene, camera)
  const gl = renderer.getContext()
  const pixels = new Uint8Array(4 * size * size)
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
  return pixels
}

/** Compares the pixels that both cover → the number of them, and for each difference the number of pixels with it. */
function differences(a, b) {
  const counts = Array(256).fill(0)
  let covered = 0
  for (let i = 0; i < a.length; i += 4) {
    if (!a[i + 3] || !b[i + 3]) continue
    covered++
    counts[Math.max(...[0, 1, 2].map((k) => Math.abs(a[i + k] - b[i + k])))]++
  }
  return { covered, counts }
}

const changes = {
  /** Makes three.js find its own frames, by derivatives on the screen, as it does for files without tangents. */
  'no tangents': ({ geometry, material }) => {
    geometry.deleteAttribute('tangent')
    material.normalScale.y *= -1
  },
  'green down': ({ material }) => {
    material.normalScale.y *= -1
  },
}

globalThis.three = {
  compare: async (glb, reference, change) =>
    differences(await draw(glb, changes[change]), await draw(reference)),
}
document.title = 'ready'
