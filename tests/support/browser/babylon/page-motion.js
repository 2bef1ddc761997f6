// Compares meshes that a warp moves linearly with meshes that Babylon.js moves by the same matrix, in pictures and by rays. Also collects
// the messages of mistakes.
import { ArcRotateCamera } from '@babylonjs/core/Cameras/arcRotateCamera.js'
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import '@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js'
import { Constants } from '@babylonjs/core/Engines/constants.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js'
import { MultiMaterial } from '@babylonjs/core/Materials/multiMaterial.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { Matrix, Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'
import { Scene } from '@babylonjs/core/scene.js'
import { BabylonWarp } from 'warpjet/babylon'

const size = 96
const motion = Matrix.Compose(
  Vector3.One(),
  Quaternion.FromEulerAngles(0.4, 0.7, -0.3),
  new Vector3(0.2, 0.1, -0.15),
)
const m = motion.m
const translation = [0.3, -0.2, 0.25]

const offset = ({ position, millis, uniforms }) =>
  uniforms.linear
    .mult(position)
    .sub(position)
    .add(uniforms.shift.mult(millis.div(1000)))

const engines = {}
async function getEngine(backend) {
  if (engines[backend]) return engines[backend]
  const canvas = document.body.appendChild(document.createElement('canvas'))
  canvas.width = canvas.height = size
  if (backend === 'webgl')
    return (engines[backend] = new Engine(canvas, false, { preserveDrawingBuffer: true }))
  const engine = new WebGPUEngine(canvas, { antialias: false })
  await engine.initAsync()
  return (engines[backend] = engine)
}

function makeScene(engine, kind) {
  const scene = new Scene(engine)
  const camera = new ArcRotateCamera('camera', 0.7, 1.1, 4, Vector3.Zero(), scene)
  camera.minZ = 0.1
  new HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 0.3
  const sun = new DirectionalLight('sun', new Vector3(-0.5, -1, -0.6), scene)
  sun.position = new Vector3(2, 4, 3)
  Object.assign(sun, { shadowMinZ: 1, shadowMaxZ: 12, autoUpdateExtends: false })
  Object.assign(sun, { orthoLeft: -3, orthoRight: 3, orthoTop: 3, orthoBottom: -3 })
  const ground = MeshBuilder.CreateGround('ground', { width: 8, height: 8 }, scene)
  ground.position.y = -1
  ground.receiveShadows = true
  const knot = MeshBuilder.CreateTorusKnot(
    'knot',
    { radius: 0.5, tube: 0.18, radialSegments: 64, tubularSegments: 12 },
    scene,
  )
  const material =
    kind === 'PBR' ? new PBRMaterial('pbr', scene) : new StandardMaterial('standard', scene)
  if (kind === 'PBR') Object.assign(material, { metallic: 0.1, roughness: 0.5 })
  knot.material = material
  const generator = new ShadowGenerator(256, sun)
  generator.addShadowCaster(knot)
  return { scene, knot, material }
}

/** Moves the mesh with a matrix of Babylon.js itself. */
function moveByMatrix(knot, matrix = motion) {
  knot.setPivotMatrix(Matrix.Identity())
  matrix.decompose(knot.scaling, (knot.rotationQuaternion = new Quaternion()), knot.position)
}

function warpByMotion(material, normals) {
  const warp = new BabylonWarp(material, offset, {
    normals,
    uniforms: { linear: [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]], shift: [0, 0, 0] },
  })
  warp.values.shift = new Vector3(m[12], m[13], m[14])
  warp.millis = 1000
  return warp
}

/** A reflection in x, followed by the motion. */
const mirroredMotion = Matrix.Scaling(-1, 1, 1).multiply(motion)
const linearOf = (m) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]]
/** Warps by `mirroredMotion`, whose numbers are constants of the code or uniforms. */
const mirrorWarps = {
  constant: (material, normals) =>
    new BabylonWarp(
      material,
      ({ glsl, position }) => {
        const [a, b, c, d, e, f, g, h, i] = linearOf(mirroredMotion.m)
        return glsl
          .mat3(glsl.vec3(a, b, c), glsl.vec3(d, e, f), glsl.vec3(g, h, i))
          .mult(position)
          .sub(position)
          .add(glsl.vec3(mirroredMotion.m[12], mirroredMotion.m[13], mirroredMotion.m[14]))
      },
      { normals },
    ),
  uniform: (material, normals) => {
    const warp = new BabylonWarp(material, offset, {
      normals,
      uniforms: {
        linear: linearOf(mirroredMotion.m),
        shift: new Vector3(mirroredMotion.m[12], mirroredMotion.m[13], mirroredMotion.m[14]),
      },
    })
    warp.millis = 1000
    return warp
  },
}

