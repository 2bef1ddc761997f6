// Compares shadows, culling and rays of meshes with `exactNormals`, which must follow the displacement, with those of meshes whose vertices
// are moved by hand.
import * as THREE from 'three'
import { addSurfaceVariation, exactNormals, warp } from 'warpjet/three'

const size = 120
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50)
camera.position.set(0, 3, 7)
camera.lookAt(0, 0.3, 0)

const renderers = {}
function getRenderer(isShadowed) {
  return (renderers[isShadowed] ??= (() => {
    const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true })
    renderer.setSize(size, size)
    renderer.shadowMap.enabled = isShadowed
    renderer.shadowMap.type = THREE.BasicShadowMap
    return renderer
  })())
}

function takePicture(renderer, scene, from = camera) {
  renderer.render(scene, from)
  const gl = renderer.getContext()
  const pixels = new Uint8Array(4 * size * size)
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
  return pixels
}

/** Counts the pixels that differ by more than 12 of 255. */
function countDiffering(a, b) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 12)) count++
  return count
}

const time = { value: 0.4 }
const height = ([x, , z]) => 0.5 * Math.sin(2.5 * x + time.value) * Math.cos(2 * z)

/** Makes a material that moves vertices up by `height` and to the side. */
function makeDisplaced() {
  const material = new THREE.MeshStandardMaterial({ roughness: 0.6 })
  material.onBeforeCompile = (shader) => {
    shader.uniforms.uTime = time
    shader.vertexShader = `uniform float uTime;\n${shader.vertexShader}`.replace(
      '#include <begin_vertex>',
      `vec3 transformed = position;
      transformed.y += 0.5 * sin(2.5 * position.x + uTime) * cos(2.0 * position.z);
      transformed.x += 1.5;`,
    )
  }
  return material
}

/** Returns a copy of a geometry whose vertices are moved by hand, like those of `makeDisplaced`. */
function moveVertices(geometry) {
  const copy = geometry.clone()
  const { position, normal } = copy.attributes
  const move = (p) => [p[0] + 1.5, p[1] + height(p), p[2]]
  for (let i = 0; i < position.count; i++) {
    const p = [position.getX(i), position.getY(i), position.getZ(i)]
    const [dx, dz] = [
      1.25 * Math.cos(2.5 * p[0] + time.value) * Math.cos(2 * p[2]),
      -Math.sin(2.5 * p[0] + time.value) * Math.sin(2 * p[2]),
    ]
    const n = [normal.getX(i), normal.getY(i), normal.getZ(i)]
    const movedNormal = new THREE.Vector3(n[0] - dx * n[1], n[1], n[2] - dz * n[1]).normalize()
    position.setXYZ(i, ...move(p))
    normal.setXYZ(i, movedNormal.x, movedNormal.y, movedNormal.z)
  }
  copy.boundingSphere = copy.boundingBox = null
  return copy
}

const makeSphere = () => new THREE.SphereGeometry(0.8, 96, 64)

function makeScene(mesh, light) {
  const scene = new THREE.Scene()
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), new THREE.MeshStandardMaterial())
  floor.rotation.x = -Math.PI / 2
  floor.position.y = -1.2
  floor.receiveShadow = true
  light.position.set(-3, 5, 2)
  light.castShadow = true
  light.shadow.mapSize.set(512, 512)
  light.shadow.normalBias = 0.05
  mesh.castShadow = true
  mesh.position.set(-1.5, 0.4, 0)
  return scene.add(floor, light, new THREE.AmbientLight(0xffffff, 0.4), mesh)
}

const lights = {
  directional: () => new THREE.DirectionalLight(0xffffff, 2),
  point: () => new THREE.PointLight(0xffffff, 80),
  spot: () => new THREE.SpotLight(0xffffff, 90, 0, 0.7),
}

/**
 * Counts pixels in which a shadow differs from that of vertices moved by hand. The shadow follows the displacement if `exactNormals` is
 * called on the mesh (`isFollowing`) rather than on its material.
 */
export function shadow(kind, isFollowing = true) {
  time.value = 0.4
  const renderer = getRenderer(true)
  const material = makeDisplaced()
  const mesh = new THREE.Mesh(makeSphere(), material)
  const returned = exactNormals(isFollowing ? mesh : material)
  mesh.frustumCulled = isFollowing
  const scene = makeScene(mesh, lights[kind]())
  renderer.render(scene, camera)
  // The uniform must still affect the shadow.
  time.value = 1.9
  const drawn = takePicture(renderer, scene)
  const plain = new THREE.MeshStandardMaterial({ roughness: 0.6 })
  const byHand = new THREE.Mesh(moveVertices(makeSphere()), plain)
  const expected = takePicture(renderer, makeScene(byHand, lights[kind]()))
  const without = takePicture(
    renderer,
    makeScene(new THREE.Mesh(makeSphere(), plain), lights[kind]()),
  )
  return {
    isSame: returned === (isFollowing ? mesh : material),
    differing: countDiffering(drawn, expected),
    moved: countDiffering(without, expected),
  }
}

