// Passes that Babylon.js draws with its own shaders: each draws a warped mesh, and a mesh that a matrix moves the same way.
import '@babylonjs/core/Engines/WebGPU/Extensions/engine.multiRender.js'
import '@babylonjs/core/Layers/effectLayerSceneComponent.js'
import '@babylonjs/core/Materials/colorCurves.js'
import '@babylonjs/core/Meshes/instancedMesh.js'
import '@babylonjs/core/Rendering/depthRendererSceneComponent.js'
import '@babylonjs/core/Rendering/geometryBufferRendererSceneComponent.js'
import '@babylonjs/core/Rendering/outlineRenderer.js'
import '@babylonjs/core/Rendering/prePassRendererSceneComponent.js'
import { ArcRotateCamera } from '@babylonjs/core/Cameras/arcRotateCamera.js'
import { GPUPicker } from '@babylonjs/core/Collisions/gpuPicker.js'
import { Constants } from '@babylonjs/core/Engines/constants.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { GlowLayer } from '@babylonjs/core/Layers/glowLayer.js'
import { HighlightLayer } from '@babylonjs/core/Layers/highlightLayer.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { Material } from '@babylonjs/core/Materials/material.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { SSAO2RenderingPipeline } from '@babylonjs/core/PostProcesses/RenderPipeline/Pipelines/ssao2RenderingPipeline.js'
import '@babylonjs/core/PostProcesses/RenderPipeline/postProcessRenderPipelineManagerSceneComponent.js'
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js'
import { Color3 } from '@babylonjs/core/Maths/math.color.js'
import { Matrix, Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'
import { Scene } from '@babylonjs/core/scene.js'
import * as warpjet from 'warpjet/babylon'
import { addTorus, alongNormal } from './torus.js'

const { BabylonWarp, addSurfaceVariation } = warpjet
const size = 96

const motion = Matrix.Compose(
  Vector3.One(),
  Quaternion.FromEulerAngles(0.4, 0.7, -0.3),
  new Vector3(0.3, 0.2, -0.15),
)

const engines = {}
async function getEngine(backend) {
  if (engines[backend]) return engines[backend]
  const canvas = document.body.appendChild(document.createElement('canvas'))
  canvas.width = canvas.height = size
  if (backend === 'webgl')
    return (engines[backend] = new Engine(canvas, false, {
      preserveDrawingBuffer: true,
      stencil: true,
    }))
  const engine = new WebGPUEngine(canvas, { antialias: false, stencil: true })
  await engine.initAsync()
  return (engines[backend] = engine)
}

const linearOf = ({ m }) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]]

export function warpByMotion(material, matrix = motion) {
  return new BabylonWarp(
    material,
    ({ position, uniforms }) =>
      uniforms.linear.mult(position).sub(position).add(uniforms.shift.mult(1)),
    {
      uniforms: {
        linear: linearOf(matrix),
        shift: Vector3.TransformCoordinates(Vector3.Zero(), matrix),
      },
    },
  )
}

/** Warps with the same motion, and reads the normal and the uv without effect. */
const warpReadingAll = (material) => {
  const { m } = motion
  return new BabylonWarp(
    material,
    ({ position, normal, uv, uniforms }) =>
      uniforms.linear
        .mult(position)
        .sub(position)
        .add(
          uniforms.shift.mult(
            normal.dot(normal).mult(uniforms.zero).add(uv.x().mult(uniforms.zero)).add(1),
          ),
        ),
    {
      uniforms: { linear: linearOf(motion), shift: [m[12], m[13], m[14]], zero: 0 },
      surfaceVariation: false,
      normals: 'pixel',
    },
  )
}

function moveByMatrix(mesh, matrix = motion) {
  matrix.decompose(mesh.scaling, (mesh.rotationQuaternion = new Quaternion()), mesh.position)
}

async function makeScene(backend) {
  const scene = new Scene(await getEngine(backend))
  const camera = new ArcRotateCamera('camera', 0.7, 1.1, 4, Vector3.Zero(), scene)
  Object.assign(camera, { minZ: 0.1, maxZ: 8 })
  new HemisphericLight('sky', new Vector3(0.3, 1, 0.2), scene)
  return scene
}

let retired
/** Disposes of a scene after the next one has been drawn. If it was disposed of at once, Babylon.js would recompile the shaders. */
function retire(scene) {
  retired?.dispose()
  retired = scene
}

const materials = {
  Standard: (scene) => new StandardMaterial('standard', scene),
  PBR: (scene) => Object.assign(new PBRMaterial('pbr', scene), { metallic: 0.1, roughness: 0.5 }),
}

function addKnot(scene, material) {
  const options = { radius: 0.5, tube: 0.18, radialSegments: 64, tubularSegments: 12 }
  const knot = MeshBuilder.CreateTorusKnot('knot', options, scene)
  knot.material = material
  return knot
}