/** A time of more than a day, at which `millis` is no longer exact in float32. */
const lateMillis = 98_765_432
const phases = {
  exact: (lateMillis / 90) % (2 * Math.PI),
  rounded: Math.fround(lateMillis / 90) % (2 * Math.PI),
}
/** Warps by a wave whose phase is computed from `millis`, or is a uniform: the exact phase or the one rounded to float32. */
function addWave(material, phaseFrom) {
  const warp = new BabylonWarp(
    material,
    ({ glsl, position, millis, uniforms }) => {
      const phase = phaseFrom === 'millis' ? millis.div(90) : uniforms.phase
      return glsl.vec3(position.y.mult(4).add(phase).sin().mult(0.25), 0, 0)
    },
    { uniforms: { phase: phases[phaseFrom] ?? 0 } },
  )
  warp.millis = lateMillis
}

/** Removes the transformation of normals from the shaders of both languages. */
function removeNormals(warp, material) {
  const { getCustomCode } = warp
  warp.getCustomCode = (...args) => {
    const code = getCustomCode.apply(warp, args)
    const withoutNormals = code?.CUSTOM_VERTEX_UPDATE_NORMAL?.replaceAll(
      'normalUpdated = warpjetNormal;',
      '',
    )
    return withoutNormals ? { ...code, CUSTOM_VERTEX_UPDATE_NORMAL: withoutNormals } : code
  }
  material.markDirty(true)
}

function warpByImage(material, scene) {
  const texels = Float32Array.from({ length: 16 }, (_, i) => [...translation, 1][i % 4])
  const map = new RawTexture(
    texels,
    2,
    2,
    Constants.TEXTUREFORMAT_RGBA,
    scene,
    false,
    false,
    Constants.TEXTURE_NEAREST_SAMPLINGMODE,
    Constants.TEXTURETYPE_FLOAT,
  )
  new BabylonWarp(material, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
    uniforms: { map },
    surfaceVariation: false,
  })
}

/** Warps with a texture that is sampled with its own settings, or with the same settings as options of glsl.texture. */
function warpBySampling(material, scene, isByOptions) {
  const bytes = Uint8Array.from({ length: 4 * 15 }, (_, i) => (i * 89) % 256)
  const map = new RawTexture(
    bytes,
    5,
    3,
    Constants.TEXTUREFORMAT_RGBA,
    scene,
    false,
    false,
    Constants.TEXTURE_BILINEAR_SAMPLINGMODE,
  )
  Object.assign(map, {
    wrapU: Constants.TEXTURE_MIRROR_ADDRESSMODE,
    wrapV: Constants.TEXTURE_MIRROR_ADDRESSMODE,
    uScale: 1.7,
    vScale: 2.2,
    uOffset: 0.2,
    vOffset: -0.4,
  })
  const sampleByOptions = ({ glsl, uv, uniforms }) =>
    glsl.texture(uniforms.map, uv.mult(glsl.vec2(1.7, 2.2)).add(glsl.vec2(0.2, -0.4)), {
      wrap: 'mirror',
      filter: 'bilinear',
      transform: false,
    })
  const sampleBySettings = ({ glsl, uv, uniforms }) => glsl.texture(uniforms.map, uv)
  const sample = isByOptions ? sampleByOptions : sampleBySettings
  new BabylonWarp(material, (inputs) => sample(inputs).xyz().mult(0.4), {
    uniforms: { map },
    surfaceVariation: false,
  })
}

/** Draws the knot; `kind` is the class of its material, and `way` says how the knot is moved or warped. Returns the picture as bytes. */
window.draw = async (backend, kind, way) => {
  const engine = await getEngine(backend)
  const { scene, knot, material } = makeScene(engine, kind)
  // The picture on a canvas is lost after the frame.
  const target = new RenderTargetTexture('target', size, scene)
  scene.activeCamera.outputRenderTarget = target
  if (way === 'moved') moveByMatrix(knot)
  if (/mirror/.test(way))
    Object.assign(material, { backFaceCulling: false, twoSidedLighting: true })
  if (way === 'mirrored') moveByMatrix(knot, mirroredMotion)
  if (way === 'mirroring, switched off') {
    const warp = mirrorWarps.constant(material)
    await scene.whenReadyAsync()
    warp.isEnabled = false
  }
  const [, mirrorWarp, , stage] = /^mirroring, (\w+)(, at (\w+))?/.exec(way) ?? []
  mirrorWarps[mirrorWarp]?.(material, stage)
  if (way === 'shifted') moveByMatrix(knot, Matrix.Translation(...translation))
  if (way === 'by an image') warpByImage(material, scene)
  if (way.startsWith('wave by ')) addWave(material, way.split(' ')[2])
  if (way.startsWith('sampled by')) warpBySampling(material, scene, way === 'sampled by options')
  if (['warped', 'warped at pixel', 'without its normals', 'without its shadow'].includes(way)) {
    // `removeNormals` only finds normals that are computed at vertices.
    const warp = warpByMotion(material, way === 'warped at pixel' ? 'pixel' : 'vertex')
    if (way === 'without its normals') removeNormals(warp, material)
    if (way === 'without its shadow') material.shadowDepthWrapper = null
  }
  if (way === 'switched off') {
    const warp = warpByMotion(material)
    await scene.whenReadyAsync()
    warp.isEnabled = false
  }
  await scene.whenReadyAsync()
  for (let i = 0; i < 4; i++) {
    engine.beginFrame()
    scene.render()
    engine.endFrame()
    // Babylon.js makes the shaders of shadows after those of the surface.
    await new Promise((drawn) => setTimeout(drawn, 20))
  }
  const pixels = await target.readPixels()
  scene.dispose()
  return [...new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength)]
}

