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
// An evening in summer: a low sun behind the field, and haze in front of the sky.
scene.background = new THREE.Color('#f3e3c8')
scene.fog = new THREE.Fog('#f3e3c8', 6, 14)
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50)
camera.position.set(2.6, 1.7, 6.4)
const controls = new OrbitControls(camera, renderer.domElement)
controls.target.set(0, 0.4, 0)
controls.maxPolarAngle = 1.5
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#ffd9a0', 6)
sun.position.set(-5, 4, -3)
sun.castShadow = true
sun.shadow.mapSize.set(2048, 2048)
sun.shadow.normalBias = 0.01
Object.assign(sun.shadow.camera, { left: -6, right: 6, top: 6, bottom: -6, far: 16 })
scene.add(sun, new THREE.HemisphereLight('#ffeedd', '#4a5a24', 2.2))

const ground = new THREE.Mesh(
  new THREE.CircleGeometry(12, 48).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ color: '#39491a', roughness: 1 }),
)
ground.receiveShadow = true
scene.add(ground)

// Ten thousand blades, each with its own position, height and colour.
const blade = new THREE.ConeGeometry(0.025, 1, 5, 8).translate(0, 0.5, 0).scale(1, 1, 0.4)
// The blades are darker near the ground, which little light reaches.
const { position: points } = blade.attributes
const shade = Float32Array.from({ length: 3 * points.count }, (_, i) => {
  return 0.25 + 0.9 * points.getY(Math.floor(i / 3))
})
blade.setAttribute('color', new THREE.BufferAttribute(shade, 3))
const count = 10_000
const grass = new THREE.InstancedMesh(
  blade,
  new THREE.MeshStandardMaterial({ roughness: 0.6, vertexColors: true }),
  count,
)
const transform = new THREE.Object3D()
const color = new THREE.Color()
for (let i = 0; i < count; i++) {
  const [angle, radius] = [i * 2.39996, 5.5 * Math.sqrt(i / count)]
  transform.position.set(radius * Math.cos(angle), 0, radius * Math.sin(angle))
  transform.rotation.y = 7 * Math.random()
  transform.scale.set(1, 0.5 + 0.5 * Math.random(), 1)
  transform.updateMatrix()
  grass.setMatrixAt(i, transform.matrix)
  grass.setColorAt(i, color.setHSL(0.17 + 0.09 * Math.random(), 0.6, 0.3 + 0.14 * Math.random()))
}
grass.castShadow = grass.receiveShadow = true
scene.add(grass)

// The warp is in world space, where the wind has the same direction for all blades. Gusts are noise that drifts over the
// field, and each blade bends more the nearer a point is to its tip.
const settings = { wind: 0.9, gusts: 0.45, direction: 0.6 }
const warped = warp(
  grass,
  ({ glsl, position, millis, uniforms }) => {
    const { wind, gusts, direction } = uniforms
    const way = glsl.vec3(direction.cos(), 0, direction.sin())
    const place = position
      .xz()
      .mult(gusts)
      .sub(way.xz().mult(millis.div(900)))
    const strength = place.simplex().mult(0.5).add(0.6).mult(wind)
    const flutter = position
      .x()
      .mult(5)
      .add(position.z().mult(7))
      .add(millis.div(120))
      .sin()
      .mult(0.03)
    const bend = position.y().max(0).pow(2).mult(strength.add(flutter))
    return way.mult(bend).sub(glsl.vec3(0, bend.mult(bend).mult(0.4), 0))
  },
  {
    space: 'world',
    uniforms: {
      wind: () => settings.wind,
      gusts: () => settings.gusts,
      direction: () => settings.direction,
    },
  },
)

const panel = new GUI({ title: 'Wind' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'wind', 0, 1.5)
panel.add(settings, 'gusts', 0.1, 1.5)
panel.add(settings, 'direction', -3.14, 3.14)
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
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
