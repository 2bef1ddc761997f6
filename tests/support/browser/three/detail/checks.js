// The measurements of the tests of the option `detail`, for either renderer.
import * as THREE from 'three'
import { camera, countBeyond, covered, sceneOf, warpBy } from './pictures.js'

export { around } from './around.js'
export { holes } from './holes.js'
export { comparePoses } from './posed.js'
export { rays } from './rays.js'

/** Maps a light → a view of the floor beside the box. */
const outside = {
  sun: { from: [-1.6, 0.2, -0.4], to: [-1.6, -1.2, -0.5] },
  bulb: { from: [-2.5, 3.5, 1], to: [-2.5, -1.2, -1] },
}

/**
 * Compares a coarse shape, such as a box, with and without detail, with a fine one. Returns how many pixels differ with detail (`beyond`)
 * and without, how many pixels the fine shape covers, and how many triangles were drawn with detail and for the fine shape.
 */
export async function compare(
  { draw, triangles },
  { name, coarse = 'box', fine = 'fine', detail = 1, hasShadow = false, isOutside, light, space },
) {
  const view = camera()
  if (isOutside) {
    // Shows only the floor. By the sun, a part of the outline of the shadow fills the picture.
    const { from, to } = outside[light]
    view.position.set(...from)
    view.lookAt(...to)
  }
  const pictureOf = async (shape, detail) => {
    const { scene, mesh } = sceneOf(shape, { hasShadow, light })
    if (space === 'world') mesh.rotation.z = 0.5
    const warped = warpBy(mesh, name, detail, { space })
    const picture = await draw(scene, view)
    const drawn = triangles()
    warped.dispose()
    return { picture, drawn }
  }
  const expected = await pictureOf(fine)
  const without = await pictureOf(coarse)
  const divided = await pictureOf(coarse, detail)
  return {
    beyond: countBeyond(divided.picture, expected.picture),
    without: countBeyond(without.picture, expected.picture),
    covered: covered(expected.picture),
    triangles: divided.drawn,
    fine: expected.drawn,
  }
}

/** Compares divided instances of different sizes with fine ones. */
export async function instances({ draw }) {
  const matrices = [0, 1, 2].map((i) =>
    new THREE.Matrix4()
      .makeRotationY(i)
      .scale(new THREE.Vector3().setScalar(0.3 + 0.2 * i))
      .setPosition(i - 1.2, 0.6 * (i - 1), 0),
  )
  const { scene, mesh } = sceneOf('fine')
  const pictureOf = async (shape, detail) => {
    const { geometry } = sceneOf(shape).mesh
    const many = new THREE.InstancedMesh(geometry, mesh.material, 3)
    matrices.forEach((matrix, i) => many.setMatrixAt(i, matrix))
    geometry.setAttribute('perInstance', new THREE.InstancedBufferAttribute(new Float32Array(3), 1))
    scene.clear().add(many)
    const warped = warpBy(many, 'twist', detail)
    const picture = await draw(scene, camera())
    warped.dispose()
    return picture
  }
  const expected = await pictureOf('fine')
  return {
    beyond: countBeyond(await pictureOf('box', 1), expected),
    without: countBeyond(await pictureOf('box'), expected),
  }
}

/** Returns a texture of squares, which show errors inside of a side of the box. */
function makeSquares() {
  const cells = 16
  const isDark = (i) => (i + Math.floor(i / cells)) % 2
  const bytes = Array.from({ length: cells * cells }, (_, i) =>
    isDark(i) ? [255, 0, 0, 255] : [0, 0, 255, 255],
  )
  const texture = new THREE.DataTexture(new Uint8Array(bytes.flat()), cells, cells)
  texture.needsUpdate = true
  return texture
}

/**
 * Draws a box, mirrored or not, from nearby, with a material that shows only one side of triangles. Only triangles whose visible side faces
 * the camera are divided.
 */
export async function side({ draw, triangles }, { side, scale }) {
  const material = new THREE.MeshBasicMaterial({ side: THREE[side], map: makeSquares() })
  const view = camera()
  view.position.setLength(2.2)
  const pictureOf = async (shape, detail) => {
    const { scene, mesh } = sceneOf(shape, { material })
    mesh.scale.x = scale
    const warped = warpBy(mesh, 'twist', detail)
    const picture = await draw(scene, view)
    warped.dispose()
    return picture
  }
  const expected = await pictureOf('fine')
  const picture = await pictureOf('box', 1)
  const drawn = triangles()
  material.side = THREE.DoubleSide
  await pictureOf('box', 1)
  return { beyond: countBeyond(picture, expected), triangles: drawn, both: triangles() }
}

/** Draws a box with three materials, each on two sides. */
export async function groups({ draw }) {
  const materials = [0xff0000, 0x00ff00, 0x0000ff].map(
    (color) => new THREE.MeshBasicMaterial({ color }),
  )
  const pictureOf = async (shape, detail) => {
    const { scene, mesh } = sceneOf(shape, { material: materials[0] })
    mesh.material = [0, 1, 2, 0, 1, 2].map((i) => materials[i])
    const warped = warpBy(mesh, 'twist', detail)
    const picture = await draw(scene, camera())
    warped.dispose()
    return picture
  }
  const expected = await pictureOf('fine')
  return {
    beyond: countBeyond(await pictureOf('box', 1), expected),
    without: countBeyond(await pictureOf('box'), expected),
  }
}

