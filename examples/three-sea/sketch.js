import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.shadowMap.enabled = true
renderer.toneMapping = THREE.ACESFilmicToneMapping
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#b8d4e3')
scene.fog = new THREE.Fog('#b8d4e3', 18, 42)
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100)
camera.position.set(7, 4.5, 9)
const controls = new OrbitControls(camera, renderer.domElement)
controls.maxPolarAngle = 1.5
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#fff3d6', 4)
sun.position.set(6, 9, -4)
sun.castShadow = true
sun.shadow.mapSize.set(1024, 1024)
sun.shadow.normalBias = 0.03
Object.assign(sun.shadow.camera, { left: -8, right: 8, top: 8, bottom: -8, far: 30 })
scene.add(sun, new THREE.HemisphereLight('#cfe8ff', '#0b3a4a', 1.2))

// Waves that go round in circles, as Gerstner's do: crests get sharp, and the water comes and goes.
const waves = [
  { toward: [1, 0.3], length: 5, steepness: 0.5 },
  { toward: [0.6, -0.8], length: 2.9, steepness: 0.4 },
  { toward: [0.2, 1], length: 1.7, steepness: 0.3 },
  { toward: [-0.5, 0.9], length: 0.9, steepness: 0.25 },
]
function swell({ glsl, position, millis, uniforms }) {
  let offset = glsl.vec3(0, 0, 0)
  for (const { toward, length, steepness } of waves) {
    const [x, z] = new THREE.Vector2(...toward).normalize()
    const k = (2 * Math.PI) / length
    const way = position.x().mult(x).add(position.z().mult(z))
    const phase = way.mult(k).sub(millis.mult(Math.sqrt(9.8 * k) / 1000).mult(uniforms.speed))
    const height = uniforms.height.mult(steepness / k)
    const forth = phase.cos().mult(height)
    offset = offset.add(glsl.vec3(forth.mult(x), phase.sin().mult(height), forth.mult(z)))
  }
  return offset
}

const sea = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 60, 300, 300).rotateX(-Math.PI / 2),
  new THREE.MeshPhysicalMaterial({ color: '#0f6b7c', roughness: 0.18, clearcoat: 0.4 }),
)
sea.castShadow = sea.receiveShadow = true
scene.add(sea)
const settings = { height: 0.7, speed: 1 }
const warped = warp(sea, swell, {
  uniforms: { height: () => settings.height, speed: () => settings.speed },
})

// A buoy that rides on what is drawn: a ray finds the water below it, and which way it faces.
const buoy = new THREE.Group()
const red = new THREE.MeshStandardMaterial({ color: '#e4572e', roughness: 0.5 })
const white = new THREE.MeshStandardMaterial({ color: 'white', roughness: 0.5 })
for (const [geometry, material, y] of [
  [new THREE.CylinderGeometry(0.75, 0.6, 0.45, 32), red, 0.1],
  [new THREE.CylinderGeometry(0.22, 0.5, 1, 32), white, 0.8],
  [new THREE.CylinderGeometry(0.2, 0.22, 0.25, 32), red, 1.4],
  [new THREE.SphereGeometry(0.16, 24, 16), white, 1.6],
]) {
  const part = new THREE.Mesh(geometry, material)
  part.position.y = y
  part.castShadow = part.receiveShadow = true
  buoy.add(part)
}
scene.add(buoy)
const down = new THREE.Raycaster(new THREE.Vector3(0, 9, 0), new THREE.Vector3(0, -1, 0))
const up = new THREE.Vector3(0, 1, 0)
function ride() {
  const [hit] = down.intersectObject(sea)
  if (!hit) return
  buoy.position.copy(hit.point)
  const upright = new THREE.Quaternion().setFromUnitVectors(up, hit.normal)
  buoy.quaternion.slerp(upright, 0.15)
}

const panel = new GUI({ title: 'Sea' })
panel.add(settings, 'height', 0, 1.2)
panel.add(settings, 'speed', 0, 2)
const stats = new Stats()
document.body.append(stats.dom)

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()

renderer.setAnimationLoop((time) => {
  warped.update(time)
  ride()
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
