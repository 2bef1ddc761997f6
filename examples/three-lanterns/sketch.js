import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import Stats from 'three/addons/libs/stats.module.js'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
renderer.toneMapping = THREE.ACESFilmicToneMapping
renderer.autoClear = false
document.body.append(renderer.domElement)

const night = new THREE.Color('#070b18')
const scene = new THREE.Scene()
scene.fog = new THREE.Fog(night, 20, 75)
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 75)
camera.position.set(9, 5, 14)
const controls = new OrbitControls(camera, renderer.domElement)
controls.target.set(0, 0.5, 0)
controls.maxPolarAngle = 1.5
controls.enableDamping = true
controls.autoRotate = true
controls.autoRotateSpeed = 0.6
const moon = new THREE.DirectionalLight('#8fa8ff', 1.2)
moon.position.set(-3, 4, 1)
scene.add(moon, new THREE.HemisphereLight('#3a4a80', '#120a06', 0.6))

// Four hundred lanterns in each of 25 tiles.
const [tiles, perSide, gap] = [5, 20, 0.75]
const paper = new THREE.LatheGeometry(
  [
    [0.001, 0],
    [0.12, 0],
    [0.2, 0.12],
    [0.22, 0.28],
    [0.16, 0.42],
    [0.11, 0.45],
  ].map(([x, y]) => new THREE.Vector2(x, y)),
  12,
)
const glow = new THREE.MeshStandardMaterial({ roughness: 0.8, side: THREE.DoubleSide })
// Warm light from within, brighter at the bottom, in each lantern's colour.
glow.onBeforeCompile = (shader) => {
  shader.vertexShader = shader.vertexShader.replace(
    'void main() {',
    'varying float vHeight;\nvoid main() {\nvHeight = position.y / 0.45;',
  )
  shader.fragmentShader = shader.fragmentShader
    .replace('void main() {', 'varying float vHeight;\nvoid main() {')
    .replace(
      '#include <emissivemap_fragment>',
      'totalEmissiveRadiance += vColor.rgb * mix( 2.2, 0.25, smoothstep( 0.0, 1.0, vHeight ) );',
    )
}
const field = new THREE.Group()
const [matrix, color] = [new THREE.Matrix4(), new THREE.Color()]
for (let tile = 0; tile < tiles * tiles; tile++) {
  const lanterns = new THREE.InstancedMesh(paper, glow, perSide * perSide)
  const [i, j] = [tile % tiles, Math.floor(tile / tiles)]
  for (let k = 0; k < perSide * perSide; k++) {
    const x = (i - tiles / 2) * perSide + (k % perSide) + 0.3 * Math.random()
    const z = (j - tiles / 2) * perSide + Math.floor(k / perSide) + 0.3 * Math.random()
    matrix.makeScale(1, 0.7 + 0.6 * Math.random(), 1).setPosition(gap * x, 0, gap * z)
    lanterns.setMatrixAt(k, matrix)
    lanterns.setColorAt(k, color.setHSL(0.02 + 0.1 * Math.random(), 0.9, 0.5))
  }
  field.add(lanterns)
}
scene.add(field)

// One warp in world space for all lanterns: a slow swell, and a ripple that runs outwards from the middle.
const settings = { swell: 0.8, ripple: 0.25, turn: true, drawn: 0 }
const warped = warp(
  field,
  ({ glsl, position, millis, uniforms }) => {
    const [x, z] = [position.x(), position.z()]
    const along = x.mult(0.21).add(millis.div(2600)).sin()
    const across = z.mult(0.27).sub(millis.div(3100)).sin()
    const slow = along.add(across).mult(uniforms.swell)
    const far = position.xz().length()
    const ripple = far.mult(0.9).sub(millis.div(700)).sin().mult(uniforms.ripple)
    const lift = slow.add(ripple)
    return glsl.vec3(lift.mult(0.25), lift, 0)
  },
  { space: 'world', uniforms: { swell: () => settings.swell, ripple: () => settings.ripple } },
)

// The small picture shows from above which tiles the camera has drawn.
const above = new THREE.OrthographicCamera(-45, 45, 45, -45, 1, 200)
above.position.y = 100
above.lookAt(0, 0, 0)
const helper = new THREE.CameraHelper(camera)
helper.visible = false
scene.add(helper)
const [frustum, viewProjection] = [new THREE.Frustum(), new THREE.Matrix4()]

const panel = new GUI({ title: 'Lanterns' })
if (innerWidth < 480) panel.close()
panel.add(settings, 'swell', 0, 2)
panel.add(settings, 'ripple', 0, 0.6)
panel.add(settings, 'turn')
panel.add(settings, 'drawn').name('drawn of 10,000').listen().disable()
const stats = new Stats()
document.body.append(stats.dom)

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()

function draw(viewer, x, y, width, height, background) {
  renderer.setViewport(x, y, width, height)
  renderer.setScissor(x, y, width, height)
  renderer.setScissorTest(true)
  renderer.setClearColor(background)
  renderer.clear()
  renderer.render(scene, viewer)
}

renderer.setAnimationLoop((time) => {
  warped.update(time)
  controls.autoRotate = settings.turn
  controls.update()
  draw(camera, 0, 0, innerWidth, innerHeight, night)

  // three.js culls each tile by its warped bounds; the same test shows which tiles were drawn.
  frustum.setFromProjectionMatrix(
    viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
  )
  settings.drawn = 0
  for (const tile of field.children) {
    tile.visible = frustum.intersectsObject(tile)
    if (tile.visible) settings.drawn += tile.count
  }
  const size = Math.min(innerWidth, innerHeight) / 3.2
  helper.visible = true
  helper.update()
  // No fog in the view from above.
  Object.assign(scene.fog, { near: 1000, far: 2000 })
  draw(above, innerWidth - size - 12, 12, size, size, '#10182e')
  Object.assign(scene.fog, { near: 20, far: 75 })
  helper.visible = false
  for (const tile of field.children) tile.visible = true
  stats.update()
})
