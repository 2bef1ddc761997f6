// A page with WebGPURenderer, on both its backends, that measures normals at pixels.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import 'warpjet/three/webgpu'
import { rendererFor } from '../webgpu-renderer.js'
import { measure } from './measure.js'
import {
  bumps,
  collapse,
  countDifferences,
  drawWithMap,
  facets,
  litScene,
  mapNames,
  summarize,
} from './pictures.js'
import { camera, size } from './scenes.js'
import { warps } from './warps.js'

const floats = new THREE.RenderTarget(size, size, { type: THREE.FloatType })

/** A target of bytes for transmission, which reads mipmaps of the background: WebGPU cannot filter those of floats. A row must have 256 bytes. */
const bytes = new THREE.RenderTarget(64, 64, { type: THREE.UnsignedByteType })

/** Converts linear colours back to sRGB: MeshNormalMaterial takes the normal for an sRGB colour and writes it linearly. */
const decode = (picture) =>
  picture.map((x, i) =>
    i % 4 === 3 ? x : x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055,
  )

function attributeMaterial(options) {
  const material = new THREE.MeshBasicNodeMaterial(options)
  material.fragmentNode = THREE.TSL.attribute('shownAttribute', 'vec4')
  return material
}

const makers = {
  normal: (options) => new THREE.MeshNormalMaterial(options),
  standard: (options) => new THREE.MeshStandardMaterial(options),
  physical: (options) => new THREE.MeshPhysicalMaterial(options),
}

async function hostFor(backend, target = floats) {
  const renderer = await rendererFor(backend)
  const draw = async (scene, view = camera()) => {
    renderer.setRenderTarget(target)
    renderer.setClearColor(0, 0)
    renderer.render(scene, view)
    renderer.setRenderTarget(null)
    return renderer.readRenderTargetPixelsAsync(target, 0, 0, target.width, target.height)
  }
  return { draw, decode, normalMaterial: makers.normal, attributeMaterial, makers }
}

/** A material whose own normalNode adds to the normal: it adds to that of the pixel. */
async function ownNode(backend, normals) {
  const { draw } = await hostFor(backend)
  const material = new THREE.MeshNormalNodeMaterial()
  const { normalView, vec3 } = THREE.TSL
  material.normalNode = normalView.add(vec3(0.3, 0, 0)).normalize()
  const { scene, warped } = litScene(material, warps.simplex, { normals })
  const shown = decode(await draw(scene))
  scene.children[1].material = makers.normal()
  const plain = decode(await draw(scene))
  warped.dispose()
  let worst = 0
  for (let i = 0; i < shown.length; i += 4) {
    if (!shown[i + 3]) continue
    const expected = new THREE.Vector3(...plain.slice(i, i + 3)).multiplyScalar(2).subScalar(1)
    expected
      .normalize()
      .add(new THREE.Vector3(0.3, 0, 0))
      .normalize()
    const found = new THREE.Vector3(...shown.slice(i, i + 3)).multiplyScalar(2).subScalar(1)
    worst = Math.max(worst, found.distanceTo(expected))
  }
  return worst
}

/** Draws a reflection by MeshBasicMaterial, with normals at pixels and at vertices → how many pixels differ. */
async function reflection(backend) {
  const { draw } = await hostFor(backend)
  const pictures = []
  for (const normals of ['vertex', 'pixel']) {
    const envMap = bumps()
    envMap.mapping = THREE.EquirectangularReflectionMapping
    const { scene, warped } = litScene(new THREE.MeshBasicMaterial({ envMap }), warps.simplex, {
      normals,
    })
    pictures.push(await draw(scene))
    warped.dispose()
  }
  return { differing: countDifferences(...pictures), ...summarize(pictures[1]) }
}

/** Draws a warp before skinning, whose normals stay those of vertices. */
async function obstacle(backend, normals) {
  const { draw } = await hostFor(backend)
  const pictures = []
  for (const each of ['vertex', normals]) {
    const material = makers.standard()
    const { scene, object, warped } = litScene(material, warps.simplex, {
      normals: each,
      space: 'rest',
    })
    object.geometry.morphAttributes.normal = [object.geometry.attributes.normal.clone()]
    object.geometry.morphAttributes.position = [object.geometry.attributes.position.clone()]
    object.geometry.morphTargetsRelative = true
    object.updateMorphTargets()
    pictures.push(await draw(scene))
    warped.dispose()
  }
  return countDifferences(...pictures)
}

window.pixels = {
  warps: Object.keys(warps),
  measure: async ({ backend, ...settings }) => measure(await hostFor(backend), settings),
  collapse: async (backend, name, settings) => collapse(await hostFor(backend), name, settings),
  facets: async (backend, name) => facets(await hostFor(backend), name),
  mapNames,
  drawWithMap: async (backend, name) =>
    drawWithMap(await hostFor(backend, name === 'transmission' ? bytes : floats), name),
  ownNode,
  reflection,
  obstacle,
  stage: () => warp(new THREE.Mesh(new THREE.SphereGeometry()), warps.simplex).normals,
}
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
