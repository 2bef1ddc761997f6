// A page with WebGPURenderer, on both backends, that measures the errors of normals at pixels that `exactNormals` computes.
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'
import { degreesBetween, exactVertex, quantile } from '../pixel-normals/exact.js'
import { attributeNames, camera, makeObject, readUnwarped, size } from '../pixel-normals/scenes.js'
import { rendererFor } from '../webgpu-renderer.js'
import { displacements, unsupported } from './displacements.js'
import { countHeights } from './heights.js'
import { longLoops, manyStates } from './long-loops.js'
import { showcases } from './showcases.js'
import { varyings } from './varyings.js'
import { warpBeside } from './warp-beside.js'

const { Fn, attribute, normalGeometry, normalLocal, positionGeometry, positionLocal } = THREE.TSL
const { varyingProperty, vec4 } = THREE.TSL

/** The targets of each renderer. They are not shared: on WebGL, a target that another renderer has drawn to stays empty. */
const targets = new Map()

function getTarget(renderer, side) {
  const key = `${renderer.backend.isWebGPUBackend} ${side}`
  if (!targets.has(key))
    targets.set(key, new THREE.RenderTarget(side, side, { type: THREE.FloatType }))
  return targets.get(key)
}

/** Draws a scene. Returns its picture, four floats per pixel. */
async function takePicture(renderer, scene, view, side = size) {
  const target = getTarget(renderer, side)
  renderer.setRenderTarget(target)
  renderer.setClearColor(0, 0)
  renderer.render(scene, view)
  renderer.setRenderTarget(null)
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, side, side)
}

/** Converts a linear colour back to sRGB, since MeshNormalMaterial treats the normal as an sRGB colour and converts it to a linear one. */
const decode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)

function draw(renderer, object, view) {
  const scene = new THREE.Scene()
  scene.add(object)
  return takePicture(renderer, scene, view)
}

/** Draws a case, with `exactNormals` if `isExact`. Returns the picture `shown`, and the objects that were drawn. */
async function drawCase(
  { kind = 'plain', shape, first, position, prepare },
  { backend, normals = 'pixel', isExact = true, maxIterations },
) {
  const renderer = await rendererFor(backend)
  const material = new THREE.MeshNormalNodeMaterial()
  material.positionNode = (first ?? position)()
  if (isExact) exactNormals(material, { normals, ...(maxIterations && { maxIterations }) })
  const { object, geometry } = makeObject(kind, shape, material)
  prepare?.(object)
  const view = camera()
  if (first) {
    await draw(renderer, object, view)
    material.positionNode = position()
    material.needsUpdate = true
  }
  const shown = await draw(renderer, object, view)
  return { renderer, material, object, geometry, view, shown }
}

/** Compares the drawn normals of a displacement with exact ones. Returns quantiles of their angles, in degrees. */
async function measure(name, settings) {
  const { iterations } = settings
  const displacement = iterations
    ? { ...manyStates, move: manyStates.moveAfter(iterations) }
    : (displacements[name] ?? longLoops[name])
  const { move, ignoresPose } = displacement
  const { renderer, material, object, geometry, view, shown } = await drawCase(
    displacement,
    settings,
  )
  const seen = {}
  const nodes = withVaryings(material.positionNode, ignoresPose)
  object.material = new THREE.MeshBasicNodeMaterial()
  object.material.positionNode = nodes.positionNode
  for (const attributeName of attributeNames) {
    if (attributeName === 'tangent') continue
    object.material.fragmentNode = nodes[attributeName] ?? attribute('seen', 'vec4')
    object.material.needsUpdate = true
    const numbers = readUnwarped('plain', geometry, attributeName)
    object.geometry.setAttribute('seen', new THREE.BufferAttribute(numbers, 4))
    seen[attributeName] = await draw(renderer, object, view)
  }
  const { matrixWorld } = object
  const normalMatrix = new THREE.Matrix3().getNormalMatrix(matrixWorld)
  const angles = []
  let [skipped, moved] = [0, 0]
  for (let i = 0; i < 4 * size * size; i += 4) {
    if ((shown[i + 3] === 0) !== (seen.position[i + 3] === 0)) moved++
    if (shown[i + 3] === 0 || seen.position[i + 3] === 0) continue
    const read = (attributeName, count) => Array.from(seen[attributeName].slice(i, i + count))
    const [x, y, z, length] = read('normal', 4)
    const normal = [x, y, z].map((k) => (k * length) / Math.hypot(x, y, z))
    const gradients = attributeNames
      .filter((attributeName) => attributeName.endsWith('Gradient'))
      .map((attributeName) => read(attributeName, 3))
    const instance = Number((i / 4) % size >= size / 2)
    const vertex = { position: read('position', 3), normal, uv: read('uv', 2), gradients }
    const exact = exactVertex((...vectors) => move(...vectors, { instance, matrixWorld }), vertex)
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
    // The number of pixels that only one of the pictures, with and without exact normals, covers.
    moved,
    median: quantile(angles, 0.5),
    max: quantile(angles, 0.999),
    finite: angles.every(Number.isFinite),
  }
}

