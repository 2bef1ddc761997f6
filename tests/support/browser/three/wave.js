// A wave whose normals are known, for comparison with the colors that MeshNormalMaterial shows.
import * as THREE from 'three'

const size = 64

/** The wave as an offset, which depends on the time. */
export const offset = ({ glsl, position, millis }) => {
  const x = position.x().mult(4).add(millis.div(1000)).sin().mult(0.15)
  return glsl.vec3(0, 0, x.add(position.y().mult(5).cos().mult(0.1)))
}

/** Times in milliseconds: at the start, and after a week. */
export const moments = [700, 6e8 + 700]

/** Returns the expected red, green and blue of a pixel, from 0 to 1. */
function expectedColor(x, y, millis) {
  const normal = [-0.6 * Math.cos(4 * x + millis / 1000), 0.5 * Math.sin(5 * y), 1]
  const length = Math.hypot(...normal)
  return normal.map((component) => (component / length) * 0.5 + 0.5)
}

export function makeWaveScene(material = new THREE.MeshNormalMaterial()) {
  const scene = new THREE.Scene()
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2.4, 2.4, 160, 160), material)
  scene.add(mesh)
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 10)
  camera.position.z = 5
  camera.updateMatrixWorld()
  return { scene, camera, mesh, size }
}

/** Returns the max error in units of 1/255. `pixels` are colours from 0 to 1, whose first row is at the bottom if `isUpwards`. */
export function maxError(pixels, { isUpwards = true, millis = moments[0] } = {}) {
  let worst = 0
  for (let j = 0; j < size; j++)
    for (let i = 0; i < size; i++) {
      const [x, y] = [(i + 0.5) / (size / 2) - 1, (j + 0.5) / (size / 2) - 1]
      const row = isUpwards ? j : size - 1 - j
      expectedColor(x, y, millis).forEach((component, k) => {
        worst = Math.max(worst, 255 * Math.abs(pixels[4 * (row * size + i) + k] - component))
      })
    }
  return worst
}
