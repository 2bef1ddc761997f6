// Counts pixels at which the background shows through closed, moving shapes with detail.
import * as THREE from 'three'
import { breakEdge } from '../../holes.js'
import { camera, countHoles, covered, sceneOf, warpBy } from './pictures.js'

const shapes = {
  sphere: () => new THREE.IcosahedronGeometry(0.5, 2),
  torus: () => new THREE.TorusGeometry(0.4, 0.22, 12, 20),
  box: () => new THREE.BoxGeometry(0.8, 0.8, 0.8),
}

/** Breaks an edge in the indices of each division, before they are uploaded. Returns { count(), stop() }. */
function breakDivisions() {
  const { prototype } = THREE.BufferAttribute
  const before = Object.getOwnPropertyDescriptor(prototype, 'needsUpdate')
  const interleaved = Object.getOwnPropertyDescriptor(
    THREE.InterleavedBuffer.prototype,
    'needsUpdate',
  )
  let [count, indexUploads, buffers] = [0, 0, []]
  // A division uploads its buffers before its indices. The first buffer has the positions.
  Object.defineProperty(prototype, 'needsUpdate', {
    configurable: true,
    set(value) {
      const { array, itemSize, updateRanges } = this
      if (array instanceof Uint32Array && updateRanges.length) {
        const drawn = array.subarray(0, updateRanges[0].count)
        const { array: positions, stride } = buffers[0]
        if (breakEdge(drawn, positions, stride, 53 * indexUploads++)) count++
        buffers = []
      } else buffers.push({ array, stride: itemSize })
      before.set.call(this, value)
    },
  })
  Object.defineProperty(THREE.InterleavedBuffer.prototype, 'needsUpdate', {
    configurable: true,
    set(value) {
      buffers.push(this)
      interleaved.set.call(this, value)
    },
  })
  return {
    count: () => count,
    stop() {
      Object.defineProperty(prototype, 'needsUpdate', before)
      Object.defineProperty(THREE.InterleavedBuffer.prototype, 'needsUpdate', interleaved)
    },
  }
}

/** Moves one corner of one triangle of the sphere: the one nearest to the camera. */
function breakMesh({ attributes: { position } }, view) {
  const towards = view.position.clone().normalize()
  const place = new THREE.Vector3()
  const ahead = (i) => place.fromBufferAttribute(position, i).dot(towards)
  const nearest = Array.from({ length: position.count }, (_, i) => i).reduce((a, b) =>
    ahead(a) > ahead(b) ? a : b,
  )
  place.fromBufferAttribute(position, nearest).addScalar(0.05)
  position.setXYZ(nearest, ...place)
}

/** Moves the camera near the plane of the torus, so that it never looks through the hole of the torus. */
function moveCamera(view, frame) {
  const distance = 5.4 + 0.8 * Math.cos(frame / 30)
  const angle = frame / 50
  view.position.set(Math.cos(angle), Math.sin(angle), 0.1 * Math.sin(frame / 20))
  view.position.multiplyScalar(distance)
  view.lookAt(0, 0, 0)
}

/**
 * Draws frames. Returns the number of pixels with background inside of the shapes (`holes`), the number of frames with such pixels, the min
 * number of pixels that the shapes cover (`least`), and the number of different divisions. `broken` says where an edge is broken on
 * purpose: in each `'division'`, or in the `'mesh'` that is divided.
 */
export async function holes({ draw, triangles }, { frames = 300, broken, tolerance = 1 }) {
  const view = camera()
  view.up.set(0, 0, 1)
  moveCamera(view, 0)
  const { scene } = sceneOf('box')
  scene.clear()
  const breaking = broken === 'division' ? breakDivisions() : undefined
  const warps = Object.values(shapes).map((shape, i) => {
    const geometry = shape()
    if (i === 0 && broken === 'mesh') breakMesh(geometry, view)
    const { mesh } = sceneOf(geometry)
    mesh.position.z = 1.1 * (i - 1)
    scene.add(mesh)
    return warpBy(mesh, 'noise', tolerance, { uniforms: { amount: 0.08 }, normals: 'vertex' })
  })
  const found = { holes: 0, framesWithHoles: 0, least: Infinity }
  const divisions = new Set()
  for (let frame = 0; frame < frames; frame++) {
    for (const warped of warps) warped.update(33 * frame)
    moveCamera(view, frame)
    const picture = await draw(scene, view)
    const count = countHoles(picture)
    found.holes += count
    if (count > 0) found.framesWithHoles++
    found.least = Math.min(found.least, covered(picture))
    divisions.add(triangles())
  }
  for (const warped of warps) warped.dispose()
  breaking?.stop()
  return { ...found, divisions: divisions.size, broken: breaking?.count() }
}