const fromBelow = new THREE.PerspectiveCamera(100, 1, 0.05, 50)
fromBelow.position.set(0.6, -0.35, 0)
fromBelow.lookAt(0.6, -2, 0)

/**
 * Counts pixels of the floor in which the shadow differs from that of vertices moved by hand (`differing`), and in which the latter differs
 * from the shadow without displacement (`moved`). `place` moves a vertex.
 */
export function shadowOnFloor(geometry, material, place) {
  const renderer = getRenderer(true)
  const draw = (mesh) => takePicture(renderer, makeScene(mesh, lights.directional()), fromBelow)
  const byHand = geometry.clone()
  const { position } = byHand.attributes
  for (let i = 0; i < position.count; i++)
    position.setXYZ(i, ...place([position.getX(i), position.getY(i), position.getZ(i)]))
  const plain = () => new THREE.MeshStandardMaterial({ side: material.side })
  const drawn = draw(exactNormals(new THREE.Mesh(geometry, material)))
  const expected = draw(new THREE.Mesh(byHand, plain()))
  return {
    differing: countDiffering(drawn, expected),
    moved: countDiffering(draw(new THREE.Mesh(geometry, plain())), expected),
  }
}

/** Does the same as `shadowOnFloor` for a displacement map that moves all vertices of a sphere outwards. */
export async function shadowOfMap() {
  const displacementMap = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1)
  displacementMap.needsUpdate = true
  const material = new THREE.MeshStandardMaterial({ displacementMap, displacementScale: 0.2 })
  const geometry = await addSurfaceVariation(new THREE.SphereGeometry(0.6, 48, 32))
  return shadowOnFloor(geometry, material, (p) => p.map((x) => (x * 0.8) / 0.6))
}

/**
 * Changes a material that has been drawn → counts of differing pixels of the floor, and the height at which a ray from above hits the mesh.
 */
export function recompile(kind) {
  const renderer = getRenderer(true)
  const makeMaterial = (lift) => {
    const material = new THREE.MeshStandardMaterial()
    change(material, lift)
    return material
  }
  const change = (material, lift) => {
    if (kind === 'defines') material.defines = { LIFT: lift }
    const statement = `transformed.y += ${kind === 'defines' ? 'LIFT' : lift} * (1.0 + position.x);`
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <begin_vertex>',
        `#include <begin_vertex>\n${statement}`,
      )
    }
    material.customProgramCacheKey = () => `${kind} ${statement}`
    material.needsUpdate = true
  }
  const makeMesh = (lift) => exactNormals(new THREE.Mesh(makeSphere(), makeMaterial(lift)))
  const sceneWith = (mesh) => makeScene(mesh, lights.directional())
  const mesh = makeMesh('0.1')
  const scene = sceneWith(mesh)
  const before = takePicture(renderer, scene, fromBelow)
  change(mesh.material, '0.9')
  const drawn = takePicture(renderer, scene, fromBelow)
  const expected = takePicture(renderer, sceneWith(makeMesh('0.9')), fromBelow)
  const ray = new THREE.Raycaster(new THREE.Vector3(-1.5, 9, 0), new THREE.Vector3(0, -1, 0))
  return {
    differing: countDiffering(drawn, expected),
    stale: countDiffering(before, expected),
    ray: ray.intersectObject(mesh)[0]?.point.y,
    expected: 0.4 + 0.8 + 0.9,
  }
}

/**
 * Returns the height at which a ray from above hits the mesh: before the mesh is first drawn, after that, and after a change of the
 * uniform; and tests the bounds.
 */
