// Draws frames of warped meshes with three.js, for `npm run bench -- detail-frames`.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { defineFrameGlobals, size } from '../../detail-frames.js'

const renderer = new THREE.WebGLRenderer({ antialias: false })
renderer.setSize(size, size)
document.body.append(renderer.domElement)

function geometryOf({ positions, normals, indices }) {
  const geometry = new THREE.BufferGeometry()
  geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(positions), 3))
  geometry.setAttribute('normal', new THREE.BufferAttribute(Float32Array.from(normals), 3))
  geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(indices), 1))
  return geometry
}

defineFrameGlobals((mesh, offset, options, extent) => {
  const material = new THREE.MeshNormalMaterial({ side: THREE.DoubleSide })
  const scene = new THREE.Scene()
  const object = new THREE.Mesh(geometryOf(mesh), material)
  scene.add(object)
  const warped = warp(object, offset, options)
  const camera = new THREE.PerspectiveCamera(60, 1, 0.03 * extent, 20 * extent)
  return {
    gl: renderer.getContext(),
    frame(place, millis) {
      camera.position.set(...place)
      camera.lookAt(0, 0, 0)
      warped.update(millis)
      renderer.render(scene, camera)
    },
    triangles: () => renderer.info.render.triangles,
    dispose() {
      warped.dispose()
      object.geometry.dispose()
      material.dispose()
    },
  }
})
