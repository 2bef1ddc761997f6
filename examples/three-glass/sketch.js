import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.shadowMap.enabled = true
renderer.toneMapping = THREE.ACESFilmicToneMapping
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#b9b2a6')
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(
  new RoomEnvironment(),
  0.04,
).texture
scene.environmentIntensity = 0.45
const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 50)
camera.position.set(0, 1.6, 6.2)
const controls = new OrbitControls(camera, renderer.domElement)
controls.target.set(0, 1.05, 0)
controls.maxPolarAngle = 1.55
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#fff0d8', 2)
sun.position.set(3, 5, 2)
sun.castShadow = true
sun.shadow.mapSize.set(1024, 1024)
Object.assign(sun.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3, far: 12 })
scene.add(sun)

// A table and coloured rods to see through the glass.
const table = new THREE.Mesh(
  new THREE.CircleGeometry(6, 64).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ color: '#8f7f6b', roughness: 0.8 }),
)
table.receiveShadow = true
scene.add(table)
const rod = new THREE.CylinderGeometry(0.09, 0.09, 2.6, 24).translate(0, 1.3, 0)
for (let i = 0; i < 11; i++) {
  const material = new THREE.MeshStandardMaterial({ roughness: 0.4 })
  material.color.setHSL(i / 11, 0.85, 0.4)
  const mesh = new THREE.Mesh(rod, material)
  mesh.position.set(0.42 * (i - 5), 0, -1.6 - 0.3 * (i % 2))
  mesh.castShadow = mesh.receiveShadow = true
  scene.add(mesh)
}

// Makes the normal map of hammered glass: dents on a slightly irregular grid.
function makeDents(size = 256, cells = 16) {
  const heights = new Float32Array(size * size)
  const dents = Array.from({ length: cells * cells }, (_, i) => [
    (i % cells) + 0.2 + 0.6 * Math.random(),
    Math.floor(i / cells) + 0.2 + 0.6 * Math.random(),
  ])
  // The map repeats, so distances are taken across its border, too.
  const distance = (a, b) => Math.min(Math.abs(a - b), cells - Math.abs(a - b))
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) {
      const [u, v] = [(x / size) * cells, (y / size) * cells]
      let nearest = 2
      for (let j = -1; j <= 1; j++)
        for (let i = -1; i <= 1; i++) {
          const column = (Math.floor(u) + i + cells) % cells
          const [a, b] = dents[((Math.floor(v) + j + cells) % cells) * cells + column]
          nearest = Math.min(nearest, Math.hypot(distance(a, u), distance(b, v)))
        }
      heights[y * size + x] = nearest * nearest
    }
  const heightAt = (x, y) => heights[((y + size) % size) * size + ((x + size) % size)]
  const data = new Uint8Array(4 * size * size)
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) {
      const normal = new THREE.Vector3(
        heightAt(x - 1, y) - heightAt(x + 1, y),
        heightAt(x, y - 1) - heightAt(x, y + 1),
        0.25,
      )
      const [r, g, b] = normal.normalize().toArray()
      data.set([128 + 127 * r, 128 + 127 * g, 128 + 127 * b, 255], 4 * (y * size + x))
    }
  const map = new THREE.DataTexture(data, size, size)
  map.wrapS = map.wrapT = THREE.RepeatWrapping
  map.minFilter = THREE.LinearMipmapLinearFilter
  map.magFilter = THREE.LinearFilter
  map.generateMipmaps = map.needsUpdate = true
  map.repeat.set(3, 2)
  return map
}

// A vase with tangents. The warp transforms the tangents with the normals, so the dents stay dents.
const profile = [
  [0.001, 0.02],
  [0.5, 0.02],
  [0.62, 0.3],
  [0.68, 0.8],
  [0.55, 1.3],
  [0.4, 1.7],
  [0.48, 2.1],
]
const curve = new THREE.SplineCurve(profile.map(([x, y]) => new THREE.Vector2(x, y)))
const geometry = new THREE.LatheGeometry(curve.getPoints(160), 128)
geometry.computeTangents()
const material = new THREE.MeshPhysicalMaterial({
  normalMap: makeDents(),
  transmission: 1,
  thickness: 0.35,
  roughness: 0.04,
  ior: 1.45,
  attenuationColor: '#9fd8c8',
  attenuationDistance: 0.9,
  side: THREE.DoubleSide,
})
const vase = new THREE.Mesh(geometry, material)
vase.castShadow = true
scene.add(vase)

const settings = { twist: 0.8, flutes: 0.09, dents: 0.6, still: false }
const warped = warp(
  vase,
  ({ glsl, position, millis, uniforms }) => {
    const { twist, flutes } = uniforms
    const around = glsl.vec2(position.x(), position.z())
    const height = position.y()
    // Seven flutes, deeper towards the top, that follow the twist.
    const turn = height.mult(twist).mult(millis.div(2500).sin().mult(0.5).add(1))
    const angle = glsl.atan(position.z(), position.x())
    const swell = angle.mult(7).cos().mult(flutes).mult(height.mult(0.5).min(1))
    const wide = around.mult(swell.add(1))
    const [cos, sin] = [turn.cos(), turn.sin()]
    const x = wide.x().mult(cos).sub(wide.y().mult(sin))
    const z = wide.x().mult(sin).add(wide.y().mult(cos))
    return glsl.vec3(x.sub(position.x()), 0, z.sub(position.z()))
  },
  { uniforms: { twist: () => settings.twist, flutes: () => settings.flutes } },
)

const panel = new GUI({ title: 'Glass' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'twist', 0, 2)
panel.add(settings, 'flutes', 0, 0.2)
panel.add(settings, 'dents', 0, 1.5)
panel.add(settings, 'still')
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
  if (!settings.still) warped.update(time)
  vase.material.normalScale.setScalar(settings.dents)
  controls.update()
  renderer.render(scene, camera)
  stats.update()
})
