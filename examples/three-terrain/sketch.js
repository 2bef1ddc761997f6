import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.shadowMap.enabled = true
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#dfe7ee')
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100)
camera.position.set(6, 5, 8)
const controls = new OrbitControls(camera, renderer.domElement)
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#ffe7bd', 3.5)
sun.position.set(-6, 4, 3)
sun.castShadow = true
sun.shadow.mapSize.set(2048, 2048)
sun.shadow.normalBias = 0.03
Object.assign(sun.shadow.camera, { left: -7, right: 7, top: 7, bottom: -7, far: 20 })
scene.add(sun, new THREE.HemisphereLight('#dcebff', '#6b5a48', 1))

// Mountains of a flat plane: ridges of noise, highest in the middle.
const terrain = new THREE.Mesh(
  new THREE.PlaneGeometry(9, 9, 220, 220).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ color: '#a08b6f', roughness: 0.95 }),
)
terrain.castShadow = terrain.receiveShadow = true
scene.add(terrain)
const settings = { height: 1.6, detail: 0.5 }
const warped = warp(
  terrain,
  ({ glsl, position, uniforms }) => {
    const place = position.xz()
    const hill = place.dot(place).mult(-0.09).exp()
    const ridges = place.mult(uniforms.detail).ridged({ octaves: 5, seed: 4 })
    return glsl.vec3(0, ridges.mult(hill).mult(uniforms.height), 0)
  },
  { uniforms: { height: () => settings.height, detail: () => settings.detail } },
)

// A flag where the pointer touches the mountains, upright on the slope; a click plants it.
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
function point({ clientX, clientY }) {
  const { left, top, width, height } = renderer.domElement.getBoundingClientRect()
  const place = new THREE.Vector2((clientX - left) / width, (clientY - top) / height)
  raycaster.setFromCamera(place.multiplyScalar(2).subScalar(1).multiply({ x: 1, y: -1 }), camera)
  const [hit] = raycaster.intersectObject(terrain)
  if (!hit) return
  flag.position.copy(hit.point)
  flag.quaternion.setFromUnitVectors(up, hit.normal)
}
renderer.domElement.addEventListener('pointermove', point)
renderer.domElement.addEventListener('click', (event) => {
  point(event)
  scene.add(flag.clone())
})
const middle = () => point({ clientX: innerWidth / 2, clientY: innerHeight / 2 })

const panel = new GUI({ title: 'Terrain' })
panel.add(settings, 'height', 0, 3)
panel.add(settings, 'detail', 0.1, 1)
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
middle()

renderer.setAnimationLoop((time) => {
  warped.update(time)
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