/**
 * Adds the varyings `position` and `normal` to a positionNode: those of the vertex before the positionNode moves it, posed unless
 * `ignoresPose`. The fourth component of `normal` is the length of the normal.
 */
function withVaryings(positionNode, ignoresPose) {
  const [position, normal] = [0, 1].map((i) => varyingProperty('vec4', `seen${i}`))
  const [p, n] = ignoresPose ? [positionGeometry, normalGeometry] : [positionLocal, normalLocal]
  const show = Fn(() => {
    position.assign(vec4(p, 1))
    normal.assign(vec4(n, n.length()))
    return positionNode
  })
  return { positionNode: show(), position, normal }
}

/** Counts values of a picture that `exactNormals` changes. */
async function countChanges(name, settings) {
  const pictures = []
  for (const isExact of [true, false])
    pictures.push((await drawCase(unsupported[name], { ...settings, isExact })).shown)
  return pictures[0].filter((x, i) => x !== pictures[1][i]).length
}

/** Half the side of each showcase's plane. The view from above shows the whole plane. */
const halfSides = { sea: 1, terrain: 5 }
/** The side of a picture of a showcase, in pixels. */
const showcaseSize = 320

/**
 * Draws the normals of a showcase. Returns the picture `shown`, and the objects that were drawn. `by` says which normals: 'hand' for those of the
 * showcase, 'us' for `exactNormals`.
 */
async function drawShowcase(name, { backend, by, normals = 'pixel', pieces, side = showcaseSize }) {
  const renderer = await rendererFor(backend)
  const { geometry, parameters, material: make } = showcases[name]
  const original = make(parameters(), by === 'hand')
  const material = new THREE.MeshNormalNodeMaterial()
  Object.assign(material, { positionNode: original.positionNode, normalNode: original.normalNode })
  if (by === 'us') exactNormals(material, { normals })
  const mesh = new THREE.Mesh(geometry(pieces), material)
  const half = halfSides[name]
  const view = new THREE.OrthographicCamera(-half, half, half, -half, 0.1, 40)
  view.position.y = 20
  view.lookAt(0, 0, 0)
  view.updateMatrixWorld()
  const scene = new THREE.Scene()
  scene.add(mesh)
  const shown = await takePicture(renderer, scene, view, side)
  // Another target needs another shader.
  renderer.setRenderTarget(getTarget(renderer, side))
  const shaders = await renderer.debug.getShaderAsync(scene, view, mesh)
  renderer.setRenderTarget(null)
  return { renderer, material, mesh, scene, view, shown, shaders }
}

/** Counts evaluations of the height of a showcase → [count in the vertex shader, count in the fragment shader]. */
async function heightsOf(name, settings) {
  const { shaders } = await drawShowcase(name, { ...settings, pieces: 4, side: 16 })
  return [countHeights(shaders.vertexShader), countHeights(shaders.fragmentShader)]
}

/** Compares the drawn normals of a showcase with finite differences of its height. Returns statistics of their angles, in degrees. */
async function measureShowcase(name, settings) {
  const { renderer, material, mesh, scene, view, shown } = await drawShowcase(name, settings)
  const { heightNear } = showcases[name]
  mesh.material = new THREE.MeshBasicNodeMaterial()
  mesh.material.positionNode = material.positionNode
  mesh.material.fragmentNode = vec4(positionLocal, 1)
  const seen = await takePicture(renderer, scene, view, showcaseSize)
  const angles = []
  let skipped = 0
  for (let i = 0; i < 4 * showcaseSize * showcaseSize; i += 4) {
    if (shown[i + 3] === 0 || seen[i + 3] === 0) continue
    const slopes = [
      [1, 0],
      [0, 1],
    ].map(([x, z]) => {
      const heightAt = heightNear(seen[i], seen[i + 2])
      const slope = (h) => (heightAt(h * x, h * z) - heightAt(-h * x, -h * z)) / (2 * h)
      const [coarse, fine] = [slope(2e-5), slope(1e-5)]
      return Math.abs(coarse - fine) < 1e-4 ? (4 * fine - coarse) / 3 : NaN
    })
    if (!slopes.every(Number.isFinite)) {
      skipped++
      continue
    }
    const normal = new THREE.Vector3(-slopes[0], 1, -slopes[1]).transformDirection(
      view.matrixWorldInverse,
    )
    const colour = [0, 1, 2].map((k) => 2 * decode(shown[i + k]) - 1)
    angles.push(degreesBetween(colour, normal.toArray()))
  }
  return {
    covered: angles.length + skipped,
    skipped,
    mean: angles.reduce((a, b) => a + b, 0) / angles.length,
    worst: angles.reduce((a, b) => Math.max(a, b), 0),
    max: quantile(angles, 0.999),
    median: quantile(angles, 0.5),
  }
}

