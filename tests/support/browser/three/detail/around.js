// Draws a divided box, seen from all sides.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { paintSquares, swell } from '../../swollen-box.js'
import { countBeyond, covered, sceneOf } from './pictures.js'

const texture = new THREE.DataTexture(paintSquares(), 240, 240)
texture.needsUpdate = true
const material = new THREE.MeshBasicMaterial({ map: texture })

/** Draws a box from all positions of the camera. Returns the pictures. */
async function picturesOf({ draw, framesUntilLargeEnough = 1 }, places, pieces, detail = false) {
  const { scene, mesh } = sceneOf(new THREE.BoxGeometry(1, 1, 1, pieces, pieces, pieces), {
    material,
  })
  const warped = warp(mesh, swell, { detail })
  const camera = new THREE.PerspectiveCamera(180 / Math.PI, 1, 0.1, 10)
  const frames = detail ? framesUntilLargeEnough : 1
  const pictures = []
  for (const place of places) {
    camera.position.set(...place)
    camera.lookAt(0, 0, 0)
    for (let i = 1; i < frames; i++) await draw(scene, camera)
    pictures.push(await draw(scene, camera))
  }
  warped.dispose()
  return pictures
}

/** Compares a box, with and without detail, with a dense one. Returns the numbers of pixels for `checkPictures`. */
export async function around(host, { places }) {
  const dense = await picturesOf(host, places, 48)
  const beyond = async (detail) => {
    const pictures = await picturesOf(host, places, 1, detail)
    // All channels of colors are 0 or 255.
    return pictures.map((picture, i) => countBeyond(picture, dense[i], 128))
  }
  return {
    covered: dense.map(covered),
    divided: await beyond(1),
    rough: await beyond(8),
    coarse: await beyond(),
  }
}
