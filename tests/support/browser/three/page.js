// A page with three.js and 'warpjet/three', with functions that tests call.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { measureHeap } from './heap.js'
import { countDiffering } from './pixels.js'
import { samplings, scenesOf } from './sampling.js'
import * as scenes from './scenes.js'
import * as wave from './wave.js'

const { size } = scenes

const renderers = {}

/** Returns the renderer for a set of options, such as logarithmicDepthBuffer. */
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

/** Frees geometries and shadow maps, but not materials, since their programs take the longest to make. */
function free(scene) {
  scene.traverse((part) => {
    part.geometry?.dispose()
    part.shadow?.map?.dispose()
  })
}

/** Functions that break the shaders, to show that the tests detect broken shaders. */
const sabotages = {
  normals: (source) =>
    source.replaceAll('objectNormal = warpjetNormal', 'objectNormal = warpjetRestNormal'),
  depth: (source) =>
    /vHighPrecisionZW|#define DISTANCE/.test(source)
      ? source.replaceAll('transformed = warpjetPosition;', '')
      : source,
}

/** Returns a renderer with sabotaged shaders. */
function getSabotagedRenderer(sabotage) {
  const made = rendererFor({ sabotage })
  const gl = made.getContext()
  const { shaderSource } = WebGL2RenderingContext.prototype
  gl.shaderSource = (shader, source) => shaderSource.call(gl, shader, sabotages[sabotage](source))
  return made
}

/**
 * Counts pixels that differ between the warp and the same motion by matrices (`differing`), between the warp and no motion (`moved`), and
 * between the disposed warp and no motion (`afterwards`).
 */
export function compare(
  name,
  { light = 'directional', space, normals, sabotage, map = 'PCF', options = {} },
) {
  const make = scenes.shapes[name]
  renderer = sabotage ? getSabotagedRenderer(sabotage) : rendererFor(options)
  renderer.shadowMap.type = THREE[`${map}ShadowMap`]
  const still = scenes.sceneOf(scenes.makeUnmoved(make), light)
  const before = draw(still)
  free(still)
  const reference = scenes.sceneOf(scenes.makeMoved(make, space), light)
  const expected = draw(reference)
  free(reference)
  const object = scenes.makeUnmoved(make)
  const scene = scenes.sceneOf(object, light)
  const warped = warp(object, scenes.offset, { space, normals, uniforms: scenes.uniforms() })
  warped.update(1000)
  const shown = draw(scene)
  warped.dispose()
  const after = draw(scene)
  free(scene)
  return {
    differing: countDiffering(shown, expected),
    moved: countDiffering(shown, before),
    afterwards: countDiffering(after, before, 0),
  }
}

/**
 * Does the same as `compare` for double-sided materials and a motion that mirrors. The matrix is constant if `isKnown`, otherwise it
 * consists of uniforms.
 */
export function mirror(name, { light = 'directional', space, normals, isKnown = false }) {
  const make = scenes.shapes[name]
  renderer = rendererFor({})
  renderer.shadowMap.type = THREE.PCFShadowMap
  const drawObject = (object) => {
    const scene = scenes.sceneOf(object, light)
    const picture = draw(scene)
    free(scene)
    return picture
  }
  const { mirroredMotion, makeDoubleSided } = scenes
  const before = drawObject(makeDoubleSided(scenes.makeUnmoved(make)))
  const reference = scenes.makeMoved(make, space, mirroredMotion)
  const expected = drawObject(scenes.flipBitangents(makeDoubleSided(reference)))
  const object = makeDoubleSided(scenes.makeUnmoved(make))
  const warped = isKnown
    ? warp(object, scenes.constantOffset(mirroredMotion), { space, normals })
    : warp(object, scenes.offset, { space, normals, uniforms: scenes.uniforms(mirroredMotion) })
  warped.update(1000)
  const shown = drawObject(object)
  warped.dispose()
  return { differing: countDiffering(shown, expected), moved: countDiffering(shown, before) }
}

