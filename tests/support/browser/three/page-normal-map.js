// A page that draws GLB files with normal maps in three.js, and compares them with the exact normals of the warp at each pixel.
import * as THREE from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const size = 300
/**
 * The number of samples per pixel along each axis. Normals of noise vary within a pixel, and the map's mipmaps average them; so we average
 * samples, too.
 */
const samples = 4
const resolution = size * samples

const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
renderer.setSize(resolution, resolution)
renderer.setClearColor(0, 0)
document.body.append(renderer.domElement)

const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 20)
camera.position.set(1, 1.5, 4)
camera.lookAt(0, 0, 0)

/** Draws a model after `change(mesh)`. Returns its pixels, with an alpha of 0 where nothing is drawn. */
async function draw(glb, change = () => {}) {
  const { scene } = await new GLTFLoader().parseAsync(Uint8Array.fromBase64(glb).buffer, '')
  change(scene.getObjectByProperty('isMesh', true))
  const light = new THREE.DirectionalLight(0xffffff, 2)
  light.position.set(3, 2, 2)
  scene.add(light, new THREE.HemisphereLight(0xffffff, 0x808080, 1))
  renderer.render(scene, camera)
  const gl = renderer.getContext()
  const pixels = new Uint8Array(4 * resolution * resolution)
  gl.readPixels(0, 0, resolution, resolution, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
  return averageSamples(pixels)
}

/** Returns the average of the samples of each pixel. */
function averageSamples(pixels) {
  const sums = new Float32Array(4 * size * size)
  for (let y = 0; y < resolution; y++)
    for (let x = 0; x < resolution; x++)
      for (let k = 0; k < 4; k++)
        sums[4 * (size * Math.floor(y / samples) + Math.floor(x / samples)) + k] +=
          pixels[4 * (resolution * y + x) + k]
  return sums.map((sum) => sum / samples ** 2)
}

const toFloats = (base64) => new Float32Array(Uint8Array.fromBase64(base64).buffer)

/** Replaces the normal of each pixel by that of the warp at the interpolated rest position and normal. */
const withExactNormals =
  ({ declarations, code, positions, normals }) =>
  ({ geometry, material }) => {
    geometry.setAttribute('restPosition', new THREE.BufferAttribute(toFloats(positions), 3))
    geometry.setAttribute('restNormal', new THREE.BufferAttribute(toFloats(normals), 3))
    material.customProgramCacheKey = () => code
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        'void main() {',
        `in vec3 restPosition, restNormal; out vec3 vRestPosition, vRestNormal;
        void main() { vRestPosition = restPosition; vRestNormal = restNormal;`,
      )
      shader.fragmentShader = shader.fragmentShader
        .replace(
          'void main() {',
          `in vec3 vRestPosition, vRestNormal; uniform mat3 normalMatrix;
          ${declarations}
          vec3 exactNormal() {
            vec3 position = vRestPosition, normal = normalize(vRestNormal);
            ${code}
            return normalize(normalMatrix * warpedNormal);
          }
          void main() {`,
        )
        .replace('#include <normal_fragment_maps>', 'normal = exactNormal();')
    }
  }

const changes = {
  /** Reads the map without blurring it where the surface is seen at a small angle. */
  anisotropic: ({ material }) => {
    material.normalMap.anisotropy = renderer.capabilities.getMaxAnisotropy()
  },
  /** Makes three.js compute tangents from derivatives on the screen, as for files without tangents. */
  'no tangents': ({ geometry, material }) => {
    geometry.deleteAttribute('tangent')
    material.normalScale.y *= -1
  },
  'green down': ({ material }) => {
    material.normalScale.y *= -1
  },
}

/** Returns the number of drawn pixels, and a histogram of the max difference of their channels. */
async function compare(glb, exact, change) {
  const expected = await draw(exact.glb, withExactNormals(exact))
  const shown = await draw(glb, changes[change])
  const counts = Array(256).fill(0)
  let covered = 0
  for (let i = 0; i < shown.length; i += 4) {
    if (!shown[i + 3] && !expected[i + 3]) continue
    covered++
    const difference = Math.max(
      ...[0, 1, 2, 3].map((k) => Math.abs(shown[i + k] - expected[i + k])),
    )
    counts[Math.ceil(difference)]++
  }
  return { covered, counts }
}

globalThis.three = { compare }
document.title = 'ready'
