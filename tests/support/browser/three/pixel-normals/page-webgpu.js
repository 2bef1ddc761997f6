// A page with WebGPURenderer, on both backends, that measures normals at pixels.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import 'warpjet/three/webgpu'
import { rendererFor } from '../webgpu-renderer.js'
import { measure } from './measure.js'
import {
  collapse,
  collapseWithMap,
  countDifferences,
  countFacetDifferences,
  drawWithMap,
  litScene,
  makeBumps,
  makeNormalMap,
  mapNames,
  summarize,
} from './pictures.js'
import { camera, size } from './scenes.js'
import { warps } from './warps.js'

const floatTarget = new THREE.RenderTarget(size, size, { type: THREE.FloatType })

/**
 * A target of bytes for transmission, which reads mipmaps of the background: WebGPU cannot filter those of floats. It is read in rows of
 * 256 bytes, which are 64 pixels.
 */
const byteTarget = new THREE.RenderTarget(64, 64, { type: THREE.UnsignedByteType })

/** Converts linear colours back to sRGB, since MeshNormalMaterial treats the normal as an sRGB colour and converts it to a linear one. */
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

async function makeHost(backend, target = floatTarget) {
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

/** Returns the max error of a material whose normalNode adds a vector to the normal: it must be added to the warped normal of the pixel. */
async function ownNode(backend, normals) {
  const { draw } = await makeHost(backend)
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
    const actual = new THREE.Vector3(...shown.slice(i, i + 3)).multiplyScalar(2).subScalar(1)
    worst = Math.max(worst, actual.distanceTo(expected))
  }
  return worst
}

/** Draws a reflection by MeshBasicMaterial, with normals at pixels and at vertices. Returns the number of pixels that differ. */
async function reflection(backend) {
  const { draw } = await makeHost(backend)
  const pictures = []
  for (const normals of ['vertex', 'pixel']) {
    const envMap = makeBumps()
    envMap.mapping = THREE.EquirectangularReflectionMapping
    const { scene, warped } = litScene(new THREE.MeshBasicMaterial({ envMap }), warps.simplex, {
      normals,
    })
    pictures.push(await draw(scene))
    warped.dispose()
  }
  return { differing: countDifferences(...pictures), ...summarize(pictures[1]) }
}

/**
 * Draws a mesh with morph targets and a warp in the space 'rest', whose normals stay at vertices. Returns the number of pixels that differ
 * from a picture with `normals: 'vertex'`.
 */
async function obstacle(backend, normals) {
  const { draw } = await makeHost(backend)
  const pictures = []
  for (const stage of ['vertex', normals]) {
    const material = makers.standard()
    const { scene, object, warped } = litScene(material, warps.simplex, {
      normals: stage,
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

/** Draws a mesh on a device that passes at most `limit` vectors to pixels. `channels` are the uvs that the textures of the material read. */
async function drawWithLimit(backend, limit, { channels = [], hasTangents = false }) {
  const { draw } = await makeHost(backend)
  const { backend: device } = await rendererFor(backend)
  const restore = limitVaryings(device, limit)
  const maps = channels.map((channel, i) => {
    const map = hasTangents && i === 0 ? makeNormalMap([0, 0, 1]) : makeBumps()
    map.channel = channel
    return [hasTangents && i === 0 ? 'normalMap' : ['map', 'roughnessMap', 'metalnessMap'][i], map]
  })
  const geometry = new THREE.SphereGeometry(1, 8, 6)
  for (const name of ['uv1', 'uv2']) geometry.setAttribute(name, geometry.attributes.uv)
  if (hasTangents) geometry.computeTangents()
  const material = makers.standard(Object.fromEntries(maps))
  const { scene, warped } = litScene(material, warps.simplex, { normals: 'pixel' }, geometry)
  try {
    await draw(scene)
  } finally {
    warped.dispose()
    restore()
  }
}

/** Lets a backend report another limit for vectors that pass to pixels. Returns a function that restores its own. */
function limitVaryings({ device, gl }, limit) {
  if (device) {
    Object.defineProperty(device, 'limits', {
      value: { maxInterStageShaderVariables: limit },
      configurable: true,
    })
    return () => delete device.limits
  }
  const getParameter = gl.getParameter.bind(gl)
  gl.getParameter = (name) => (name === gl.MAX_VARYING_VECTORS ? limit : getParameter(name))
  return () => delete gl.getParameter
}

window.pixels = {
  warps: Object.keys(warps),
  measure: async ({ backend, ...settings }) => measure(await makeHost(backend), settings),
  collapse: async (backend, name, settings) => collapse(await makeHost(backend), name, settings),
  collapseWithMap: async (backend, direction) =>
    collapseWithMap(await makeHost(backend), direction),
  drawWithLimit,
  countFacetDifferences: async (backend, name) =>
    countFacetDifferences(await makeHost(backend), name),
  mapNames,
  drawWithMap: async (backend, name) =>
    drawWithMap(await makeHost(backend, name === 'transmission' ? byteTarget : floatTarget), name),
  ownNode,
  reflection,
  obstacle,
  stage: () => warp(new THREE.Mesh(new THREE.SphereGeometry()), warps.simplex).normals,
}
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
