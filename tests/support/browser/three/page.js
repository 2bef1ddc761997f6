// A page with three.js and 'warpjet/three': the functions that tests call in it.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { settledHeap } from './heap.js'
import { differing } from './pixels.js'
import * as scenes from './scenes.js'
import { samplings, scenesOf } from './sampling.js'
import * as wave from './wave.js'

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

/** Materials stay, and their programs with them, which take longest to make. */
function free(scene) {
  scene.traverse((part) => {
    part.geometry?.dispose()
    part.shadow?.map?.dispose()
  })
}

/** Statements that are left out of the shaders, to see that a test would notice. */
const sabotages = {
  normals: (source) =>
    source.replaceAll('objectNormal = warpjetNormal', 'objectNormal = warpjetRestNormal'),
  depth: (source) =>
    /vHighPrecisionZW|#define DISTANCE/.test(source)
      ? source.replaceAll('transformed = warpjetPosition;', '')
      : source,
}

/** A renderer whose shaders lack something. */
function sabotagedRenderer(sabotage) {
  const made = rendererFor({ sabotage })
  const gl = made.getContext()
  const { shaderSource } = WebGL2RenderingContext.prototype
  gl.shaderSource = (shader, source) => shaderSource.call(gl, shader, sabotages[sabotage](source))
  return made
}

/** Counts the pixels that differ between the warp and the motion → { differing, moved, covered }. */
export function compare(
  name,
  { light = 'directional', space, normals, sabotage, map = 'PCF', options = {} },
) {
  const make = scenes.shapes[name]
  renderer = sabotage ? sabotagedRenderer(sabotage) : rendererFor(options)
  renderer.shadowMap.type = THREE[`${map}ShadowMap`]
  const still = scenes.sceneOf(scenes.unmoved(make), light)
  const before = draw(still)
  free(still)
  const reference = scenes.sceneOf(scenes.moved(make, space), light)
  const expected = draw(reference)
  free(reference)
  const object = scenes.unmoved(make)
  const scene = scenes.sceneOf(object, light)
  const warped = warp(object, scenes.offset, { space, normals, uniforms: scenes.uniforms() })
  warped.update(1000)
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

/**
 * The same where the motion mirrors, of materials that show both sides, the matrix known when the warp is made or by uniforms
 * alone → also how many pixels differ with normals on the inner side.
 */
export function mirror(name, { light = 'directional', space, normals, isKnown = false }) {
  const make = scenes.shapes[name]
  renderer = rendererFor({})
  renderer.shadowMap.type = THREE.PCFShadowMap
  const pictureOf = (object) => {
    const scene = scenes.sceneOf(object, light)
    const picture = draw(scene)
    free(scene)
    return picture
  }
  const { mirroredMotion, doubleSided } = scenes
  const before = pictureOf(doubleSided(scenes.unmoved(make)))
  const reference = scenes.moved(make, space, mirroredMotion)
  const expected = pictureOf(scenes.withOtherBitangents(doubleSided(reference)))
  const object = doubleSided(scenes.unmoved(make))
  const warped = isKnown
    ? warp(object, scenes.constantOffset(mirroredMotion), { space, normals })
    : warp(object, scenes.offset, { space, normals, uniforms: scenes.uniforms(mirroredMotion) })
  warped.update(1000)
  const shown = pictureOf(object)
  warped.dispose()
  return { differing: differing(shown, expected), moved: differing(shown, before) }
}

/** How wrong the normals of a wave are shown, in 255ths; without the warp's, for comparison. */
export function normals() {
  renderer = rendererFor({})
  const { scene, camera, mesh, size } = wave.waveScene()
  const target = new THREE.WebGLRenderTarget(size, size)
  const read = (millis) => {
    renderer.setRenderTarget(target)
    renderer.render(scene, camera)
    const bytes = new Uint8Array(4 * size * size)
    renderer.readRenderTargetPixels(target, 0, 0, size, size, bytes)
    renderer.setRenderTarget(null)
    return wave.worstOf(
      Array.from(bytes, (byte) => byte / 255),
      { millis },
    )
  }
  const unwarped = read()
  const warped = warp(mesh, wave.offset)
  const worst = wave.moments.map((millis) => {
    warped.update(millis)
    return read(millis)
  })
  warped.dispose()
  target.dispose()
  return { worst, unwarped }
}

/** A shift whose amount an image holds, against the same by a matrix → how many pixels differ. */
export function image() {
  renderer = rendererFor({})
  const make = { warped: scenes.shapes.plain, moved: scenes.shapes.plain }
  const object = scenes.unmoved(make)
  const scene = scenes.sceneOf(object, 'directional')
  const warped = warp(object, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
    uniforms: { map: scenes.shiftMap() },
    surfaceVariation: false,
  })
  const shown = draw(scene)
  warped.dispose()
  const before = draw(scene)
  object.matrix.multiply(scenes.shiftMatrix())
  return { differing: differing(shown, draw(scene)), moved: differing(shown, before) }
}

