// Draws meshes with a warped material into float pictures: the normal that is shown at each pixel, and the unwarped position, normal and
// uv.
import '@babylonjs/core/Engines/Extensions/engine.readTexture.js'
import '@babylonjs/core/Engines/WebGPU/Extensions/engine.readTexture.js'
import '@babylonjs/core/Materials/Textures/baseTexture.polynomial.js'
import '@babylonjs/core/Meshes/thinInstanceMesh.js'
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Constants } from '@babylonjs/core/Engines/constants.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { ShaderStore } from '@babylonjs/core/Engines/shaderStore.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { RawCubeTexture } from '@babylonjs/core/Materials/Textures/rawCubeTexture.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { Color4 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { SphericalPolynomial } from '@babylonjs/core/Maths/sphericalPolynomial.js'
import { Scene } from '@babylonjs/core/scene.js'
import { BabylonWarp, addSurfaceVariation } from 'warpjet/babylon'
import { shapes, uneven } from './shapes.js'
import { Shown } from './shown.js'

const engines = {}
async function getEngine(backend) {
  if (engines[backend]) return engines[backend]
  const canvas = document.body.appendChild(document.createElement('canvas'))
  if (backend.startsWith('webgl')) {
    const engine = (engines[backend] = new Engine(canvas, false))
    engine.disableUniformBuffers = backend === 'webgl without uniform buffers'
    return engine
  }
  const engine = new WebGPUEngine(canvas, { antialias: false })
  await engine.initAsync()
  return (engines[backend] = engine)
}

const scenes = {}
async function getScene(backend) {
  if (scenes[backend]) return scenes[backend]
  const scene = new Scene(await getEngine(backend))
  const camera = new FreeCamera('eye', new Vector3(0, 0, -10), scene)
  camera.setTarget(Vector3.Zero())
  camera.mode = 1
  camera.orthoLeft = camera.orthoBottom = -1.4
  camera.orthoRight = camera.orthoTop = 1.4
  new DirectionalLight('sun', new Vector3(0.5, -0.6, 1), scene)
  return (scenes[backend] = scene)
}

const offsets = {
  floor: ({ position }) => position.mult(3).floor().div(3).sub(position),
  mirror: ({ position, glsl }) => glsl.vec3(position.x().mult(-2), 0, 0),
  'mirror by uniforms': ({ position, glsl, uniforms }) =>
    glsl.vec3(position.x().mult(uniforms.factor), 0, 0),
  still: ({ position }) => position.mult(0),
  'wave by uniforms': ({ glsl, position, color, millis, uniforms }) =>
    glsl.vec3(
      position.y().mult(7).add(millis.div(500)).sin().mult(uniforms.heights.x()).mult(color.x()),
      glsl.texture(uniforms.map, position.xy()).x().mult(position.x().mult(6).sin()).mult(0.1),
      0,
    ),
}

/** Adds offsets to `offsets`; `sources` maps names to source code. */
window.addOffsets = (sources) => {
  for (const [name, source] of Object.entries(sources)) offsets[name] = (0, eval)(source)
}

const constantMap = (scene, bytes) =>
  new RawTexture(
    Uint8Array.from({ length: 16 }, (_, i) => bytes[i % 4]),
    2,
    2,
    Constants.TEXTUREFORMAT_RGBA,
    scene,
    false,
    false,
    Constants.TEXTURE_NEAREST_SAMPLINGMODE,
  )

const makeMaterial = (kind, scene) =>
  kind === 'PBR'
    ? Object.assign(new PBRMaterial('pbr', scene), { metallic: 0, roughness: 0.5 })
    : new StandardMaterial('standard', scene)

function uniformsFor(warp, scene) {
  if (warp === 'mirror by uniforms') return { factor: -2 }
  if (warp === 'wave by uniforms')
    return { heights: new Vector3(0.2, 0, 0), map: constantMap(scene, [255, 0, 0, 255]) }
  return {}
}

