import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import {
  Fn,
  Loop,
  color,
  cross,
  float,
  mx_noise_float,
  positionLocal,
  sin,
  time,
  transformNormalToView,
  uniform,
  vec3,
} from 'three/tsl'
import * as THREE from 'three/webgpu'
import { exactNormals } from 'warpjet/three/webgpu'

// Nodes work in the same way on WebGPU, but more browsers have WebGL 2.
const renderer = new THREE.WebGPURenderer({ antialias: true, forceWebGL: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.toneMapping = THREE.ACESFilmicToneMapping
document.body.append(renderer.domElement)

const scene = new THREE.Scene()
scene.background = new THREE.Color('#150a24')
const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 100)
camera.position.set(0, 3.1, 4)
const controls = new OrbitControls(camera, renderer.domElement)
controls.target.set(0, -0.15, 0)
controls.enableDamping = true

const sun = new THREE.DirectionalLight('#ffffff', 3)
sun.position.set(-4, 2, 0)
scene.add(sun)

// The formula of three's example: long waves, out of which three octaves of noise are cut.
const height = uniform(0.15)
const smallHeight = uniform(0.18)
const elevation = Fn(([place]) => {
  const raised = sin(place.x.mul(3).add(time.mul(1.25)))
    .mul(sin(place.z.add(time.mul(1.25))))
    .mul(height)
    .toVar()
  Loop({ type: 'float', start: float(1), end: float(3), condition: '<=' }, ({ i }) => {
    const point = vec3(place.xz.add(2).mul(2).mul(i), time.mul(0.3))
    raised.subAssign(mx_noise_float(point).mul(smallHeight).div(i).abs())
  })
  return raised
})

function water() {
  const material = new THREE.MeshStandardNodeMaterial({ color: '#271442', roughness: 0.15 })
  const raised = elevation(positionLocal)
  material.positionNode = positionLocal.add(vec3(0, raised, 0))
  material.emissiveNode = color('#ff0a81').mul(raised.remap(0.2, -0.25).pow(7))
  return material
}

// Before: the normal comes from two more heights, at a distance (`shift`) that must be tuned.
const before = water()
const shift = uniform(0.01)
const beside = (x, z) => {
  const place = positionLocal.add(vec3(x, 0, z))
  return place
    .add(vec3(0, elevation(place), 0))
    .sub(before.positionNode)
    .normalize()
}
before.normalNode = transformNormalToView(cross(beside(shift, 0), beside(0, shift.negate())))

// After: one line.
const after = exactNormals(water(), { normals: 'pixel' })

const geometry = new THREE.PlaneGeometry(2, 2, 128, 128).rotateX(-Math.PI / 2)
for (const [material, x] of [
  [before, -1.05],
  [after, 1.05],
]) {
  const sea = new THREE.Mesh(geometry, material)
  sea.position.x = x
  scene.add(sea)
}

const panel = new GUI({ title: 'Waves' })
if (innerWidth < 480) panel.close()
panel.add(height, 'value', 0, 0.4).name('long waves')
panel.add(smallHeight, 'value', 0, 0.4).name('small waves')
panel.add(shift, 'value', 0.001, 0.1).name('shift, left only')

function resize() {
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
  renderer.setSize(innerWidth, innerHeight)
}
addEventListener('resize', resize)
resize()

await renderer.setAnimationLoop(() => {
  controls.update()
  renderer.render(scene, camera)
})
