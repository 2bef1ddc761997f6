// A page with WebGLRenderer that measures normals at pixels.
import * as THREE from 'three'
import { warp, warpMaterial } from 'warpjet/three'
import { measure } from './measure.js'
import {
  collapse,
  countDifferences,
  countFacetDifferences,
  drawWithMap,
  litScene,
  makeBumps,
  mapNames,
  summarize,
} from './pictures.js'
import { camera, size } from './scenes.js'
import { warps } from './warps.js'

const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
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

function attributeMaterial(options) {
  const material = new THREE.MeshBasicMaterial(options)
  material.onBeforeCompile = (shader) => {
    shader.vertexShader =
      `attribute vec4 shownAttribute;\nvarying vec4 vShown;\n${shader.vertexShader}`.replace(
        'void main() {',
        'void main() { vShown = shownAttribute;',
      )
    shader.fragmentShader = `varying vec4 vShown;\n${shader.fragmentShader}`.replace(
      /\}\s*$/,
      'gl_FragColor = vShown; }',
    )
  }
  return material
}

const normalMaterial = (options) => new THREE.MeshNormalMaterial(options)
const makers = {
  normal: normalMaterial,
  standard: (options) => new THREE.MeshStandardMaterial(options),
  physical: (options) => new THREE.MeshPhysicalMaterial(options),
}
const host = { draw, normalMaterial, attributeMaterial, makers }

/** Returns the sources of the program that is compiled for a material of this kind with `normals`. */
function sources(normals, kind = 'standard') {
  const { scene, warped } = litScene(makers[kind](), warps.simplex, { normals })
  const programsBefore = new Set(renderer.info.programs)
  draw(scene)
  const compiled = renderer.info.programs.find((program) => !programsBefore.has(program))
  const gl = renderer.getContext()
  const vertexAndFragment = [compiled.vertexShader, compiled.fragmentShader].map((shader) =>
    gl.getShaderSource(shader),
  )
  warped.dispose()
  return vertexAndFragment
}

/** Maps an obstacle → a function that makes a material whose normals cannot be computed at pixels because of it. */
const obstacles = {
  'normals changed after the warp': () =>
    makeMaterialWithHook((shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <project_vertex>',
        '#include <project_vertex>\nvNormal = normalize( vNormal + vec3( 0.3, 0.0, 0.0 ) );',
      )
    }),
  'normals changed before the warp': () =>
    makeMaterialWithHook((shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <begin_vertex>',
        '#include <begin_vertex>\nvNormal = normalize( vNormal + vec3( 0.3, 0.0, 0.0 ) );',
      )
    }),
  'a fragment shader without the line': () =>
    makeMaterialWithHook((shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <normal_fragment_begin>',
        THREE.ShaderChunk.normal_fragment_begin.replace('normalize( vNormal )', 'vNormal'),
      )
    }),
  'MeshBasicMaterial with an environment': () => {
    const envMap = makeBumps()
    envMap.mapping = THREE.EquirectangularReflectionMapping
    return new THREE.MeshBasicMaterial({ envMap })
  },
  'a ShaderMaterial without chunks': () =>
    new THREE.ShaderMaterial({
      vertexShader: `varying vec3 vN; void main() { vN = normalMatrix * normal;
        gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 ); }`,
      fragmentShader:
        'varying vec3 vN; void main() { gl_FragColor = vec4( normalize( vN ), 1.0 ); }',
    }),
  'too few varyings': () => {
    renderer.capabilities.maxVaryings = 8
    return new THREE.MeshStandardMaterial()
  },
}

const { maxVaryings } = renderer.capabilities

function makeMaterialWithHook(change) {
  const material = new THREE.MeshStandardMaterial()
  material.onBeforeCompile = change
  material.customProgramCacheKey = () => String(change)
  return material
}

/** Draws a material that has an obstacle. Returns the number of pixels that differ from a picture with normals at vertices. */
function obstacle(name, normals) {
  const pictures = ['vertex', normals].map((normals) => {
    const { scene, warped } = litScene(obstacles[name](), warps.simplex, { normals })
    draw(scene)
    const secondFrame = draw(scene)
    warped.dispose()
    return secondFrame
  })
  renderer.capabilities.maxVaryings = maxVaryings
  return { differing: countDifferences(...pictures), ...summarize(pictures[1]) }
}

/** Returns the stages that 'auto' selects for each warp, and for a constant shift: in `warp` and in `warpMaterial`. */
function stages() {
  const shift = ({ glsl }) => glsl.vec3(1, 0, 0)
  return Object.fromEntries(
    Object.entries({ ...warps, shift }).map(([name, offset]) => {
      const mesh = new THREE.Mesh(new THREE.SphereGeometry(), new THREE.MeshStandardMaterial())
      const { normals } = warp(mesh, offset, { surfaceVariation: false })
      const warpedMaterial = warpMaterial(new THREE.MeshStandardMaterial(), offset, {
        surfaceVariation: false,
      })
      return [name, [normals, warpedMaterial.normals]]
    }),
  )
}

/** Draws a noisy sphere with `normals`. Returns a data URL, to look at it. */
function show(normals, name = 'simplex', pixels = 400) {
  renderer.setSize(pixels, pixels)
  const { scene } = litScene(
    new THREE.MeshPhysicalMaterial({ color: 0xff9060, roughness: 0.35, clearcoat: 0.3 }),
    warps[name],
    { normals },
  )
  scene.children[0].position.set(3, 4, 6)
  scene.add(new THREE.HemisphereLight(0xffffff, 0x404060, 0.6))
  renderer.setClearColor(0x202028, 1)
  renderer.render(scene, camera())
  const url = renderer.domElement.toDataURL()
  renderer.setSize(size, size)
  return url
}

window.pixels = {
  warps: Object.keys(warps),
  measure: (settings) => measure(host, settings),
  collapse: (name, settings) => collapse(host, name, settings),
  countFacetDifferences: (name) => countFacetDifferences(host, name),
  mapNames,
  drawWithMap: (name) => drawWithMap(host, name),
  obstacles: Object.keys(obstacles),
  obstacle,
  sources,
  stages,
  show,
}
document.title = 'ready'