/** Draws the varyings that a positionNode assigns, as colours, with `exactNormals` and without. Returns the max difference. */
async function differenceOfVaryings(name, { backend, normals, hasTangents }) {
  const pictures = []
  let heights
  for (const isExact of [true, false]) {
    const renderer = await rendererFor(backend)
    const { position, colour } = varyings[name]()
    const material = new THREE.MeshStandardNodeMaterial()
    Object.assign(material, { positionNode: position, fragmentNode: colour })
    if (isExact) exactNormals(material, { normals })
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2, 8, 8), material)
    if (hasTangents) {
      const tangents = Float32Array.from({ length: 4 * 81 }, (_, i) => Number(i % 4 === 0))
      mesh.geometry.setAttribute('tangent', new THREE.BufferAttribute(tangents, 4))
    }
    const view = camera()
    pictures.push(await draw(renderer, mesh, view))
    const shaders = await renderer.debug.getShaderAsync(mesh.parent, view, mesh)
    if (isExact) heights = countHeights(shaders.vertexShader)
  }
  const [exact, plain] = pictures
  return {
    covered: plain.filter((x, i) => i % 4 === 3 && x > 0).length,
    difference: exact.reduce((max, x, i) => Math.max(max, Math.abs(x - plain[i])), 0),
    spread: Math.max(...plain) - Math.min(...plain),
    heights,
  }
}

/** Raises a plane that faces the viewer between two frames. Returns the velocities at its middle, upwards, in units of the scene. */
async function velocities({ backend }) {
  const renderer = await rendererFor(backend)
  const { mrt, output, uniform, vec3, velocity } = THREE.TSL
  const shift = uniform(0)
  const material = new THREE.MeshBasicNodeMaterial()
  material.positionNode = positionLocal.add(vec3(0, shift, 0))
  exactNormals(material)
  const scene = new THREE.Scene()
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material))
  const target = new THREE.RenderTarget(size, size, { count: 2, type: THREE.FloatType })
  target.textures[0].name = 'output'
  target.textures[1].name = 'velocity'
  renderer.setMRT(mrt({ output, velocity }))
  const results = []
  for (const value of [0, 0.3, 0.3]) {
    shift.value = value
    // Three.js starts a new frame in its own animation frame callback, which may run before or after ours.
    for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame)
    renderer.setRenderTarget(target)
    renderer.render(scene, camera())
    renderer.setRenderTarget(null)
    const numbers = await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, 1)
    // The middle is the same whether the top or the bottom row is first. A velocity is in units of half a picture, which is 1.5 units of
    // the scene high.
    results.push(numbers[4 * (size / 2) * (size + 1) + 1] * 1.5)
  }
  renderer.setMRT(null)
  return results
}

/** Counts pixels that differ between a warped mesh whose material has exact normals, and a mesh with both motions written by hand. */
async function besideWarp(name, { backend }) {
  const renderer = await rendererFor(backend)
  const view = camera()
  const { both, byHand, withoutExact } = warpBeside[name]
  const [shown, expected, plain] = [
    await draw(renderer, both(), view),
    await draw(renderer, byHand(), view),
    await draw(renderer, withoutExact(), view),
  ]
  const countDiffering = (a, b) => {
    let count = 0
    for (let i = 0; i < a.length; i += 4)
      count += Number([0, 1, 2, 3].some((k) => Math.abs(a[i + k] - b[i + k]) > 0.02))
    return count
  }
  return {
    differing: countDiffering(shown, expected),
    plain: countDiffering(plain, expected),
    covered: shown.filter((x, i) => i % 4 === 3 && x > 0).length,
  }
}

window.exact = {
  besideWarp,
  warpsBeside: Object.keys(warpBeside),
  differenceOfVaryings,
  varyings: Object.keys(varyings),
  heightsOf,
  measureShowcase,
  velocities,
  names: Object.keys(displacements),
  longLoops: Object.keys(longLoops),
  measure,
  unsupported: Object.entries(unsupported).map(([name, { message }]) => [name, message.source]),
  countChanges,
}
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