/** Measures the max error of the drawn normals of a wave, in units of 1/255. Returns { worst, unwarped }: at each moment, and without the warp. */
export function normals() {
  renderer = rendererFor({})
  const { scene, camera, mesh, size } = wave.makeWaveScene()
  const target = new THREE.WebGLRenderTarget(size, size)
  const read = (millis) => {
    renderer.setRenderTarget(target)
    renderer.render(scene, camera)
    const bytes = new Uint8Array(4 * size * size)
    renderer.readRenderTargetPixels(target, 0, 0, size, size, bytes)
    renderer.setRenderTarget(null)
    return wave.maxError(
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

/** Compares a translation that a warp reads from an image with the same translation through a matrix. */
export function image() {
  renderer = rendererFor({})
  const make = { warped: scenes.shapes.plain, moved: scenes.shapes.plain }
  const object = scenes.makeUnmoved(make)
  const scene = scenes.sceneOf(object, 'directional')
  const warped = warp(object, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
    uniforms: { map: scenes.shiftMap() },
    surfaceVariation: false,
  })
  const shown = draw(scene)
  warped.dispose()
  const before = draw(scene)
  object.matrix.multiply(scenes.shiftMatrix())
  return { differing: countDiffering(shown, draw(scene)), moved: countDiffering(shown, before) }
}

/** Compares a sphere whose heights a warp reads from a texture with vertices moved in double precision. */
export function sampling(name, kind) {
  renderer = rendererFor({})
  const { warped, expected, still } = scenesOf(name, kind)
  const [shown, moved, before] = [warped, expected, still].map((scene) => draw(scene))
  return { differing: countDiffering(shown, moved), moved: countDiffering(moved, before) }
}

/** Compares the example for three-custom-shader-material in web/docs/three.md with the same motion by three's matrices. */
export async function custom() {
  renderer = rendererFor({})
  // For variance shadows, three.js would also draw objects that only receive shadows.
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
  const object = scenes.makeUnmoved(scenes.shapes.plain)
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
  const moved = scenes.makeMoved(scenes.shapes.plain)
  const reference = scenes.sceneOf(moved, 'directional')
  moved.castShadow = false
  return { differing: countDiffering(shown, draw(reference)), moved: countDiffering(shown, before) }
}

/**
 * Warps and disposes of a mesh many times. Returns three's counts of resources and the size of the heap, before and after. With `hasTwin`,
 * another mesh stays warped and shares the programs of the mesh, which would otherwise be compiled each time, for 0.1 s. Draws few pixels.
 */
export async function churn(times, { hasTwin = false } = {}) {
  renderer = rendererFor({})
  const object = scenes.shapes.plain()
  const scene = scenes.sceneOf(object, 'directional')
  renderer.setSize(8, 8)
  scene.traverse((part) => part.shadow?.mapSize.set(8, 8))
  const twin = hasTwin ? scenes.shapes.plain() : null
  if (twin) {
    twin.castShadow = twin.receiveShadow = true
    scene.add(twin)
  }
  // In the first frame of a scene, three.js compiles shadow programs without its lights, which are not shared later.
  renderer.render(scene, scenes.camera())
  const twinWarp = twin && warp(twin, scenes.offset, { uniforms: scenes.uniforms() })
  const once = () => {
    const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms() })
    warped.update(1000)
    renderer.render(scene, scenes.camera())
    warped.dispose()
    renderer.render(scene, scenes.camera())
  }
  const state = async () => {
    const heap = await measureHeap()
    const { memory, programs } = renderer.info
    return { ...memory, programs: programs.length, heap }
  }
  // Runs until all code is compiled and all caches have their final size.
  for (let i = 0; i < 20; i++) once()
  const before = await state()
  for (let i = 0; i < times; i++) once()
  const after = await state()
  twinWarp?.dispose()
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
