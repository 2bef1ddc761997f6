import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { compileWarp } from 'warpjet'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.shadowMap.enabled = true
renderer.toneMapping = THREE.ACESFilmicToneMapping
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#c5d8e8')
scene.fog = new THREE.Fog('#c5d8e8', 9, 17)
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100)
camera.position.set(4.6, 3, 6.2)
const controls = new OrbitControls(camera, renderer.domElement)
controls.maxPolarAngle = 1.45
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#ffe2b4', 6)
sun.position.set(-6, 4, 3)
sun.castShadow = true
sun.shadow.mapSize.set(2048, 2048)
sun.shadow.normalBias = 0.03
Object.assign(sun.shadow.camera, { left: -7, right: 7, top: 7, bottom: -7, far: 20 })
scene.add(sun, new THREE.HemisphereLight('#c9dfff', '#6b5a48', 2))

// Turns a flat plane into mountains: ridged noise, highest in the middle.
const settings = { height: 1.9, detail: 0.5 }
const uniforms = { height: () => settings.height, detail: () => settings.detail }
function mountains({ glsl, position, uniforms }) {
  const place = position.xz()
  const hill = place.dot(place).mult(-0.09).exp().mult(0.9).add(0.1)
  const ridges = place.mult(uniforms.detail).ridged({ octaves: 5, seed: 4 })
  return glsl.vec3(0, ridges.mult(hill).mult(uniforms.height), 0)
}
const terrain = new THREE.Mesh(
  new THREE.PlaneGeometry(20, 20, 300, 300).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.95 }),
)
terrain.castShadow = terrain.receiveShadow = true
scene.add(terrain)
const warped = warp(terrain, mountains, { uniforms })

// Snow covers high places and meadows low ones, but steep slopes are rock. Heights and slopes come from evaluating the
// warp on the CPU.
const terrainOnCPU = compileWarp(mountains, { uniforms })
const { position, normal } = terrain.geometry.attributes
const colors = new THREE.BufferAttribute(new Float32Array(3 * position.count), 3)
terrain.geometry.setAttribute('color', colors)
const [rock, meadow, snow] = ['#6d5f52', '#5d6e38', '#f6f9ff'].map((hex) => new THREE.Color(hex))
function paint() {
  const { positions, normals } = terrainOnCPU.evaluate({
    positions: position.array,
    normals: normal.array,
  })
  const { smoothstep } = THREE.MathUtils
  const color = new THREE.Color()
  for (let i = 1; i < positions.length; i += 3) {
    const flat = smoothstep(normals[i], 0.6, 0.85)
    const high =
      positions[i] + 0.1 * Math.sin(9 * positions[i - 1]) * Math.sin(7 * positions[i + 1])
    color
      .lerpColors(rock, meadow, flat * (1 - smoothstep(high, 0.2, 0.6)))
      .lerp(snow, flat * smoothstep(high, 0.75, 0.95))
      .toArray(colors.array, i - 1)
  }
  colors.needsUpdate = true
}
paint()

// A flag marks the point under the pointer, perpendicular to the slope; a click plants a flag.
const flag = new THREE.Group()
const pole = new THREE.Mesh(
  new THREE.CylinderGeometry(0.02, 0.02, 0.8, 12).translate(0, 0.4, 0),
  new THREE.MeshStandardMaterial({ color: 'white' }),
)
const cloth = new THREE.Mesh(
  new THREE.BoxGeometry(0.34, 0.22, 0.02).translate(0.18, 0.67, 0),
  new THREE.MeshStandardMaterial({ color: '#d7263d' }),
)
pole.castShadow = cloth.castShadow = true
flag.add(pole, cloth)
flag.position.set(0.4, 1.2, 0.4)
scene.add(flag)

const raycaster = new THREE.Raycaster()
const up = new THREE.Vector3(0, 1, 0)
function moveFlag({ clientX, clientY }) {
  const { left, top, width, height } = renderer.domElement.getBoundingClientRect()
  const place = new THREE.Vector2((clientX - left) / width, (clientY - top) / height)
  raycaster.setFromCamera(place.multiplyScalar(2).subScalar(1).multiply({ x: 1, y: -1 }), camera)
  const [hit] = raycaster.intersectObject(terrain)
  if (!hit) return
  flag.position.copy(hit.point)
  flag.quaternion.setFromUnitVectors(up, hit.normal)
}
renderer.domElement.addEventListener('pointermove', moveFlag)
renderer.domElement.addEventListener('click', (event) => {
  moveFlag(event)
  scene.add(flag.clone())
})
const moveFlagToMiddle = () => moveFlag({ clientX: innerWidth / 2, clientY: innerHeight / 2 })

const panel = new GUI({ title: 'Terrain' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'height', 0, 3)
panel.add(settings, 'detail', 0.1, 1)
panel.onChange(paint)
const stats = new Stats()
document.body.append(stats.dom)

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()
camera.updateMatrixWorld()
moveFlagToMiddle()

renderer.setAnimationLoop((time) => {
  warped.update(time)
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
