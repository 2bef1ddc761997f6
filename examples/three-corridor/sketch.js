import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.shadowMap.enabled = true
renderer.toneMapping = THREE.ACESFilmicToneMapping
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#34405f')
scene.fog = new THREE.Fog('#34405f', 8, 24)
const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 60)
const controls = new OrbitControls(camera, renderer.domElement)
controls.enableDamping = true
controls.maxDistance = 7

// A jointed figure: around each bone is a capsule. At a joint, its vertices are weighted to both bones that meet there.
const bones = {}
const geometries = []
const order = []
function addLimb(name, parent, [x, y, z], length, radius) {
  const bone = new THREE.Bone()
  bone.position.set(x, y, z)
  bones[parent]?.add(bone)
  bones[name] = bone
  order.push(bone)
  const geometry = new THREE.CapsuleGeometry(radius, Math.abs(length), 8, 20, 8)
  geometry.translate(0, length / 2, 0)
  const [boneIndex, parentIndex] = [order.length - 1, Math.max(order.indexOf(bones[parent]), 0)]
  const { position } = geometry.attributes
  const [indices, weights] = [[], []]
  for (let i = 0; i < position.count; i++) {
    // From 0 before the joint with the parent to 1 beyond it.
    const along = THREE.MathUtils.smoothstep(position.getY(i) * Math.sign(length), -radius, radius)
    indices.push(boneIndex, parentIndex, 0, 0)
    weights.push(0.5 + 0.5 * along, 0.5 - 0.5 * along, 0, 0)
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4))
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4))
  geometries.push([geometry, bone])
}
addLimb('hips', undefined, [0, 0.98, 0], 0.14, 0.15)
addLimb('chest', 'hips', [0, 0.2, 0], 0.28, 0.18)
addLimb('head', 'chest', [0, 0.52, 0], 0.08, 0.125)
for (const [side, x] of [
  ['left', 1],
  ['right', -1],
]) {
  addLimb(`${side} thigh`, 'hips', [0.1 * x, -0.02, 0], -0.42, 0.09)
  addLimb(`${side} shin`, `${side} thigh`, [0, -0.46, 0], -0.4, 0.07)
  addLimb(`${side} foot`, `${side} shin`, [0, -0.42, 0.05], -0.02, 0.075)
  addLimb(`${side} arm`, 'chest', [0.25 * x, 0.3, 0], -0.27, 0.06)
  addLimb(`${side} hand`, `${side} arm`, [0, -0.31, 0], -0.27, 0.05)
}
bones.hips.updateMatrixWorld(true)
for (const [geometry, bone] of geometries) geometry.applyMatrix4(bone.matrixWorld)
const figure = new THREE.SkinnedMesh(
  mergeGeometries(geometries.map(([geometry]) => geometry)),
  new THREE.MeshPhysicalMaterial({ color: '#e8b04a', roughness: 0.35, clearcoat: 0.5 }),
)
figure.add(bones.hips)
figure.bind(new THREE.Skeleton(order))
figure.castShadow = figure.receiveShadow = true

// Swings the limbs; two steps per second.
function walk(seconds) {
  const phase = 2 * Math.PI * seconds
  for (const [side, other] of [
    ['left', 0],
    ['right', Math.PI],
  ]) {
    const swing = Math.sin(phase + other)
    bones[`${side} thigh`].rotation.x = -0.55 * swing
    bones[`${side} shin`].rotation.x = 0.15 + 0.75 * Math.max(0, Math.cos(phase + other))
    bones[`${side} foot`].rotation.x = 0.2 * swing
    bones[`${side} arm`].rotation.x = 0.5 * swing
    bones[`${side} hand`].rotation.x = -0.5 - 0.2 * swing
  }
  bones.hips.position.y = 0.98 + 0.03 * Math.cos(2 * phase)
  bones.chest.rotation.y = 0.12 * Math.sin(phase)
  bones.head.rotation.y = -0.12 * Math.sin(phase)
}

