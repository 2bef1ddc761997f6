// A page with WebGLRenderer that measures normals at pixels.
import * as THREE from 'three'
import { warp, warpMaterial } from 'warpjet/three'
import { measure } from './measure.js'
import { camera, kinds, objectFor, shapes, size } from './scenes.js'
import { warps } from './warps.js'

const renderer = new THREE.WebGLRenderer({ antialias: false })
renderer.setSize(size, size)
document.body.append(renderer.domElement)
const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType })

function draw(scene, view = camera()) {
  renderer.setRenderTarget(target)
  renderer.setClearColor(0, 0)
  renderer.clear()
  renderer.render(scene, view)
  const numbers = new Float32Array(4 * size * size)
  renderer.readRenderTargetPixels(target, 0, 0, size, size, numbers)
  renderer.setRenderTarget(null)
  return numbers
}

function seenMaterial(options) {
  const material = new THREE.MeshBasicMaterial(options)
  material.onBeforeCompile = (shader) => {
    shader.vertexShader =
      `attribute vec4 seen;\nvarying vec4 vSeen;\n${shader.vertexShader}`.replace(
        'void main() {',
        'void main() { vSeen = seen;',
      )
    shader.fragmentShader = `varying vec4 vSeen;\n${shader.fragmentShader}`.replace(
      /\}\s*$/,
      'gl_FragColor = vSeen; }',
    )
  }
  return material
}

const normalMaterial = (options) => new THREE.MeshNormalMaterial(options)

window.pixels = {
  shapes,
  warps: Object.keys(warps),
  kinds: Object.keys(kinds),
  measure: (settings) => measure({ draw, normalMaterial, seenMaterial }, settings),
}
window.lib = { THREE, renderer, draw, warp, warpMaterial, warps, objectFor, size, camera }
document.title = 'ready'