/** Draws some frames, after all shaders have been compiled. */
async function drawFrames(scene, count = 4) {
  const engine = scene.getEngine()
  await scene.whenReadyAsync()
  for (let i = 0; i < count; i++) {
    engine.beginFrame()
    scene.render()
    engine.endFrame()
    await new Promise((drawn) => setTimeout(drawn, 20))
  }
}

/** Reads a texture as numbers from 0 to 1. */
const readTexture = async (texture, scale = 1 / 255) => {
  const pixels = await texture.readPixels()
  return Array.from(pixels, (x) => x * scale)
}

const renderColor = (scene) => {
  const target = new RenderTargetTexture('target', size, scene)
  scene.activeCamera.outputRenderTarget = target
  return async () => {
    await drawFrames(scene)
    return readTexture(target)
  }
}

/**
 * Maps the name of a pass → a function that prepares it and returns another that draws it → the picture, with one or four numbers per
 * pixel.
 */
const passes = {
  depth(scene) {
    const map = scene.enableDepthRenderer(scene.activeCamera, false, true).getDepthMap()
    return async () => {
      await drawFrames(scene)
      return readTexture(map, 1)
    }
  },
  outline(scene, knot) {
    Object.assign(knot, { renderOutline: true, outlineWidth: 0.08, outlineColor: Color3.Red() })
    return renderColor(scene)
  },
  highlight(scene, knot) {
    const layer = new HighlightLayer('highlight', scene, { mainTextureFixedSize: size })
    layer.addMesh(knot, Color3.Green())
    return async () => {
      await drawFrames(scene)
      return readTexture(layer._mainTexture)
    }
  },
  glow(scene, knot) {
    const layer = new GlowLayer('glow', scene, { mainTextureFixedSize: size })
    knot.material.emissiveColor = new Color3(0.8, 0.4, 0.2)
    return async () => {
      await drawFrames(scene)
      return readTexture(layer._mainTexture)
    }
  },
  'G-buffer, normals': (scene) => useGBuffer(scene, 1),
  'G-buffer, positions': (scene) => useGBuffer(scene, 2),
  'prepass, normals': (scene) => usePrepass(scene, Constants.PREPASS_NORMAL_TEXTURE_TYPE),
  picking(scene, knot) {
    const picker = new GPUPicker()
    picker.setPickingList([knot])
    return async () => {
      await drawFrames(scene)
      // A rectangle with a width of 64: in WebGPU, where rows are a multiple of 256 bytes, Babylon.js 9.34 reads other widths wrongly.
      const points = Array.from({ length: 22 * 22 }, (_, i) => ({
        x: 16 + 3 * (i % 22),
        y: 16 + 3 * Math.floor(i / 22),
      }))
      let result
      void picker.multiPickAsync(points).then((picked) => (result = picked))
      // The picker returns its result after one of the next frames.
      for (let i = 0; i < 100 && !result; i++) await drawFrames(scene, 1)
      if (!result) throw new Error('GPUPicker gave no answer in 100 frames')
      picker.dispose()
      return result.meshes.map((mesh) => (mesh ? 1 : 0))
    }
  },
}

function useGBuffer(scene, index) {
  const renderer = scene.enableGeometryBufferRenderer()
  renderer.enablePosition = true
  return async () => {
    await drawFrames(scene)
    return readTexture(renderer.getGBuffer().textures[index], 1)
  }
}

/** Adds ambient occlusion, which reads the prepass. */
function usePrepass(scene, type) {
  new SSAO2RenderingPipeline('occlusion', scene, 1, [scene.activeCamera])
  const renderer = scene.prePassRenderer
  return async () => {
    await drawFrames(scene)
    return readTexture(renderer.defaultRT.textures[renderer.getIndex(type)], 1)
  }
}

/**
 * Maps a name → how the scene differs: `warp` replaces `warpByMotion`; `add(scene, make)`, where `make` makes a material, and
 * `change(knot)` are called in scenes with and without a warp.
 */
const variants = {
  plain: {},
  'with normal and uv': { warp: warpReadingAll },
  // Two meshes with the same kind of material next to the warped one: one has another warp, the other has none.
  'beside others': {
    add(scene, make) {
      for (const [i, matrix] of [Matrix.Translation(-0.8, 0, 0), Matrix.Identity()].entries()) {
        const other = addKnot(scene, make(scene))
        other.scaling.scaleInPlace(0.4)
        other.position = new Vector3(0.9, 0.9 - 1.8 * i, 0)
        if (i) continue
        const { m } = matrix
        // The code of this warp differs, since the shift is a constant.
        new BabylonWarp(other.material, ({ glsl }) => glsl.vec3(m[12], m[13], m[14]))
      }
    },
  },
  'as instances': {
    change(knot) {
      for (const x of [-0.5, 0.6]) {
        const instance = knot.createInstance('instance')
        instance.scaling.scaleInPlace(0.5)
        instance.position = new Vector3(x, -0.6, 0.3)
      }
    },
    // A matrix of the mesh would not move its instances, so the motion is baked into the vertices of the reference.
    isBaked: true,
  },
}