// A corridor of 60 m under the evening sky: a floor of tiles, walls and arches.
const [length, width, height, wallHeight] = [60, 2.6, 2.8, 1.5]
function makeTiles() {
  const data = new Uint8Array(4 * 4)
  for (let i = 0; i < 4; i++)
    data.set(i === 1 || i === 2 ? [70, 58, 48, 255] : [150, 132, 110, 255], 4 * i)
  const map = new THREE.DataTexture(data, 2, 2)
  map.wrapS = map.wrapT = THREE.RepeatWrapping
  map.repeat.set(width / 1.3, length / 1.3)
  map.colorSpace = THREE.SRGBColorSpace
  map.generateMipmaps = map.needsUpdate = true
  map.minFilter = THREE.LinearMipmapLinearFilter
  return map
}
const corridor = new THREE.Group()
function addPlane(planeWidth, material, place) {
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(planeWidth, length, 8, 240), material)
  place(mesh)
  mesh.receiveShadow = true
  corridor.add(mesh)
}
const wall = new THREE.MeshStandardMaterial({ color: '#8d6f5a', roughness: 0.9 })
const floor = new THREE.MeshStandardMaterial({ map: makeTiles(), roughness: 0.4 })
addPlane(width, floor, (mesh) => mesh.rotateX(-Math.PI / 2))
for (const side of [-1, 1])
  addPlane(wallHeight, wall, (mesh) => {
    mesh.rotation.set(Math.PI / 2, (-side * Math.PI) / 2, 0)
    mesh.position.set((side * width) / 2, wallHeight / 2, 0)
  })
const arch = new THREE.TorusGeometry(width / 2, 0.11, 12, 40, Math.PI).translate(
  0,
  height - width / 2,
  0,
)
const post = new THREE.CylinderGeometry(0.11, 0.11, height - width / 2, 16, 6)
const stone = new THREE.MeshStandardMaterial({ color: '#c9b79c', roughness: 0.8 })
const count = 25
const arches = new THREE.InstancedMesh(arch, stone, count)
const posts = new THREE.InstancedMesh(post, stone, 2 * count)
const matrix = new THREE.Matrix4()
for (let i = 0; i < count; i++) {
  const z = (i + 0.5) * (length / count) - length / 2
  arches.setMatrixAt(i, matrix.makeTranslation(0, 0, z))
  for (const side of [0, 1])
    posts.setMatrixAt(
      2 * i + side,
      matrix.makeTranslation((side - 0.5) * width, (height - width / 2) / 2, z),
    )
}
for (const mesh of [arches, posts]) {
  mesh.castShadow = mesh.receiveShadow = true
  corridor.add(mesh)
}

// Bends everything along a circle in world space: a figure that walks straight ahead follows the bend.
const all = new THREE.Group().add(corridor, figure)
scene.add(all)
const settings = { bend: 1, roll: 0.25, steps: 1 }
const warped = warp(
  all,
  ({ glsl, position, uniforms }) => {
    const { curve, roll } = uniforms
    const angle = position.z().mult(curve)
    const reach = glsl.val(1).div(curve).sub(position.x())
    const bent = glsl.vec3(
      glsl.val(1).div(curve).sub(reach.mult(angle.cos())),
      position.y().add(position.z().mult(0.35).sin().mult(roll)),
      reach.mult(angle.sin()),
    )
    return bent.sub(position)
  },
  {
    space: 'world',
    uniforms: {
      // Never 0, the curvature of a circle of infinite radius.
      curve: () => Math.max(0.002, 0.075 * settings.bend),
      roll: () => settings.roll,
    },
  },
)

// A lamp follows the figure. The figure's bounds give its warped position.
const lamp = new THREE.PointLight('#ffdca8', 22, 16)
lamp.castShadow = true
lamp.shadow.mapSize.set(512, 512)
lamp.shadow.normalBias = 0.04
scene.add(lamp, new THREE.HemisphereLight('#b8c4ff', '#40281c', 0.7))
const here = new THREE.Vector3()
const before = new THREE.Vector3()
const findFigure = () => here.copy(figure.boundingSphere.center).applyMatrix4(figure.matrixWorld)

const panel = new GUI({ title: 'Corridor' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'bend', 0, 1.6)
panel.add(settings, 'roll', 0, 0.6)
panel.add(settings, 'steps', 0, 2)
const stats = new Stats()
document.body.append(stats.dom)

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()

let [steps, last] = [0, 0]
function moveForward(time) {
  steps += (Math.min(time - last, 100) / 1000) * settings.steps
  last = time
  walk(steps)
  figure.position.z = ((steps * 1.35 + 12) % 24) - 12
  scene.updateMatrixWorld()
  findFigure()
}
moveForward(0)
camera.position.copy(here).add(new THREE.Vector3(-0.7, 0.5, -3.2))
controls.target.copy(here)
before.copy(here)

renderer.setAnimationLoop((time) => {
  moveForward(time)
  // The camera follows the figure, in the direction that the mouse has set.
  camera.position.add(here).sub(before)
  controls.target.copy(here)
  before.copy(here)
  lamp.position.copy(here).add(new THREE.Vector3(0.5, 1.3, -1.3))
  warped.update(time)
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