/**
 * Casts the same rays at a warped mesh and at one that a matrix moves. Returns the number of rays that hit both meshes (`hits`) and only
 * one of them (`misses`), the max distance between the two hits of a ray, the number of rays that differed before the call of `refresh`
 * (`differingBefore`), and whether a vertex is outside of the bounding box.
 */
window.pick = async () => {
  const engine = await getEngine('webgl')
  const { scene, knot, material } = makeScene(engine, 'Standard')
  const { scene: referenceScene, knot: reference } = makeScene(engine, 'Standard')
  moveByMatrix(reference)
  reference.computeWorldMatrix(true)
  const warp = warpByMotion(material)
  let [hits, misses, maxDistance, differingBefore] = [0, 0, 0, 0]
  const rays = Array.from({ length: 300 }, (_, i) => {
    const from = new Vector3(4 * Math.cos(i), 2 * Math.sin(3 * i), 4 * Math.sin(i))
    const to = new Vector3(Math.sin(5 * i), Math.cos(7 * i), Math.sin(11 * i)).scale(0.6)
    return new Ray(from, to.subtract(from).normalize(), 10)
  })
  const pick = (ray, scene, mesh) => scene.pickWithRay(ray, (each) => each === mesh)
  for (const ray of rays) {
    const [a, b] = [pick(ray, scene, knot), pick(ray, referenceScene, reference)]
    if (a.hit !== b.hit || (a.hit && Vector3.Distance(a.pickedPoint, b.pickedPoint) > 1e-3))
      differingBefore++
  }
  warp.refresh(knot)
  for (const ray of rays) {
    const [a, b] = [pick(ray, scene, knot), pick(ray, referenceScene, reference)]
    if (a.hit !== b.hit) misses++
    else if (a.hit) {
      hits++
      maxDistance = Math.max(maxDistance, Vector3.Distance(a.pickedPoint, b.pickedPoint))
    }
  }
  const box = (mesh) => mesh.getBoundingInfo().boundingBox
  const { minimumWorld: min, maximumWorld: max } = box(knot)
  const outside =
    knot.getPositionData().length > 0 &&
    reference.getPositionData().some((_, i, all) => {
      if (i % 3) return false
      const p = Vector3.TransformCoordinates(new Vector3(all[i], all[i + 1], all[i + 2]), motion)
      return (
        p.x < min.x - 1e-5 ||
        p.y < min.y - 1e-5 ||
        p.z < min.z - 1e-5 ||
        p.x > max.x + 1e-5 ||
        p.y > max.y + 1e-5 ||
        p.z > max.z + 1e-5
      )
    })
  scene.dispose()
  referenceScene.dispose()
  return { hits, misses, maxDistance, differingBefore, outside }
}

/** Collects the messages of mistakes. */
window.mistakes = async () => {
  const { scene, material } = makeScene(await getEngine('webgl'), 'Standard')
  const warp = warpByMotion(material)
  const warpOther = (offset, uniforms) =>
    new BabylonWarp(new StandardMaterial('other', scene), offset, { uniforms })
  const errors = [
    () => (warp.values.linaer = 3),
    () => (warp.values.shift = 'x'),
    () => (warp.values.shift = [0, NaN, 0]),
    () => (warp.millis = 'x'),
    () => new BabylonWarp(material, offset),
    () => warpOther(({ glsl, mouse }) => glsl.vec3(mouse, 0)),
    () => warpOther(({ glsl }) => glsl.vec3(glsl.param('wind'), 0, 0)),
    () => warpOther(({ glsl }) => glsl.vec3(0, 0, 0), { map: { width: 1, height: 1 } }),
    () => new BabylonWarp(new MultiMaterial('parts', scene), offset),
    () => new BabylonWarp(new StandardMaterial('other', scene), offset, { unifroms: {} }),
    () => new BabylonWarp(new StandardMaterial('other', scene), offset, { surfaceVariation: true }),
    () => new BabylonWarp({ name: 'red' }, offset),
  ].map((makeMistake) => {
    try {
      makeMistake()
      return ''
    } catch (error) {
      return String(error)
    }
  })
  const { x } = warp.values.shift
  scene.dispose()
  return { errors, isUnchanged: x === m[12] && warp.millis === 1000 }
}
// Keeps navigator.gpu alive; otherwise the browser loses the device.
window.gpu = navigator.gpu
document.title = 'ready'
