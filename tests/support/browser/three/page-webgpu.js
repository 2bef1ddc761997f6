// A page with WebGPURenderer, on both backends, and 'warpjet/three/webgpu', with functions that tests call.
import { WebGLRenderer } from 'three'
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import { warpNode } from 'warpjet/three/webgpu'
import { measureHeap } from './heap.js'
import { countDiffering } from './pixels.js'
import { samplings, scenesOf } from './sampling.js'
import * as scenes from './scenes.js'
import * as wave from './wave.js'
import { draw, rendererFor } from './webgpu-renderer.js'

const { size } = scenes
const { normalGeometry, transformNormalToView } = THREE.TSL

/** Functions that break the warp, to show that the tests detect a broken warp. */
const sabotages = {
  // Three.js converts the material to a node material and copies this property.
  normals: ({ material }) => {
    material.normalNode = transformNormalToView(normalGeometry)
  },
}

/**
 * Counts pixels that differ between the warp and the same motion by matrices (`differing`), between the warp and no motion (`moved`), and
 * between the disposed warp and no motion (`afterwards`).
 */
async function compare(name, { backend, light = 'directional', space, sabotage, map = 'PCF' }) {
  const renderer = await rendererFor(backend)
  const make = scenes.shapes[name]
  renderer.shadowMap.type = THREE[`${map}ShadowMap`]
  const before = await draw(renderer, scenes.sceneOf(scenes.makeUnmoved(make), light))
  const expected = await draw(renderer, scenes.sceneOf(scenes.makeMoved(make, space), light))
  const object = scenes.makeUnmoved(make)
  const scene = scenes.sceneOf(object, light)
  const warped = warp(object, scenes.offset, { space, uniforms: scenes.uniforms() })
  warped.update(1000)
  sabotages[sabotage]?.(object)
  const shown = await draw(renderer, scene)
  warped.dispose()
  const after = await draw(renderer, scene)
  return {
    differing: countDiffering(shown, expected),
    moved: countDiffering(shown, before),
    afterwards: countDiffering(after, before, 0),
  }
}

/** Does the same as `mirror` in page.js. */
async function mirror(name, { backend, light = 'directional', space, isKnown = false }) {
  const renderer = await rendererFor(backend)
  const make = scenes.shapes[name]
  const { mirroredMotion, makeDoubleSided } = scenes
  const drawObject = (object) => draw(renderer, scenes.sceneOf(object, light))
  const before = await drawObject(makeDoubleSided(scenes.makeUnmoved(make)))
  const expected = await drawObject(makeDoubleSided(scenes.makeMoved(make, space, mirroredMotion)))
  const object = makeDoubleSided(scenes.makeUnmoved(make))
  const warped = isKnown
    ? warp(object, scenes.constantOffset(mirroredMotion), { space })
    : warp(object, scenes.offset, { space, uniforms: scenes.uniforms(mirroredMotion) })
  warped.update(1000)
  const shown = await drawObject(object)
  warped.dispose()
  return { differing: countDiffering(shown, expected), moved: countDiffering(shown, before) }
}

/** Does the same as `normals` in page.js, with a float target, for which three.js converts colours to linear ones. */
async function normals({ backend, asNode }) {
  const renderer = await rendererFor(backend)
  const { scene, camera, mesh, size } = wave.makeWaveScene(
    asNode ? new THREE.MeshNormalNodeMaterial() : undefined,
  )
  const target = new THREE.RenderTarget(size, size, { type: THREE.FloatType })
  const read = async (millis) => {
    renderer.setRenderTarget(target)
    renderer.render(scene, camera)
    renderer.setRenderTarget(null)
    const numbers = await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
    const shown = Array.from(numbers, (x) =>
      x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055,
    )
    return wave.maxError(shown, { isUpwards: backend === 'webgl', millis })
  }
  const unwarped = await read()
  let update
  if (asNode) {
    const made = warpNode(wave.offset)
    Object.assign(mesh.material, { positionNode: made.node, needsUpdate: true })
    update = made.update
  } else update = warp(mesh, wave.offset).update
  const worst = []
  for (const millis of wave.moments) {
    update(millis)
    worst.push(await read(millis))
  }
  return { worst, unwarped }
}

/** Does the same as `image` in page.js. */
async function image({ backend }) {
  const renderer = await rendererFor(backend)
  const object = scenes.makeUnmoved(scenes.shapes.plain)
  const scene = scenes.sceneOf(object, 'directional')
  const warped = warp(object, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
    uniforms: { map: scenes.shiftMap() },
    surfaceVariation: false,
  })
  const shown = await draw(renderer, scene)
  warped.dispose()
  const before = await draw(renderer, scene)
  object.matrix.multiply(scenes.shiftMatrix())
  return {
    differing: countDiffering(shown, await draw(renderer, scene)),
    moved: countDiffering(shown, before),
  }
}