export function cpu() {
  time.value = 0.4
  const mesh = exactNormals(new THREE.Mesh(makeSphere(), makeDisplaced()))
  mesh.position.y = 0.25
  mesh.updateMatrixWorld()
  const ray = new THREE.Raycaster(new THREE.Vector3(1.7, 9, 0.1), new THREE.Vector3(0, -1, 0))
  const hit = () => ray.intersectObject(mesh)[0]?.point.y
  const found = { before: hit() }
  const scene = new THREE.Scene().add(mesh)
  getRenderer(false).render(scene, camera)
  found.after = hit()
  time.value = 1.9
  found.later = hit()
  const byHand = new THREE.Mesh(moveVertices(makeSphere()), new THREE.MeshBasicMaterial())
  byHand.position.y = 0.25
  byHand.updateMatrixWorld()
  found.expected = ray.intersectObject(byHand)[0]?.point.y
  byHand.geometry.computeBoundingSphere()
  const { position } = byHand.geometry.attributes
  const places = Array.from({ length: position.count }, (_, i) =>
    new THREE.Vector3().fromBufferAttribute(position, i),
  )
  const { boundingSphere } = mesh
  found.covers = places.every((place) => boundingSphere.containsPoint(place))
  found.isTight = boundingSphere.radius < 1.6 * byHand.geometry.boundingSphere.radius
  return found
}

/** Returns whether a mesh is drawn that only the displacement moves into sight. */
export function culling(isFollowing) {
  const renderer = getRenderer(false)
  const mesh = new THREE.Mesh(makeSphere(), makeDisplaced())
  exactNormals(isFollowing ? mesh : mesh.material)
  const aside = new THREE.PerspectiveCamera(10, 1, 0.1, 50)
  aside.position.set(2, 0, 9)
  renderer.render(new THREE.Scene().add(mesh), aside)
  return renderer.info.render.triangles > 0
}

/** Counts pixels in which a warped mesh with `exactNormals` differs from a warped mesh that is displaced by hand. */
export function warpOnTop(normals) {
  time.value = 0.4
  const renderer = getRenderer(false)
  const draw = (mesh) => {
    mesh.frustumCulled = false
    return takePicture(renderer, new THREE.Scene().add(mesh), camera)
  }
  const showNormals = (material) => {
    const { onBeforeCompile } = material
    material.onBeforeCompile = function (shader, renderer) {
      onBeforeCompile.call(this, shader, renderer)
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <dithering_fragment>',
        'gl_FragColor = vec4(0.5 * normal + 0.5, 1.0);',
      )
    }
    return material
  }
  const twisted = new THREE.Mesh(
    makeSphere(),
    exactNormals(showNormals(makeDisplaced()), { normals }),
  )
  twisted.position.set(-1.5, 0, 0)
  const offset = ({ glsl, position }) => glsl.vec3(0, 0, position.y().mult(3).sin().mult(0.3))
  warp(twisted, offset, { normals: 'vertex' })
  const byHand = new THREE.Mesh(
    moveVertices(makeSphere()),
    showNormals(new THREE.MeshStandardMaterial()),
  )
  byHand.position.set(-1.5, 0, 0)
  warp(byHand, offset, { normals: 'vertex' })
  const plain = new THREE.Mesh(
    moveVertices(makeSphere()),
    showNormals(new THREE.MeshStandardMaterial()),
  )
  plain.position.set(-1.5, 0, 0)
  const expected = draw(byHand)
  return {
    differing: countDiffering(draw(twisted), expected),
    moved: countDiffering(draw(plain), expected),
  }
}

/** Counts pixels that differ between two materials of one class whose `onBeforeCompile` differ. */
export function twins() {
  time.value = 0.4
  const renderer = getRenderer(false)
  const create = (amount) => {
    const material = new THREE.MeshNormalMaterial()
    const statement = `transformed.x += ${amount} * sin(4.0 * position.y);`
    material.onBeforeCompile = new Function(
      'shader',
      `shader.vertexShader = shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\\n${statement}')`,
    )
    return exactNormals(material)
  }
  const draw = (...materials) =>
    materials.map((material) =>
      takePicture(renderer, new THREE.Scene().add(new THREE.Mesh(makeSphere(), material))),
    )
  const [first, second] = draw(create('0.1'), create('0.4'))
  return countDiffering(first, second)
}

/** Returns the messages of wrong calls. */
export function wrongCalls() {
  const calls = [
    () => exactNormals(),
    () => exactNormals(new THREE.Group()),
    () => exactNormals(new THREE.LineBasicMaterial()),
    () =>
      exactNormals(
        Object.assign(new THREE.Material(), {
          isNodeMaterial: true,
          type: 'MeshStandardNodeMaterial',
        }),
      ),
    () => exactNormals(new THREE.MeshStandardMaterial(), { normals: 'face' }),
    () => exactNormals(new THREE.MeshStandardMaterial(), { maxIterations: 0 }),
    () => exactNormals(new THREE.MeshStandardMaterial(), { normal: 'pixel' }),
  ]
  return calls.map((call) => {
    try {
      call()
      return 'no error'
    } catch (error) {
      return `${error.name}: ${error.message}`
    }
  })
}
