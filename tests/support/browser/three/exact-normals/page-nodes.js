// A page with WebGPURenderer, on both its backends, that measures the normals of `exactNormals` at pixels.
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'
import { degreesBetween, exactVertex, quantile } from '../pixel-normals/exact.js'
import { camera, objectFor, parts, restPart, size } from '../pixel-normals/scenes.js'
import { rendererFor } from '../webgpu-renderer.js'
import { displacements, unsupported } from './displacements.js'
import { heightsIn } from './heights.js'
import { showcases } from './showcases.js'
import { varyings } from './varyings.js'
import { warpBeside } from './warp-beside.js'

const { Fn, attribute, normalGeometry, normalLocal, positionGeometry, positionLocal } = THREE.TSL
const { varyingProperty, vec4 } = THREE.TSL

/** Each renderer has a target of its own: one that another has drawn to stays empty on WebGL. */
const targets = new Map()

function targetOf(renderer, side) {
  const key = `${renderer.backend.isWebGPUBackend} ${side}`
  if (!targets.has(key))
    targets.set(key, new THREE.RenderTarget(side, side, { type: THREE.FloatType }))
  return targets.get(key)
}

/** Draws a scene → its numbers, four for each pixel. */
async function picture(renderer, scene, view, side = size) {
  const target = targetOf(renderer, side)
  renderer.setRenderTarget(target)
  renderer.setClearColor(0, 0)
  renderer.render(scene, view)
  renderer.setRenderTarget(null)
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, side, side)
}

/** Converts a linear colour back to sRGB: MeshNormalMaterial takes the normal for an sRGB colour and writes it linearly. */
const decode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)

function draw(renderer, object, view) {
  const scene = new THREE.Scene()
  scene.add(object)
  return picture(renderer, scene, view)
}

