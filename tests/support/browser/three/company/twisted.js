// Applies the motion of three's example materials_modified and of drei's wobble on the CPU: rotates positions and normals about y by an
// angle that depends on y. Both shaders rotate the normal in view space, whose axes are those of local space if the camera looks along -z.
import * as THREE from 'three'
import { mesh, standard, torus } from './lib.js'

export function twistByHand() {
  const geometry = torus()
  const { position, normal } = geometry.attributes
  for (let i = 0; i < position.count; i++) {
    const theta = Math.sin(1 + position.getY(i)) / 2
    const [c, s] = [Math.cos(theta), Math.sin(theta)]
    for (const each of [position, normal]) {
      const [x, z] = [each.getX(i), each.getZ(i)]
      each.setX(i, x * c + z * s)
      each.setZ(i, z * c - x * s)
    }
  }
  return mesh(standard(), geometry)
}

export function straightCamera() {
  const made = new THREE.PerspectiveCamera(45, 1, 0.5, 20)
  made.position.z = 4
  made.updateMatrixWorld()
  return made
}
