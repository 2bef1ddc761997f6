// Measures two of three's example scenes, with their own normals and with those of `exactNormals`, for `npm run bench -- nodes`.
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'
import { countHeights } from './heights.js'
import { showcases } from './showcases.js'

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

/** Maps the modes → the option `normals`; `undefined` for a showcase without `exactNormals`. */
const modes = { original: undefined, 'exactNormals, vertex': 'vertex', exactNormals: 'auto' }

/** Makes a showcase and its camera. `salt` changes the shader code, so that no cache contains its program. */
function makeShowcase(name, mode, { pieces, salt = 0 }) {
  const { geometry, parameters, material: make } = showcases[name]
  const material = make(parameters(), modes[mode] === undefined)
  material.positionNode = material.positionNode.add(THREE.TSL.vec3(0, salt, 0))
  material.roughnessNode = THREE.TSL.float(material.roughness + salt)
  if (modes[mode]) exactNormals(material, { normals: modes[mode] })
  const scene = new THREE.Scene()
  const mesh = new THREE.Mesh(geometry(pieces), material)
  scene.add(mesh, new THREE.DirectionalLight(0xffffff, 3))
  const size = name === 'sea' ? 2 : 10
  const camera = new THREE.PerspectiveCamera(50, 1, 0.01, 100)
  camera.position.set(0.6 * size, 0.5 * size, 0.6 * size)
  camera.lookAt(0, 0, 0)
  return { scene, camera, mesh }
}

let renderer, target

/** Starts the renderer and draws a mesh, so that later measurements exclude what three.js and the browser do only once. */
async function open(backend, side) {
  renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: backend === 'webgl' })
  await renderer.init()
  if ((renderer.backend.isWebGPUBackend === true) !== (backend === 'webgpu'))
    throw new Error(`this browser has no ${backend}`)
  target = new THREE.RenderTarget(side, side)
  const scene = new THREE.Scene()
  scene.add(new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardNodeMaterial()))
  scene.add(new THREE.DirectionalLight())
  await draw({ scene, camera: new THREE.PerspectiveCamera() }, 1)
}

/** Draws some frames, waits for a pixel of the last, and returns milliseconds per frame. */
async function draw({ scene, camera }, count) {
  const start = performance.now()
  renderer.setRenderTarget(target)
  for (let i = 0; i < count; i++) renderer.render(scene, camera)
  renderer.setRenderTarget(null)
  if (renderer.backend.isWebGPUBackend)
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, 1, 1)
  else readPixel()
  return (performance.now() - start) / count
}

let framebuffer

/** Reads a pixel on WebGL immediately: three.js would only deliver it in the next animation frame. */
function readPixel() {
  const { gl, state } = renderer.backend
  const { textureGPU } = renderer.backend.get(target.texture)
  framebuffer ??= gl.createFramebuffer()
  state.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer)
  gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textureGPU, 0)
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
  state.bindFramebuffer(gl.READ_FRAMEBUFFER, null)
  const error = gl.getError()
  if (error) throw new Error(`reading a pixel: WebGL reports the error ${error}`)
}

/** Returns the milliseconds of the first frame, including the call of `exactNormals`, in a page that has not drawn a showcase yet. */
async function first(name, mode, options) {
  const start = performance.now()
  const showcase = makeShowcase(name, mode, options)
  await draw(showcase, 1)
  return performance.now() - start
}

/** Measures frames of all modes in turn, in batches of `batch` milliseconds or more. Returns rows. */
async function frames(name, { pieces, batch, rounds }) {
  const measured = []
  for (const mode of Object.keys(modes)) {
    const showcase = makeShowcase(name, mode, { pieces })
    await draw(showcase, 1)
    const { vertexShader, fragmentShader } = await getShaders(showcase)
    const count = Math.ceil(Math.min(1000, batch / (await draw(showcase, 1))))
    const heights = `${countHeights(vertexShader)} + ${countHeights(fragmentShader)}`
    const characters = `${vertexShader.length} + ${fragmentShader.length}`
    measured.push({ mode, showcase, count, heights, characters, times: [] })
  }
  for (let i = 0; i < rounds; i++)
    for (const { showcase, count, times } of measured) times.push(await draw(showcase, count))
  return measured.map(({ mode, heights, characters, times }) => ({
    mode,
    frame: median(times),
    ratio: median(times.map((time, i) => time / measured[0].times[i])),
    heights,
    characters,
  }))
}

async function getShaders({ scene, camera, mesh }) {
  renderer.setRenderTarget(target)
  const shaders = await renderer.debug.getShaderAsync(scene, camera, mesh)
  renderer.setRenderTarget(null)
  return shaders
}

window.bench = { modes: Object.keys(modes), open, first, frames }
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
