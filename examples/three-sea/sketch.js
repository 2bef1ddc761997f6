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
// The colour of the haze in `sky`.
scene.fog = new THREE.Fog('#ced5d8', 14, 34)
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100)
camera.position.set(6, 3.2, 8)
const controls = new OrbitControls(camera, renderer.domElement)
controls.target.set(0, 0.8, 0)
controls.maxPolarAngle = 1.5
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#fff3d6', 4)
sun.position.set(6, 9, -4)
sun.castShadow = true
sun.shadow.mapSize.set(2048, 2048)
sun.shadow.normalBias = 0.03
sun.shadow.bias = -0.002
Object.assign(sun.shadow.camera, { left: -8, right: 8, top: 8, bottom: -8, far: 30 })
scene.add(sun)

// The sky, from the sun down to the haze on the horizon, as the background and as the reflection in the water.
function sky([width, height] = [256, 128]) {
  const data = new Float32Array(4 * width * height)
  const [haze, zenith, deep] = ['#cbdde8', '#3d7fb0', '#0a3a45'].map((hex) => new THREE.Color(hex))
  const toSun = sun.position.clone().normalize()
  const [way, color] = [new THREE.Vector3(), new THREE.Color()]
  for (let i = 0; i < width * height; i++) {
    const longitude = 2 * Math.PI * (((i % width) + 0.5) / width - 0.5)
    const latitude = Math.PI * ((Math.floor(i / width) + 0.5) / height - 0.5)
    way.setFromSphericalCoords(1, Math.PI / 2 - latitude, Math.PI / 2 - longitude)
    if (way.y < 0) color.lerpColors(haze, deep, Math.min(1, Math.max(0, -3 * way.y - 0.5)))
    else color.lerpColors(haze, zenith, 1 - (1 - way.y) ** 6)
    const glow = Math.max(0, way.dot(toSun)) ** 60
    color.toArray(data, 4 * i)
    for (let k = 0; k < 3; k++) data[4 * i + k] += glow * [2, 1.7, 1.2][k]
    data[4 * i + 3] = 1
  }
  const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType)
  texture.mapping = THREE.EquirectangularReflectionMapping
  texture.minFilter = texture.magFilter = THREE.LinearFilter
  texture.needsUpdate = true
  return texture
}
scene.background = scene.environment = sky()

// Gerstner waves, which move the water in circles: crests get sharp, and the water moves back and forth.
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
  new THREE.PlaneGeometry(44, 44, 220, 220).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.12 }),
)
sea.castShadow = sea.receiveShadow = true
scene.add(sea)
const settings = { height: 0.78, speed: 1, foam: 2 }
const uniforms = { height: () => settings.height, speed: () => settings.speed }
const warped = warp(sea, swell, { uniforms })

// Evaluates the same sea on the CPU, for the foam and the boat.
const seaOnCPU = compileWarp(swell, { uniforms })
const { position, normal } = sea.geometry.attributes
const calm = { positions: position.array, normals: normal.array }

// The water is white where it turns over, and the foam fades slowly.
const [water, white] = [new THREE.Color('#0a4a58'), new THREE.Color('#f4fbff')]
const foam = new Float32Array(position.count)
const colors = new THREE.Float32BufferAttribute(new Float32Array(3 * position.count), 3)
sea.geometry.setAttribute('color', colors)
const color = new THREE.Color()
function breakWaves(millis, seconds) {
  const { mask } = seaOnCPU.foldover(calm, { uniforms: { millis } })
  const remaining = Math.exp(-seconds / Math.max(settings.foam, 0.01))
  for (let i = 0; i < foam.length; i++) {
    foam[i] = mask[i] || foam[i] * remaining
    color.lerpColors(water, white, foam[i]).toArray(colors.array, 3 * i)
  }
  colors.needsUpdate = true
}

// A boat: half an egg, a deck, a mast and two sails.
const boat = new THREE.Group()
const wood = new THREE.MeshStandardMaterial({ color: '#8c4a2f', roughness: 0.6 })
const deck = new THREE.MeshStandardMaterial({ color: '#d8b27a', roughness: 0.7 })
// The sun shines through the sails.
const cloth = new THREE.MeshStandardMaterial({ color: '#fff7e8', side: THREE.DoubleSide })
cloth.emissive.set('#7d6f58')
const hull = new THREE.SphereGeometry(1, 48, 16, 0, 7, Math.PI / 2, Math.PI / 2)
const sail = (...corners) =>
  new THREE.ShapeGeometry(new THREE.Shape(corners.map(([z, y]) => new THREE.Vector2(z, y))))
for (const [geometry, material, y] of [
  [hull.scale(0.5, 0.5, 1.3), wood, 0.25],
  [new THREE.CircleGeometry(1, 48).rotateX(-Math.PI / 2).scale(0.5, 1, 1.3), deck, 0.25],
  [new THREE.CylinderGeometry(0.03, 0.04, 2.4, 12), wood, 1.4],
  [sail([0.06, 0.2], [1, 0.25], [0.06, 2.1]).rotateY(Math.PI / 2), cloth, 0.35],
  [sail([-0.06, 0.2], [-1.1, 0.3], [-0.06, 1.7]).rotateY(Math.PI / 2), cloth, 0.35],
]) {
  const part = new THREE.Mesh(geometry, material)
  part.position.y = y
  part.castShadow = part.receiveShadow = true
  boat.add(part)
}
scene.add(boat)

// Finds the point of the calm sea whose water is now below the boat; the search starts at the point of the previous frame. The
// waves do not depend on the height, so the point that moves to height 0 here started as far below 0 as the water is now above 0.
let near
const up = new THREE.Vector3(0, 1, 0)
const course = new THREE.Quaternion()
function ride(millis) {
  const angle = millis / 9000
  const [x, z] = [3 * Math.cos(angle), 3 * Math.sin(angle)]
  const result = seaOnCPU.inverseAt([x, 0, z], { near, uniforms: { millis } })
  if (!result) return
  near = result.position
  boat.position.set(x, -near[1], z)
  const { normal } = seaOnCPU.evaluateAt([near[0], 0, near[2]], {
    normal: [0, 1, 0],
    uniforms: { millis },
  })
  const upright = new THREE.Quaternion().setFromUnitVectors(up, new THREE.Vector3(...normal))
  course.setFromAxisAngle(up, -angle)
  boat.quaternion.slerp(upright.multiply(course), 0.15)
}

const panel = new GUI({ title: 'Sea' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'height', 0, 1.2)
panel.add(settings, 'speed', 0, 2)
panel.add(settings, 'foam', 0, 6).name('foam, seconds')
const stats = new Stats()
document.body.append(stats.dom)

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()

let last = 0
renderer.setAnimationLoop((time) => {
  warped.update(time)
  breakWaves(time, (time - last) / 1000)
  last = time
  ride(time)
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