/** The texel that fills the normal map. Its normal is oblique. */
const obliqueTexel = [190, 100, 225, 255]

/** Makes an environment texture with diffuse light from above, which Babylon.js computes at vertices. */
function makeSurroundings(scene) {
  const faces = Array.from({ length: 6 }, () => new Uint8Array([9, 9, 9, 255]))
  const texture = new RawCubeTexture(scene, faces, 1)
  texture.sphericalPolynomial = Object.assign(new SphericalPolynomial(), {
    y: new Vector3(1, 0.5, 0.2),
    yy: new Vector3(1, 1, 1),
  })
  return texture
}

/** Caches materials and meshes. */
const made = new Map()
async function make(backend, { kind, shape, warp, normals, bump, twoSided, irradiance }) {
  const key = JSON.stringify([backend, kind, warp, normals, bump, twoSided, irradiance])
  const scene = await getScene(backend)
  if (!made.has(key)) {
    const material = makeMaterial(kind, scene)
    // The oracle also sees the back of a surface.
    material.backFaceCulling = false
    material.twoSidedLighting = !!twoSided
    if (bump) material.bumpTexture = constantMap(scene, obliqueTexel)
    if (bump === 'all') {
      Object.assign(material.clearCoat, {
        isEnabled: true,
        bumpTexture: constantMap(scene, obliqueTexel),
      })
      material.anisotropy.isEnabled = true
    }
    if (irradiance) material.reflectionTexture = makeSurroundings(scene)
    if (irradiance === 'fragment') material.forceIrradianceInFragment = true
    const shown = new Shown(material)
    const warped = new BabylonWarp(material, offsets[warp], {
      normals,
      fadeNoise: false,
      uniforms: uniformsFor(warp, scene),
    })
    warped.millis = 100
    made.set(key, { material, shown, warped })
  }
  const meshKey = `${backend} ${shape}`
  if (!made.has(meshKey)) {
    const mesh = shapes[shape](scene)
    if (mesh.isVerticesDataPresent('normal')) await addSurfaceVariation(mesh)
    made.set(meshKey, mesh)
  }
  return { scene, mesh: made.get(meshKey), ...made.get(key) }
}

/** Positions the mesh, and returns its matrix from local to world space. */
function place(mesh, how) {
  mesh.rotation.set(0.5, 0.4, 0)
  mesh.scaling.set(1, 0.8, 0.9)
  if (how === 'mirrored') mesh.scaling.x = -1
  mesh.thinInstanceCount = 0
  if (how === 'thin instance') mesh.thinInstanceAdd(uneven)
  mesh.skeleton?.prepare()
  const world = mesh.computeWorldMatrix(true)
  const isMoved = how === 'thin instance' || mesh.skeleton
  return [...(isMoved ? uneven.multiply(world) : world).asArray()]
}

const encode = (numbers) => {
  const bytes = new Uint8Array(Float32Array.from(numbers).buffer)
  let encoded = ''
  for (let i = 0; i < bytes.length; i += 8192)
    encoded += String.fromCharCode(...bytes.subarray(i, i + 8192))
  return btoa(encoded)
}

