// Measures frame times of a warped mesh and of a mesh whose shader has the same motion and its derivatives by hand, for
// `npm run bench -- three`.
import * as THREE from 'three'
import { warp } from 'warpjet/three'

const renderer = new THREE.WebGLRenderer({ antialias: false })
renderer.setSize(64, 64)
document.body.append(renderer.domElement)
const gl = renderer.getContext()
const scene = new THREE.Scene()
scene.add(new THREE.DirectionalLight(0xffffff, 2), new THREE.HemisphereLight())
const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 50)
camera.position.z = 4

/** Makes a geometry of `copies` spheres at the same place, so that a single draw call keeps a GPU busy. */
function makeGeometry(copies) {
  const sphere = new THREE.SphereGeometry(1, 400, 300)
  const indices = sphere.index.array
  const index = new Uint32Array(copies * indices.length)
  for (let i = 0; i < copies; i++) index.set(indices, i * indices.length)
  return sphere.setIndex(new THREE.BufferAttribute(index, 1))
}

/** Sine waves along y and x; the first one moves with time. */
const offset = ({ glsl, position, millis }) =>
  glsl.vec3(
    position.y().mult(4).add(millis.div(500)).sin().mult(0.15),
    position.x().mult(3).sin().mult(0.1),
    0,
  )

const time = { value: 0 }

/** Writes the motion into the shader by hand; the normal is transformed by the cofactors of M = I + J. */
function warpByHand(object) {
  object.material.onBeforeCompile = (shader) => {
    shader.uniforms.time = time
    shader.vertexShader = shader.vertexShader
      .replace('void main() {', 'uniform float time;\nvoid main() {')
      .replace(
        '#include <beginnormal_vertex>',
        `#include <beginnormal_vertex>
        float u = position.y * 4.0 + time / 500.0;
        float v = position.x * 3.0;
        float a = 0.6 * cos( u );
        float b = 0.3 * cos( v );
        objectNormal = normalize( vec3( normal.x - b * normal.y, normal.y - a * normal.x, ( 1.0 - a * b ) * normal.z ) );`,
      )
      .replace(
        '#include <begin_vertex>',
        'vec3 transformed = position + vec3( 0.15 * sin( u ), 0.1 * sin( v ), 0.0 );',
      )
  }
  return { update: (millis) => (time.value = millis), dispose() {} }
}

const pixel = new Uint8Array(4)
function draw(count) {
  const start = performance.now()
  for (let i = 0; i < count; i++) renderer.render(scene, camera)
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel)
  return (performance.now() - start) / count
}

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1]

/** The number of batches of a round, for which both materials are created anew. The first batch consists only of the first frame. */
const batches = 4

/** Returns medians of `rounds` rounds; a batch has `batch` frames. */
window.bench = (rounds, copies, batch) => {
  const geometry = makeGeometry(copies)
  const warpFunctions = { warped: (object) => warp(object, offset), byHand: warpByHand }
  const times = { 'first frame': [], frame: [] }
  for (let round = 0; round < rounds; round++) {
    const entries = Object.entries(warpFunctions).map(([name, warpObject]) => {
      const object = new THREE.Mesh(geometry.clone(), new THREE.MeshStandardMaterial())
      // A new key makes three.js compile a new program.
      object.material.customProgramCacheKey = () => `${name} ${round}`
      return { name, object, ...warpObject(object) }
    })
    // Alternates between the two ways, and their order, so that other load on the machine affects them equally.
    if (round % 2) entries.reverse()
    for (let i = 0; i < batches; i++) {
      const pair = {}
      for (const { name, object, update } of entries) {
        scene.add(object)
        update(16 * i)
        pair[name] = draw(i ? batch : 1)
        scene.remove(object)
      }
      times[i ? 'frame' : 'first frame'].push(pair)
    }
    for (const { object, dispose } of entries) {
      dispose()
      object.geometry.dispose()
      object.material.dispose()
    }
  }
  return Object.fromEntries(Object.entries(times).map(([name, pairs]) => [name, summarize(pairs)]))
}

/** Returns the median time of each way, and the median of their quotients. */
const summarize = (pairs) => ({
  warped: median(pairs.map(({ warped }) => warped)),
  byHand: median(pairs.map(({ byHand }) => byHand)),
  quotient: median(pairs.map(({ warped, byHand }) => warped / byHand)),
})
document.title = 'ready'
