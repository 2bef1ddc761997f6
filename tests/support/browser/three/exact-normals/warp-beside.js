// Meshes that have both a warp and a material with `exactNormals`. Each is compared with a mesh to which one of the two motions is applied
// by hand, in the geometry.
import * as THREE from 'three/webgpu'
import { exactNormals, tslOffset, warp } from 'warpjet/three/webgpu'
import { noise } from './materialx.js'

const { mx_noise_float, positionLocal, sin, vec3 } = THREE.TSL

/** Maps a name → a height, as a node and in double precision. For `noise`, the shader calls a function twice. */
const heights = {
  wave: {
    node: (p, axis) => sin(p[axis].mul(3)).mul(0.3),
    at: (p, axis) => 0.3 * Math.sin(3 * p['xyz'.indexOf(axis)]),
  },
  noise: {
    node: (p) =>
      mx_noise_float(p.mul(2))
        .mul(0.3)
        .add(mx_noise_float(p.mul(4)).mul(0.1)),
    at: (p) => 0.3 * noise(p.map((x) => 2 * x)) + 0.1 * noise(p.map((x) => 4 * x)),
  },
}

const offsets = {
  wave: ({ glsl, position }) => glsl.vec3(0, 0, position.y().mult(3).sin().mult(0.3)),
  noise: tslOffset((p) => vec3(0, 0, heights.noise.node(p))),
}

const makeSphere = () => new THREE.SphereGeometry(0.8, 128, 96)

/** Makes a sphere whose vertices move along one axis by a height that depends on another; its normals come from finite differences. */
function makeMovedSphere(height, along, by) {
  const geometry = makeSphere()
  const { position, normal } = geometry.attributes
  const k = 'xyz'.indexOf(along)
  for (let i = 0; i < position.count; i++) {
    const p = [0, 1, 2].map((axis) => position.getComponent(i, axis))
    const slopes = p.map((_, axis) => {
      const heightAt = (e) => heights[height].at(p.with(axis, p[axis] + e), by)
      return (heightAt(1e-4) - heightAt(-1e-4)) / 2e-4
    })
    const n = new THREE.Vector3().fromBufferAttribute(normal, i)
    const slope = new THREE.Vector3(...slopes).multiplyScalar(n.getComponent(k))
    n.multiplyScalar(1 + slopes[k])
      .sub(slope)
      .normalize()
    position.setComponent(i, k, p[k] + heights[height].at(p, by))
    normal.setXYZ(i, ...n.toArray())
  }
  return geometry
}

function makeMaterial(height, isExact = true) {
  const material = new THREE.MeshNormalNodeMaterial()
  if (!height) return material
  material.positionNode = positionLocal.add(vec3(0, heights[height].node(positionLocal, 'x'), 0))
  return isExact ? exactNormals(material, { normals: 'vertex' }) : material
}

function makeMesh(geometry, material, isInstanced) {
  const mesh = isInstanced
    ? new THREE.InstancedMesh(geometry, material, 2)
    : new THREE.Mesh(geometry, material)
  for (let i = 0; isInstanced && i < 2; i++) {
    const matrix = new THREE.Matrix4().makeRotationZ(i).setPosition(i - 0.5, 0, 0)
    mesh.setMatrixAt(i, matrix.scale(new THREE.Vector3(0.6, 0.6, 0.6)))
  }
  mesh.rotation.set(0.3, 0.4, 0)
  mesh.frustumCulled = false
  return mesh
}

function warpMesh(mesh, height, options) {
  warp(mesh, offsets[height], { normals: 'vertex', ...options })
  return mesh
}

/** Meshes whose warp applies after the positionNode. */
const warpAfter = (options, height = 'wave') => ({
  both: () => warpMesh(makeMesh(makeSphere(), makeMaterial(height)), height, options),
  byHand: () =>
    warpMesh(makeMesh(makeMovedSphere(height, 'y', 'x'), makeMaterial()), height, options),
  withoutExact: () =>
    warpMesh(makeMesh(makeSphere(), makeMaterial(height, false)), height, options),
})

/** Meshes whose warp applies before the positionNode. */
const warpBefore = (options, isInstanced) => ({
  both: () => warpMesh(makeMesh(makeSphere(), makeMaterial('wave'), isInstanced), 'wave', options),
  byHand: () => makeMesh(makeMovedSphere('wave', 'z', 'y'), makeMaterial('wave'), isInstanced),
  withoutExact: () =>
    warpMesh(makeMesh(makeSphere(), makeMaterial('wave', false), isInstanced), 'wave', options),
})

/**
 * Maps a name → functions that make meshes: with both motions, with one of them by hand, and with a material without `exactNormals`.
 */
export const warpBeside = {
  local: warpAfter({}),
  world: warpAfter({ space: 'world' }),
  rest: warpBefore({ space: 'rest' }),
  instances: warpBefore({}, true),
  'a noise function that warp and positionNode call': warpAfter({}, 'noise'),
  'normals of the warp at pixels': warpAfter({ normals: 'auto' }),
}