/** Draws spheres that a warp scales, each by another amount. Returns the numbers of pixels that they cover. */
async function amounts(factors, { backend }) {
  const renderer = await rendererFor(backend)
  const covered = []
  for (const amount of factors) {
    const scene = new THREE.Scene()
    const material = new THREE.MeshBasicMaterial({ color: 'white' })
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 40, 20), material)
    scene.add(mesh)
    warp(mesh, ({ position, uniforms }) => position.mult(uniforms.amount), { uniforms: { amount } })
    const pixels = await draw(renderer, scene)
    covered.push(pixels.filter((byte, i) => i % 4 === 0 && byte > 200).length)
  }
  return covered
}

/** Does the same as `sampling` in page.js. */
async function sampling(name, kind, { backend }) {
  const renderer = await rendererFor(backend)
  const { warped, expected, still } = scenesOf(name, kind)
  const pictures = []
  for (const scene of [warped, expected, still]) pictures.push(await draw(renderer, scene))
  const [shown, moved, before] = pictures
  return { differing: countDiffering(shown, moved), moved: countDiffering(moved, before) }
}

/** Compares two planes scaled by 2: a warp moves one along its normal in world space, the other is placed at its destination. */
async function alongNormal({ backend }) {
  const renderer = await rendererFor(backend)
  const makePlane = () => {
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(0.5, 0.5), new THREE.MeshStandardMaterial())
    mesh.scale.setScalar(2)
    mesh.rotation.set(0.5, 0.4, 0)
    return mesh
  }
  const [object, moved] = [makePlane(), makePlane()]
  const shift = new THREE.Vector3(0, 0, 0.3).applyEuler(moved.rotation)
  moved.position.add(shift)
  const before = await draw(renderer, scenes.sceneOf(makePlane(), 'directional'))
  const expected = await draw(renderer, scenes.sceneOf(moved, 'directional'))
  const scene = scenes.sceneOf(object, 'directional')
  const offset = ({ normal }) => normal.mult(0.3)
  const warped = warp(object, offset, { space: 'world', surfaceVariation: false })
  const shown = await draw(renderer, scene)
  warped.dispose()
  return { differing: countDiffering(shown, expected), moved: countDiffering(shown, before) }
}

/**
 * Warps an object, draws it with WebGLRenderer and WebGPURenderer, and compares each picture with one of the same motion without a warp by
 * the same renderer.
 */
async function both({ backend }) {
  const renderer = await rendererFor(backend)
  const other = new WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
  other.setSize(size, size)
  const makeScene = (object) => {
    const scene = scenes.sceneOf(object, 'directional')
    scene.traverse((part) => (part.castShadow = false))
    return scene
  }
  const read = (scene) => {
    other.render(scene, scenes.camera())
    const gl = other.getContext()
    const bytes = new Uint8Array(4 * size * size)
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, bytes)
    return bytes
  }
  const object = scenes.makeUnmoved(scenes.shapes.plain)
  const [before, scene] = [makeScene(scenes.makeUnmoved(scenes.shapes.plain)), makeScene(object)]
  const expected = makeScene(scenes.makeMoved(scenes.shapes.plain))
  const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms() })
  warped.update(1000)
  const results = {}
  for (const [name, show] of [
    ['webgl', read],
    ['webgpu', (scene) => draw(renderer, scene)],
  ]) {
    const [shown, moved] = [await show(scene), await show(expected)]
    results[name] = {
      differing: countDiffering(shown, moved),
      moved: countDiffering(moved, await show(before)),
    }
  }
  warped.dispose()
  other.dispose()
  return results
}

/** Warps and disposes of a mesh many times. Returns three's counts of resources and the size of the heap, before and after. */
async function churn({ backend, times }) {
  const renderer = await rendererFor(backend)
  const object = scenes.shapes.plain()
  const scene = scenes.sceneOf(object, 'directional')
  const once = () => {
    const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms() })
    warped.update(1000)
    return draw(renderer, scene).then(() => warped.dispose())
  }
  const state = async () => {
    const heap = await measureHeap()
    return { ...renderer.info.memory, heap }
  }
  for (let i = 0; i < 20; i++) await once()
  const before = await state()
  for (let i = 0; i < times; i++) await once()
  return { before, after: await state() }
}

window.three = {
  both,
  churn,
  compare,
  mirror,
  names: Object.keys(scenes.shapes),
  normals,
  image,
  amounts,
  sampling,
  samplings: Object.keys(samplings),
  alongNormal,
}
// Keeps navigator.gpu alive; otherwise the browser loses the device.
window.gpu = navigator.gpu
window.lib = { THREE, warp, warpNode, rendererFor, draw, scenes }
document.title = 'ready'
