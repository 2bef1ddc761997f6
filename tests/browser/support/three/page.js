// What tests ask of a page with three.js and 'warpjet/three'.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import * as scenes from './scenes.js'

const { size } = scenes

const renderers = {}

/** One for each set of options, such as logarithmicDepthBuffer. */
function rendererFor(options) {
  const key = JSON.stringify(options)
  if (renderers[key]) return renderers[key]
  const made = new THREE.WebGLRenderer({
    antialias: false,
    preserveDrawingBuffer: true,
    ...options,
  })
  made.setSize(size, size)
  made.shadowMap.enabled = true
  made.localClippingEnabled = true
  document.body.append(made.domElement)
  return (renderers[key] = made)
}

export let renderer = rendererFor({})

export function draw(scene, camera = scenes.camera()) {
  renderer.render(scene, camera)
  const gl = renderer.getContext()
  const pixels = new Uint8Array(4 * size * size)
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
  return pixels
}

export function differing(a, b, tolerance = 12) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > tolerance)) count++
  return count
}

/** Materials stay, and their programs with them, which take longest to make. */
function free(scene) {
  scene.traverse((part) => {
    part.geometry?.dispose()
    part.shadow?.map?.dispose()
  })
}

/** What can be left out, to see that a test would notice. */
const sabotages = {
  normals: (object) =>
    object.traverse(({ material }) => {
      for (const each of [material ?? []].flat()) {
        const weave = each.onBeforeCompile
        each.onBeforeCompile = function (shader, ...others) {
          weave.call(this, shader, ...others)
          shader.vertexShader = shader.vertexShader.replaceAll('objectNormal = warpjetTurned', '')
        }
        each.customProgramCacheKey = () => 'without normals'
      }
    }),
  depth: (object) =>
    object.traverse((part) => {
      part.customDepthMaterial = part.customDistanceMaterial = undefined
    }),
}

/** How many pixels differ between the warp and the motion → { differing, moved, covered }. */
export function compare(
  name,
  { light = 'directional', space, sabotage, map = 'PCF', options = {} },
) {
  const make = scenes.shapes[name]
  renderer = rendererFor(options)
  renderer.shadowMap.type = THREE[`${map}ShadowMap`]
  const still = scenes.sceneOf(scenes.unmoved(make), light)
  const before = draw(still)
  free(still)
  const reference = scenes.sceneOf(scenes.moved(make, space), light)
  const expected = draw(reference)
  free(reference)
  const object = scenes.unmoved(make)
  const scene = scenes.sceneOf(object, light)
  const warped = warp(object, scenes.offset, { space, uniforms: scenes.uniforms() })
  warped.update(1000)
  sabotages[sabotage]?.(object)
  const shown = draw(scene)
  warped.dispose()
  const after = draw(scene)
  free(scene)
  return {
    differing: differing(shown, expected),
    moved: differing(shown, before),
    afterwards: differing(after, before, 0),
  }
}

/** What a page shows, for the eye. */
export const names = Object.keys(scenes.shapes)

window.three = { compare, names }
document.title = 'ready'
