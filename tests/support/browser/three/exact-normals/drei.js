// The materials of drei that move vertices, bundled by Vite for drei.browser.test.js.
import { MeshDistortMaterial } from '@react-three/drei/core/MeshDistortMaterial'
import { MeshWobbleMaterial } from '@react-three/drei/core/MeshWobbleMaterial'
import * as THREE from 'three'
import { renderMaterial } from '../company/react-material.js'
import { measure } from './measure.js'
import { shadowOnFloor } from './meshes.js'
import { simplex } from './simplex.js'

const [time, factor, distort] = [1.3, 0.9, 0.6]

const materials = {
  async MeshDistortMaterial() {
    const material = await renderMaterial(MeshDistortMaterial, { speed: 0, distort, radius: 1 })
    material.time = time
    return material
  },
  async MeshWobbleMaterial() {
    const material = await renderMaterial(MeshWobbleMaterial, { speed: 0, factor })
    material.time = time
    return material
  },
}

const rows = {
  MeshDistortMaterial: {
    shape: 'sphere',
    moved(p) {
      const scale = simplex(p.map((x) => x / 2 + time / 10)) * distort ** 2 + 1
      return p.map((x) => x * scale)
    },
  },
  MeshWobbleMaterial: {
    shape: 'plane',
    moved([x, y, z]) {
      const theta = (Math.sin(time + y) / 2) * factor
      const [c, s] = [Math.cos(theta), Math.sin(theta)]
      return [c * x + s * z, y, c * z - s * x]
    },
  },
}

globalThis.drei = {
  names: Object.keys(rows),
  async measure(name, normals) {
    const material = await materials[name]()
    return measure({ ...rows[name], material: () => material }, normals, true)
  },
  async shadow(name) {
    const geometry =
      name === 'MeshDistortMaterial'
        ? new THREE.SphereGeometry(0.8, 64, 48)
        : new THREE.BoxGeometry(1.2, 1.2, 0.2, 8, 24, 2)
    return shadowOnFloor(geometry, await materials[name](), rows[name].moved)
  },
}
document.title = 'ready'