/** Draws a float picture, from the top row, of each value in `shows`. Returns these, the matrices and, if `withMesh`, the mesh. */
window.draw = async (backend, { shows, how, size = 160, withMesh, isOff, ...madeOf }) => {
  const { scene, mesh, material, shown, warped } = await make(backend, madeOf)
  const engine = scene.getEngine()
  const target = new RenderTargetTexture('target', size, scene, {
    type: Constants.TEXTURETYPE_FLOAT,
    generateMipMaps: false,
    samplingMode: Constants.TEXTURE_NEAREST_SAMPLINGMODE,
  })
  target.activeCamera = scene.activeCamera
  target.clearColor = new Color4(0, 0, 0, 0)
  target.renderList = [mesh]
  mesh.material = material
  mesh.alwaysSelectAsActiveMesh = true
  if (warped.isEnabled === !!isOff) warped.isEnabled = !isOff
  const world = place(mesh, how)
  await material.forceCompilationAsync(mesh, { useInstances: how === 'thin instance' })
  for (let i = 0; i < 200 && !target.isReadyForRendering(); i++)
    await new Promise((wait) => setTimeout(wait, 25))
  const pictures = {}
  for (const name of shows) {
    shown.shown = name
    engine.beginFrame()
    target.render()
    engine.endFrame()
    const pixels = await target.readPixels()
    const numbers = new Float32Array(pixels.buffer, pixels.byteOffset, pixels.byteLength / 4)
    const rows = Array.from({ length: size }, (_, y) => {
      const from = 4 * size * (size - 1 - y)
      return numbers.subarray(from, from + 4 * size)
    })
    pictures[name] = encode(rows.flatMap((row) => [...row]))
  }
  target.dispose()
  mesh.thinInstanceCount = 0
  const camera = scene.activeCamera
  const toClip = [...camera.getViewMatrix().multiply(camera.getProjectionMatrix()).asArray()]
  const result = { pictures, world, toClip, normals: warped.normals }
  return withMesh ? { ...result, mesh: describe(mesh) } : result
}

function describe(mesh) {
  const read = (kind) => [...(mesh.getVerticesData(kind) ?? [])]
  const gradients = ['normalXGradient', 'normalYGradient', 'normalZGradient', 'uGradient']
  return {
    positions: read('position'),
    normals: read('normal'),
    uvs: read('uv'),
    indices: [...mesh.getIndices()],
    gradients: [...gradients, 'vGradient'].map((name) => read(`aWarpjet_${name}`)),
  }
}

/**
 * Returns the stage of a material's normals before and after it is compiled with few varyings (`why` names them) or with a shader that
 * lacks the line that we replace ('shader').
 */
window.fallBack = async (backend, normals, why) => {
  const scene = await getScene(backend)
  const caps = scene.getEngine().getCaps()
  const { maxVaryingVectors } = caps
  if (why === 'varyings') caps.maxVaryingVectors = 6
  // Babylon.js passes position and normal, and the warp 5 vectors; vertex colors are one more.
  if (/7 varyings/.test(why)) caps.maxVaryingVectors = 7
  const material = new StandardMaterial('standard', scene)
  if (why === 'shader') {
    const store = backend === 'webgpu' ? ShaderStore.ShadersStoreWGSL : ShaderStore.ShadersStore
    store.otherVertexShader = store.defaultVertexShader
    store.otherPixelShader = store.defaultPixelShader.replace(
      /normalize\((fragmentInputs\.)?vNormalW\)/,
      'normalize(1.0*$1vNormalW)',
    )
    material.customShaderNameResolve = () => 'other'
  }
  const warped = new BabylonWarp(material, offsets.simplex, { normals })
  const before = warped.normals
  const target = new RenderTargetTexture('target', 32, scene)
  target.activeCamera = scene.activeCamera
  for (const mesh of [shapes.sphere(scene), shapes.torus(scene)]) {
    mesh.material = material
    if (why === 'colors and 7 varyings')
      mesh.setVerticesData('color', new Float32Array(4 * mesh.getTotalVertices()).fill(1))
    target.renderList.push(mesh)
    await material.forceCompilationAsync(mesh)
  }
  for (let i = 0; i < 200 && !target.isReadyForRendering(); i++)
    await new Promise((wait) => setTimeout(wait, 25))
  for (let i = 0; i < 2; i++) {
    scene.getEngine().beginFrame()
    target.render()
    scene.getEngine().endFrame()
  }
  for (const mesh of target.renderList) mesh.dispose()
  target.dispose()
  caps.maxVaryingVectors = maxVaryingVectors
  return [before, warped.normals]
}

window.leaning = obliqueTexel
// Keeps navigator.gpu alive; otherwise the browser loses the device.
window.gpu = navigator.gpu
document.title = 'ready'