/** A sphere whose heights a texture holds, sampled as the texture is set, against vertices that were moved in double. */
export function sampling(name, kind) {
  renderer = rendererFor({})
  const { warped, expected, still } = scenesOf(name, kind)
  const [shown, wanted, before] = [warped, expected, still].map((scene) => draw(scene))
  return { differing: differing(shown, wanted), moved: differing(wanted, before) }
}

/** The ten lines of web/docs/three.md, with three-custom-shader-material, against the motion by three.js. */
export async function custom() {
  renderer = rendererFor({})
  // Variance shadows draw also what only receives them.
  renderer.shadowMap.type = THREE.PCFShadowMap
  const { default: CustomShaderMaterial } = await import('three-custom-shader-material/vanilla')
  const { compileWarp } = await import('warpjet')
  const { elements: e } = scenes.motion
  const { code, declarations } = compileWarp(
    ({ glsl, position, millis }) =>
      glsl
        .mat3(
          glsl.vec3(e[0], e[1], e[2]),
          glsl.vec3(e[4], e[5], e[6]),
          glsl.vec3(e[8], e[9], e[10]),
        )
        .mult(position)
        .add(glsl.vec3(e[12], e[13], e[14]).mult(millis.div(1000)))
        .sub(position),
    { names: { millis: 'uTime' } },
  )
  const object = scenes.unmoved(scenes.shapes.plain)
  const scene = scenes.sceneOf(object, 'directional')
  const before = draw(scene)
  object.material = new CustomShaderMaterial({
    baseMaterial: object.material,
    uniforms: { uTime: { value: 1000 } },
    vertexShader: `uniform float uTime;
      ${declarations}
      void main() {
        ${code}
        csm_Position = warpedPosition;
        csm_Normal = warpedNormal;
      }`,
  })
  object.castShadow = false
  const shown = draw(scene)
  const moved = scenes.moved(scenes.shapes.plain)
  const reference = scenes.sceneOf(moved, 'directional')
  moved.castShadow = false
  return { differing: differing(shown, draw(reference)), moved: differing(shown, before) }
}

/**
 * Warps and disposes a mesh in a scene many times → what three.js counts and the heap, before and after. Beside another that
 * stays warped, programs are shared with that one, and not compiled each time, which takes a tenth of a second. What is drawn
 * is a handful of pixels.
 */
export async function churn(times, { isBeside = false } = {}) {
  renderer = rendererFor({})
  const object = scenes.shapes.plain()
  const scene = scenes.sceneOf(object, 'directional')
  renderer.setSize(8, 8)
  scene.traverse((part) => part.shadow?.mapSize.set(8, 8))
  const beside = isBeside ? scenes.shapes.plain() : null
  if (beside) {
    beside.castShadow = beside.receiveShadow = true
    scene.add(beside)
  }
  // The programs of shadows in a scene's first frame know nothing of its lights, and would be like no others.
  renderer.render(scene, scenes.camera())
  const kept = beside && warp(beside, scenes.offset, { uniforms: scenes.uniforms() })
  const once = () => {
    const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms() })
    warped.update(1000)
    renderer.render(scene, scenes.camera())
    warped.dispose()
    renderer.render(scene, scenes.camera())
  }
  const state = async () => {
    const heap = await settledHeap()
    const { memory, programs } = renderer.info
    return { ...memory, programs: programs.length, heap }
  }
  // Until all code is compiled and all caches are as large as they get.
  for (let i = 0; i < 20; i++) once()
  const before = await state()
  for (let i = 0; i < times; i++) once()
  const after = await state()
  kept?.dispose()
  renderer.setSize(size, size)
  return { before, after }
}

export const names = Object.keys(scenes.shapes)

window.three = {
  compare,
  mirror,
  names,
  normals,
  image,
  sampling,
  samplings: Object.keys(samplings),
  custom,
  churn,
}
document.title = 'ready'
