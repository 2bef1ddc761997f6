// The company tests combine warps with other code: a row is a function that draws a scene. Draws each row three times: without motion, with
// vertices moved on the CPU, and with a warp.
import * as THREE from 'three'
import { warp } from 'warpjet/three'

export const size = 160

const amount = 0.2

export const offset = ({ glsl, position }) =>
  glsl.vec3(0, 0, position.x().mult(4).sin().mult(amount))

/** Moves vertices on the CPU by the same offset: z increases by `amount` · sin 4x, and normals are transformed accordingly. */
export function moveByHand(object) {
  const done = new Set()
  object.traverse(({ geometry }) => {
    if (!geometry || done.has(geometry)) return
    done.add(geometry)
    const { position, normal } = geometry.attributes
    for (let i = 0; i < position.count; i++) {
      const x = position.getX(i)
      const slope = 4 * amount * Math.cos(4 * x)
      position.setZ(i, position.getZ(i) + amount * Math.sin(4 * x))
      if (!normal) continue
      const warpedNormal = new THREE.Vector3().fromBufferAttribute(normal, i)
      warpedNormal.x -= slope * warpedNormal.z
      normal.setXYZ(i, ...warpedNormal.normalize())
    }
    geometry.computeBoundingSphere()
  })
}

/** A motion in GLSL that users add to their own shaders in some rows: x increases by 0.3 y², and normals do not change. */
export const userMotion = 'transformed.x += 0.3 * transformed.y * transformed.y;'

/** Applies this motion to a geometry on the CPU. */
export function userMotionByHand(geometry) {
  const { position } = geometry.attributes
  for (let i = 0; i < position.count; i++)
    position.setX(i, position.getX(i) + 0.3 * position.getY(i) ** 2)
  return geometry
}

export const torus = () => new THREE.TorusGeometry(0.8, 0.3, 40, 90)

export function checker() {
  const data = new Uint8Array(4 * 8 * 8)
  for (let i = 0; i < 64; i++)
    data.set((i + (i >> 3)) % 2 ? [255, 120, 40, 255] : [40, 200, 255, 255], 4 * i)
  const map = new THREE.DataTexture(data, 8, 8)
  map.magFilter = map.minFilter = THREE.LinearFilter
  map.colorSpace = THREE.SRGBColorSpace
  map.needsUpdate = true
  return map
}

export function camera() {
  const made = new THREE.PerspectiveCamera(45, 1, 0.5, 20)
  made.position.set(1.6, 0.8, 4)
  made.lookAt(0, 0, 0)
  made.updateMatrixWorld()
  return made
}

export function litScene() {
  const scene = new THREE.Scene()
  scene.background = new THREE.Color(0x223344)
  const sun = new THREE.DirectionalLight(0xffffff, 2)
  sun.position.set(1, 2, 2)
  sun.castShadow = true
  sun.shadow.mapSize.set(256, 256)
  sun.shadow.bias = -0.004
  Object.assign(sun.shadow.camera, { left: -2.5, right: 2.5, top: 2.5, bottom: -2.5 })
  scene.add(sun, new THREE.HemisphereLight(0x8899ff, 0x332211, 0.6))
  return scene
}

export function floor() {
  const made = new THREE.Mesh(
    new THREE.PlaneGeometry(8, 8),
    new THREE.MeshStandardMaterial({ color: 0x999999 }),
  )
  made.rotation.x = -Math.PI / 2
  made.position.y = -1.2
  made.receiveShadow = true
  return made
}

export const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true })
renderer.setPixelRatio(1)
renderer.setSize(size, size)
document.body.append(renderer.domElement)

export function readPixels(from = renderer) {
  const gl = from.getContext()
  const pixels = new Uint8Array(4 * size * size)
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
  return pixels
}

/** Maps the ways in which a row moves its object → a function that does so. */
const ways = {
  none: () => {},
  byHand: moveByHand,
  warped: (object, options) => warp(object, offset, options),
}

/**
 * Draws a row: a function of { put, way, renderer } that makes objects and calls `put` to move them. With the way 'byHand', the row
 * must also apply motions of the user's shaders on the CPU. Random numbers, which passes of three.js use, are the same each time.
 */
function draw(row, way) {
  let state = 1
  const { random } = Math
  Math.random = () => (state = (state * 16807) % 2147483647) / 2147483647
  renderer.shadowMap.enabled = false
  renderer.setRenderTarget(null)
  renderer.autoClear = true
  renderer.clear()
  const cleanups = []
  const put = (object, options) => {
    const warped = ways[way](object, options)
    if (warped) cleanups.push(() => warped.dispose())
    return warped
  }
  return Promise.resolve(row({ put, way, renderer }))
    .then((pixels) => pixels ?? readPixels())
    .finally(() => {
      Math.random = random
      for (const cleanUp of cleanups) cleanUp()
    })
}

function compare(a, b) {
  let [count, worst] = [0, 0]
  for (let i = 0; i < a.length; i += 4) {
    const differences = [0, 1, 2].map((k) => Math.abs(a[i + k] - b[i + k]))
    worst = Math.max(worst, ...differences)
    count += differences.some((difference) => difference > 12)
  }
  return { count, worst }
}

/**
 * Compares a row's three pictures. Returns the number of pixels that differ between the warp and the motion by hand (`differing`), the
 * number of those that the motion changes (`moved`), and the max difference of a channel (`worst`).
 */
export async function run(row) {
  const none = await draw(row, 'none')
  const byHand = await draw(row, 'byHand')
  const warped = await draw(row, 'warped')
  const { count, worst } = compare(warped, byHand)
  return { differing: count, moved: compare(none, byHand).count, worst }
}

/**
 * Makes a row that draws one object. `after` runs when the object has been warped, before the first frame, and may return a camera; `then`
 * runs between the first and a second frame.
 */
export const makeRow =
  (make, { after, then, shadow = false, view = camera } = {}) =>
  ({ put, way, renderer }) => {
    const scene = litScene()
    renderer.shadowMap.enabled = shadow
    if (shadow) scene.add(floor())
    const object = make(way)
    object.traverse((each) => {
      each.castShadow = each.receiveShadow = shadow
    })
    scene.add(object)
    put(object)
    const context = { object, scene, renderer, way }
    const camera = after?.(context) ?? view()
    renderer.render(scene, camera)
    if (!then) return undefined
    then(context)
    renderer.render(scene, camera)
    return undefined
  }

export const standard = (more) => new THREE.MeshStandardMaterial({ roughness: 0.6, ...more })
export const mesh = (material = standard(), geometry = torus()) =>
  new THREE.Mesh(geometry, material)

let changes = 0

/**
 * Adds an `onBeforeCompile` to a material. Without a key of its own, three.js would let it share a program with materials whose
 * `onBeforeCompile` has the same source.
 */
export function withOnBeforeCompile(onBeforeCompile, material = standard()) {
  const key = `row ${++changes}`
  material.onBeforeCompile = onBeforeCompile
  material.customProgramCacheKey = () => key
  return material
}

/** Makes a mesh with the user's motion: in the shader of the material that `makeMaterial` returns, or applied on the CPU. */
export const withMotion = (way, makeMaterial) =>
  way === 'byHand' ? mesh(standard(), userMotionByHand(torus())) : mesh(makeMaterial())