/** Counts triangles while camera, geometry and scene change, and the geometries that are left in the end. */
export async function countOverTime({ draw, triangles, geometries }) {
  const { scene, mesh } = sceneOf('box')
  const own = mesh.geometry
  const plain = await draw(scene, camera())
  const before = { geometries: geometries(), triangles: triangles() }
  const calls = []
  // Compute passes take over while a picture is drawn again and again.
  const call = (name) => void (calls.at(-2) === name || calls.push(name, mesh.geometry === own))
  scene.onBeforeRender = () => call('before')
  const warped = warpBy(mesh, 'twist', 1)
  const drawAndCount = async (view = camera()) => {
    await draw(scene, view)
    return triangles()
  }
  const far = camera()
  far.position.setLength(30)
  // The first picture starts from the pieces that the CPU chose. Rounding can make these differ from those of the passes.
  await drawAndCount()
  await drawAndCount(far)
  const near = await drawAndCount()
  scene.onAfterRender = () => call('after')
  const counts = { near, far: await drawAndCount(far), again: await drawAndCount() }
  // The next picture shows a changed geometry, and a new one.
  own.attributes.position.setXYZ(0, 3, 3, 3)
  own.attributes.position.needsUpdate = true
  counts.changed = await drawAndCount()
  own.attributes.position.setXYZ(0, 0.7, 0.9, 0.7)
  own.attributes.position.needsUpdate = true
  mesh.geometry = new THREE.SphereGeometry(1, 8, 4)
  counts.sphere = await drawAndCount()
  mesh.geometry.dispose()
  counts.disposed = await drawAndCount()
  mesh.geometry.dispose()
  mesh.geometry = own
  const clone = mesh.clone()
  scene.add(clone)
  counts.clone = await drawAndCount()
  scene.remove(clone)
  counts.removed = await drawAndCount()
  // Outside of a scene.
  scene.remove(mesh)
  const group = new THREE.Group().add(mesh)
  await draw(group, camera())
  counts.outside = triangles()
  scene.add(mesh)
  counts.back = await drawAndCount()
  warped.dispose()
  const after = await draw(scene, camera())
  return {
    counts,
    calls: calls.slice(0, 6),
    before,
    after: { geometries: geometries(), triangles: triangles() },
    isSame: countBeyond(plain, after) === 0,
    isRestored: mesh.geometry === own && Object.keys(mesh).includes('geometry'),
    hooks: ['onBeforeRender', 'onAfterRender'].map(
      (name) => typeof Object.getOwnPropertyDescriptor(scene, name)?.value,
    ),
  }
}

/** Tests that a render call that throws restores the geometry, and that the next call divides the mesh again. */
export async function throwing({ draw, triangles }) {
  const { scene, mesh } = sceneOf('box')
  const own = mesh.geometry
  const warped = warpBy(mesh, 'twist', 1)
  await draw(scene, camera())
  const expected = triangles()
  mesh.onBeforeRender = () => {
    throw new Error('on purpose')
  }
  const error = await draw(scene, camera()).catch(({ message }) => message)
  await Promise.resolve()
  const isRestored = mesh.geometry === own
  mesh.onBeforeRender = () => {}
  await draw(scene, camera())
  const found = triangles()
  warped.dispose()
  return { error, isRestored, isSame: found === expected }
}

/** Maps a kind → a function that makes an object that is not divided. */
const undividedObjects = {
  points: (geometry) => new THREE.Points(geometry),
  lines: (geometry) => new THREE.Line(geometry),
  instances: (geometry) => {
    const instanced = new THREE.InstancedBufferGeometry().copy(geometry)
    instanced.instanceCount = 1
    return new THREE.Mesh(instanced, new THREE.MeshNormalMaterial())
  },
  batch(geometry) {
    const batch = new THREE.BatchedMesh(1, 100, 100, new THREE.MeshNormalMaterial())
    const id = batch.addGeometry(geometry)
    batch.addInstance?.(id)
    return batch
  },
  morphs(geometry) {
    geometry.morphAttributes.position = [geometry.attributes.position.clone()]
    return new THREE.Mesh(geometry, new THREE.MeshNormalMaterial())
  },
}

/** Counts the triangles of an object that is not divided: without a warp (`own`) and with one (`found`). */
export async function countUndivided({ draw, triangles }, { kind, space }) {
  const { scene, mesh } = sceneOf('box')
  const object = undividedObjects[kind](mesh.geometry)
  scene.clear().add(object)
  await draw(scene, camera())
  const own = triangles()
  const warped = warpBy(object, 'twist', 1, { space })
  await draw(scene, camera())
  await draw(scene, camera())
  const found = triangles()
  warped.dispose()
  return { own, found }
}

/** Draws a group of objects that are not divided, for the warnings about them. */
export async function warnOfGroup({ draw }, { kinds }) {
  const { scene, mesh } = sceneOf('box')
  const group = new THREE.Group().add(...kinds.map((kind) => undividedObjects[kind](mesh.geometry)))
  scene.clear().add(group)
  const warped = warpBy(group, 'twist', 1)
  await draw(scene, camera())
  await draw(scene, camera())
  warped.dispose()
}