/** Caches pictures that several variants share. */
const cache = new Map()

function drawCached(backend, kind, passName, way, variantName) {
  const { add, change } = variants[variantName]
  if (way === 'warped' || add || change) return draw(backend, kind, passName, way, variantName)
  const key = [backend, kind, passName, way].join()
  if (!cache.has(key)) cache.set(key, draw(backend, kind, passName, way, variantName))
  return cache.get(key)
}

async function draw(backend, kind, passName, way, variantName) {
  const scene = await makeScene(backend)
  const make = materials[kind]
  const { warp = warpByMotion, add, change, isBaked } = variants[variantName]
  const knot = addKnot(scene, make(scene))
  if (way === 'warped') warp(knot.material)
  if (way === 'moved' && isBaked) knot.bakeTransformIntoVertices(motion)
  else if (way === 'moved') moveByMatrix(knot)
  add?.(scene, make)
  change?.(knot)
  const read = passes[passName](scene, knot)
  const picture = await read()
  retire(scene)
  return picture
}

function countDiffering(a, b) {
  const channels = a.length > size * size ? a.length / (size * size) : 1
  let count = 0
  for (let i = 0; i < a.length; i += channels)
    if (
      Array.from({ length: channels }, (_, k) => Math.abs(a[i + k] - b[i + k])).some(
        (d) => !(d <= 12 / 255),
      )
    )
      count++
  return count
}

/** The depth pass is drawn in all variants, the others in two. */
window.rows = Object.keys(passes).flatMap((pass, i) =>
  Object.keys(variants)
    .slice(0, i ? 2 : undefined)
    .map((variant) => [i % 2 ? 'Standard' : 'PBR', pass, variant]),
)

/** Returns numbers of pixels: `differing` between the warped and the moved mesh, and `moved` between the moved mesh and one at rest. */
window.compare = async (backend, kind, pass, variant) => {
  const [still, moved, warped] = [
    await drawCached(backend, kind, pass, 'still', variant),
    await drawCached(backend, kind, pass, 'moved', variant),
    await drawCached(backend, kind, pass, 'warped', variant),
  ]
  return { differing: countDiffering(warped, moved), moved: countDiffering(still, moved) }
}

/** Compares like `compare`, with a copy of the warped material that is made by `clone` or parsed from serialized data, as `how` says. */
window.compareCopy = async (backend, kind, how) => {
  const pictures = []
  for (const way of ['still', 'moved', 'warped']) {
    const scene = await makeScene(backend)
    const material = materials[kind](scene)
    const knot = addKnot(scene, material)
    if (way === 'moved') moveByMatrix(knot)
    if (way === 'warped') {
      const warp = warpByMotion(material, Matrix.Identity())
      const { m } = motion
      Object.assign(warp.values, { linear: linearOf(motion), shift: [m[12], m[13], m[14]] })
      knot.material =
        how === 'clone'
          ? material.clone('copy')
          : Material.Parse(JSON.parse(JSON.stringify(material.serialize())), scene, '')
      // The copy does not follow the original.
      warp.values.shift = [5, 5, 5]
    }
    pictures.push(await renderColor(scene)())
    retire(scene)
  }
  const [still, moved, warped] = pictures
  return { differing: countDiffering(warped, moved), moved: countDiffering(still, moved) }
}

/** Parses a material that another page has serialized. Returns whether it has no warp, as expected. */
window.parseForeign = async () => {
  const scene = await makeScene('webgl')
  const material = materials.Standard(scene)
  warpByMotion(material)
  const data = JSON.parse(JSON.stringify(material.serialize()))
  data.plugins.BabylonWarp.warpjet = 'from another page'
  const parsed = Material.Parse(data, scene, '')
  const isPlain = !parsed.pluginManager?.getPlugin('Warpjet')
  scene.dispose()
  return isPlain
}

/** Draws a warped torus and one with the same waves as geometry; `isExact` adds the variation of the surface. */
window.torus = async (backend, kind, isExact) => {
  const pictures = []
  for (const way of ['still', 'moved', 'warped']) {
    const scene = await makeScene(backend)
    const torus = addTorus(scene, { isMoved: way === 'moved' })
    torus.material = Object.assign(materials[kind](scene), {
      backFaceCulling: false,
      twoSidedLighting: true,
    })
    if (way === 'warped') {
      if (isExact) await addSurfaceVariation?.(torus)
      new BabylonWarp(
        torus.material,
        alongNormal,
        isExact || !addSurfaceVariation ? {} : { surfaceVariation: false },
      )
    }
    pictures.push(await renderColor(scene)())
    retire(scene)
  }
  const [still, moved, warped] = pictures
  return { differing: countDiffering(warped, moved), moved: countDiffering(still, moved) }
}

// Keeps navigator.gpu alive; otherwise the browser loses the device.
window.gpu = navigator.gpu
document.title = 'ready'