/** Draws a case with `exactNormals`, or without → the picture and everything that drew it. */
async function drawCase(
  { kind = 'plain', shape, first, position, prepare },
  { backend, normals = 'pixel', isExact = true },
) {
  const renderer = await rendererFor(backend)
  const material = new THREE.MeshNormalNodeMaterial()
  material.positionNode = (first ?? position)()
  if (isExact) exactNormals(material, { normals })
  const { object, geometry } = objectFor(kind, shape, material)
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

/** Compares shown normals with exact ones → degrees, by quantiles. */
async function measure(name, settings) {
  const given = displacements[name]
  const { move, isOfGeometry } = given
  const { renderer, material, object, geometry, view, shown } = await drawCase(given, settings)
  const seen = {}
  const shows = positionShowing(material.positionNode, isOfGeometry)
  object.material = new THREE.MeshBasicNodeMaterial()
  object.material.positionNode = shows.positionNode
  for (const part of parts) {
    if (part === 'tangent') continue
    object.material.fragmentNode = shows[part] ?? attribute('seen', 'vec4')
    object.material.needsUpdate = true
    const numbers = restPart('plain', geometry, part)
    object.geometry.setAttribute('seen', new THREE.BufferAttribute(numbers, 4))
    seen[part] = await draw(renderer, object, view)
  }
  const { matrixWorld } = object
  const normalMatrix = new THREE.Matrix3().getNormalMatrix(matrixWorld)
  const angles = []
  let skipped = 0
  for (let i = 0; i < 4 * size * size; i += 4) {
    if (shown[i + 3] === 0 || seen.position[i + 3] === 0) continue
    const at = (part, count) => Array.from(seen[part].slice(i, i + count))
    const [x, y, z, length] = at('normal', 4)
    const normal = [x, y, z].map((k) => (k * length) / Math.hypot(x, y, z))
    const gradients = parts.filter((part) => part.endsWith('Gradient')).map((part) => at(part, 3))
    const instance = Number((i / 4) % size >= size / 2)
    const vertex = { position: at('position', 3), normal, uv: at('uv', 2), gradients }
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
    median: quantile(angles, 0.5),
    max: quantile(angles, 0.999),
    finite: angles.every(Number.isFinite),
  }
}

/** Wraps a positionNode: the varyings `position` and `normal` are those of the posed vertex before it moves; the fourth component of `normal` is its length. */
function positionShowing(positionNode, isOfGeometry) {
  const [position, normal] = [0, 1].map((i) => varyingProperty('vec4', `seen${i}`))
  const [p, n] = isOfGeometry ? [positionGeometry, normalGeometry] : [positionLocal, normalLocal]
  const show = Fn(() => {
    position.assign(vec4(p, 1))
    normal.assign(vec4(n, n.length()))
    return positionNode
  })
  return { positionNode: show(), position, normal }
}

/** Counts pixels that `exactNormals` changes. */
async function countChanges(name, settings) {
  const pictures = []
  for (const isExact of [true, false])
    pictures.push((await drawCase(unsupported[name], { ...settings, isExact })).shown)
  return pictures[0].filter((x, i) => x !== pictures[1][i]).length
}

/** Half the side of each showcase's plane, which the view from above shows whole. */
const halves = { sea: 1, terrain: 5 }
/** The side of a picture of a showcase, in pixels. */
const wide = 320

/** Shows the normals of a showcase, computed `by` 'hand', 'us' or 'nobody', → the picture and everything that drew it. */
async function drawShowcase(name, { backend, by, normals = 'pixel', pieces, side = wide }) {
  const renderer = await rendererFor(backend)
  const { geometry, parameters, material: make } = showcases[name]
  const original = make(parameters(), by === 'hand')
  const material = new THREE.MeshNormalNodeMaterial()
  Object.assign(material, { positionNode: original.positionNode, normalNode: original.normalNode })
  if (by === 'us') exactNormals(material, { normals })
  const mesh = new THREE.Mesh(geometry(pieces), material)
  const half = halves[name]
  const view = new THREE.OrthographicCamera(-half, half, half, -half, 0.1, 40)
  view.position.y = 20
  view.lookAt(0, 0, 0)
  view.updateMatrixWorld()
  const scene = new THREE.Scene()
  scene.add(mesh)
  const shown = await picture(renderer, scene, view, side)
  const shaders = await renderer.debug.getShaderAsync(scene, view, mesh)
  return { renderer, material, mesh, scene, view, shown, shaders }
}

/** Counts evaluations of the height of a showcase → numbers for the two stages. */
async function heightsOf(name, settings) {
  const { shaders } = await drawShowcase(name, { ...settings, pieces: 4, side: 16 })
  return [heightsIn(shaders.vertexShader), heightsIn(shaders.fragmentShader)]
}

/** Shows the normals of a showcase → degrees from those of differences of its height, by quantiles. */
async function measureShowcase(name, settings) {
  const { renderer, material, mesh, scene, view, shown } = await drawShowcase(name, settings)
  const { heightNear } = showcases[name]
  mesh.material = new THREE.MeshBasicNodeMaterial()
  mesh.material.positionNode = material.positionNode
  mesh.material.fragmentNode = vec4(positionLocal, 1)
  const seen = await picture(renderer, scene, view, wide)
  const angles = []
  let skipped = 0
  for (let i = 0; i < 4 * wide * wide; i += 4) {
    if (shown[i + 3] === 0 || seen[i + 3] === 0) continue
    const slopes = [
      [1, 0],
      [0, 1],
    ].map(([x, z]) => {
      const at = heightNear(seen[i], seen[i + 2])
      const slope = (h) => (at(h * x, h * z) - at(-h * x, -h * z)) / (2 * h)
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

/** Draws a position that assigns varyings, which are the colours, with `exactNormals` and without → the max difference. */
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
    if (isExact) heights = heightsIn(shaders.vertexShader)
  }
  const [exact, plain] = pictures
  return {
    covered: plain.filter((x, i) => i % 4 === 3 && x > 0).length,
    difference: exact.reduce((max, x, i) => Math.max(max, Math.abs(x - plain[i])), 0),
    spread: Math.max(...plain) - Math.min(...plain),
    heights,
  }
}

/** Raises a plane that faces the viewer between two frames → the velocities at its middle, in pixels upwards. */
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
  const found = []
  for (const value of [0, 0.3, 0.3]) {
    shift.value = value
    // Three.js counts a frame in each animation frame, whose order beside ours is unknown.
    for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame)
    renderer.setRenderTarget(target)
    renderer.render(scene, camera())
    renderer.setRenderTarget(null)
    const numbers = await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, 1)
    // Both have the same middle, whichever row is first; a velocity is in units of half a picture.
    found.push(numbers[4 * (size / 2) * (size + 1) + 1] * 1.5)
  }
  renderer.setMRT(null)
  return found
}

/** Draws a mesh whose material has exact normals and that is warped, too, and one by hand → pixels that differ. */
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
  measure,
  unsupported: Object.entries(unsupported).map(([name, { message }]) => [name, message.source]),
  countChanges,
}
// The browser drops the device if nothing refers to it.
window.gpu = navigator.gpu
document.title = 'ready'
