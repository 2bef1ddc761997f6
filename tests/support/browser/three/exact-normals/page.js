// A page with WebGPURenderer, on both its backends, that measures the normals of `exactNormals` at pixels.
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'
import { degreesBetween, exactVertex, quantile } from '../pixel-normals/exact.js'
import { camera, objectFor, parts, seenOf, size } from '../pixel-normals/scenes.js'
import { rendererFor } from '../webgpu-renderer.js'
import { displacements } from './displacements.js'

const target = new THREE.RenderTarget(size, size, { type: THREE.FloatType })

/** MeshNormalMaterial takes its colours for sRGB, and writes linear ones. */
const decode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)

async function draw(renderer, object, view) {
  const scene = new THREE.Scene()
  scene.add(object)
  renderer.setRenderTarget(target)
  renderer.setClearColor(0, 0)
  renderer.render(scene, view)
  renderer.setRenderTarget(null)
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
}

/** How the normal and the uv of a shape vary over it: the gradients of normal x, y and z and of u and v. */
const gradientsOf = {
  plane: () => [
    [0, 0, 0],
    [0, 0, 0],
    [0, 0, 0],
    [0.5, 0, 0],
    [0, 0.5, 0],
  ],
  sphere: (p) => {
    const tangential = [0, 1, 2].map((k) => [0, 1, 2].map((i) => Number(i === k) - p[i] * p[k]))
    return [...tangential, [0, 0, 0], [0, 0, 0]]
  },
}

/** Compares shown normals with exact ones → degrees, by quantiles. */
async function measure(name, { backend, normals = 'pixel', isExact = true }) {
  const { shape, kind = 'plain', position, move, prepare } = displacements[name]
  const renderer = await rendererFor(backend)
  const material = new THREE.MeshNormalNodeMaterial()
  material.positionNode = position()
  if (isExact) exactNormals(material, { normals })
  const { object, geometry } = objectFor(kind, shape, material)
  prepare?.(object)
  const view = camera()
  const shown = await draw(renderer, object, view)
  const seen = {}
  object.material = new THREE.MeshBasicNodeMaterial()
  object.material.positionNode = material.positionNode
  object.material.fragmentNode = THREE.TSL.attribute('seen', 'vec4')
  for (const part of parts.slice(0, 3)) {
    object.geometry.setAttribute('seen', new THREE.BufferAttribute(seenOf(kind, geometry, part), 4))
    seen[part] = await draw(renderer, object, view)
  }
  const normalMatrix = new THREE.Matrix3().getNormalMatrix(object.matrixWorld)
  const angles = []
  let skipped = 0
  for (let i = 0; i < 4 * size * size; i += 4) {
    if (shown[i + 3] === 0 || seen.position[i + 3] === 0) continue
    const at = (part, count) => Array.from(seen[part].slice(i, i + count))
    const p = at('position', 3)
    const [x, y, z, length] = at('normal', 4)
    const normal = [x, y, z].map((k) => (k * length) / Math.hypot(x, y, z))
    const vertex = { position: p, normal, uv: at('uv', 2), gradients: gradientsOf[shape](p) }
    const exact = exactVertex(move, vertex)
    if (!exact) {
      skipped++
      continue
    }
    const expected = new THREE.Vector3(...exact.normal).applyNormalMatrix(normalMatrix)
    const colour = [0, 1, 2].map((k) => 2 * decode(shown[i + k]) - 1)
    angles.push(degreesBetween(colour, expected.toArray()))
  }
  return {
    covered: angles.length + skipped,
    skipped,
    median: quantile(angles, 0.5),
    most: quantile(angles, 0.999),
    finite: angles.every(Number.isFinite),
  }
}

window.exact = { names: Object.keys(displacements), measure }
// Without somebody who holds it, the browser loses the device.
window.gpu = navigator.gpu
document.title = 'ready'
