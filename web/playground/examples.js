/** Sketches to begin with: the gallery's examples and a short sketch for each host. */
import { sections } from '../catalogue.js'
import { scripts } from './hosts.js'

export { sections }

const folder = new URL('../examples/', location.href)

async function textOf(path) {
  const response = await fetch(new URL(path, folder))
  if (!response.ok || !/^[\w-]+\//.test(path))
    throw new Error('This example does not exist: choose one from the list.')
  return response.text()
}

/** Loads an example. Returns { text, host, chosen }; host and chosen scripts follow from the tags of its page. */
export async function exampleSketch(name) {
  const [page, text] = await Promise.all(
    ['index.html', 'sketch.js'].map((file) => textOf(`${name}/${file}`)),
  )
  const chosen = Object.keys(scripts).filter(
    (script) => script !== 'p5' && page.includes(scripts[script].file),
  )
  return { text, host: page.includes('importmap') ? 'three' : 'p5', chosen }
}

export const starters = {
  p5: `// Change anything: the picture follows when you pause.
let wave

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  wave = createWarp(
    ({ glsl, millis, position, uniforms }) => {
      const along = position.y().mult(4).add(millis.div(500))
      return glsl.vec3(along.sin().mult(uniforms.height), 0, 0)
    },
    { uniforms: { height: 0.15 } },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.3)
  specularMaterial(90)
  shininess(40)
  fill('#ff8a5b')
  wave()
  sphere(150, 80, 60)
}
`,
  three: `import * as THREE from 'three'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: true })
document.body.append(renderer.domElement)
const scene = new THREE.Scene()
scene.background = new THREE.Color('#151823')
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100)
camera.position.set(0, 1, 4.5)
camera.lookAt(0, 0, 0)
const sun = new THREE.DirectionalLight('#fff0dd', 3)
sun.position.set(2, 3, 4)
scene.add(sun, new THREE.HemisphereLight('#8fa4ff', '#30283f', 1.5))

const ball = new THREE.Mesh(
  new THREE.SphereGeometry(1, 160, 120),
  new THREE.MeshStandardMaterial({ color: '#ff8a5b', roughness: 0.4 }),
)
scene.add(ball)
const warped = warp(ball, ({ glsl, position, millis }) => {
  const along = position.y().mult(4).add(millis.div(500))
  return glsl.vec3(along.sin().mult(0.15), 0, 0)
})

function resize() {
  renderer.setSize(innerWidth, innerHeight)
  camera.aspect = innerWidth / innerHeight
  camera.updateProjectionMatrix()
}
addEventListener('resize', resize)
resize()

renderer.setAnimationLoop((time) => {
  warped.update(time)
  renderer.render(scene, camera)
})
`,
}
