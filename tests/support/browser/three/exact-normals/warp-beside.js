// Meshes that have both: a material with `exactNormals`, and a warp. Each is compared with one of which a half was moved by hand.
import * as THREE from 'three/webgpu'
import { exactNormals, tslOffset, warp } from 'warpjet/three/webgpu'

const { Fn, positionLocal, sin, vec3 } = THREE.TSL

/** A function of TSL with a layout, which becomes a function of the shader. */
const wave = Fn(([x]) => sin(x.mul(3)).mul(0.3)).setLayout({
  name: 'wave',
  type: 'float',
  inputs: [{ name: 'x', type: 'float' }],
})

const offsets = {
  glsl: ({ glsl, position }) => glsl.vec3(0, 0, position.y().mult(3).sin().mult(0.3)),
  /** The same, by the function that the positionNode calls. */
  tsl: tslOffset((p) => vec3(0, 0, wave(p.y))),
}

const sphere = () => new THREE.SphereGeometry(0.8, 128, 96)

/** Moves the vertices of a sphere along one axis by a wave along another, and their normals by its derivative. */
function movedByHand(geometry, along, by) {
  const { position, normal } = geometry.attributes
  for (let i = 0; i < position.count; i++) {
    const x = position.getComponent(i, by)
    const slope = 0.9 * Math.cos(3 * x)
    position.setComponent(i, along, position.getComponent(i, along) + 0.3 * Math.sin(3 * x))
    const n = new THREE.Vector3().fromBufferAttribute(normal, i)
    n.setComponent(by, n.getComponent(by) - slope * n.getComponent(along)).normalize()
    normal.setXYZ(i, ...n.toArray())
  }
  return geometry
}

function materialOf(isDisplaced, isExact = isDisplaced, normals = 'vertex') {
  const material = new THREE.MeshNormalNodeMaterial()
  if (isDisplaced) material.positionNode = positionLocal.add(vec3(0, wave(positionLocal.x), 0))
  return isExact ? exactNormals(material, { normals }) : material
}

function meshOf(geometry, material, isInstanced) {
  const mesh = isInstanced
    ? new THREE.InstancedMesh(geometry, material, 2)
    : new THREE.Mesh(geometry, material)
  for (let i = 0; isInstanced && i < 2; i++)
    mesh.setMatrixAt(
      i,
      new THREE.Matrix4()
        .makeRotationZ(i)
        .setPosition(i - 0.5, 0, 0)
        .scale(new THREE.Vector3(0.6, 0.6, 0.6)),
    )
  mesh.rotation.set(0.3, 0.4, 0)
  mesh.frustumCulled = false
  return mesh
}

const warped = (mesh, options, offset = offsets.glsl) => {
  warp(mesh, offset, { normals: 'vertex', ...options })
  return mesh
}

/** The warp comes after the positionNode. */
const after = (options, offset) => ({
  both: () => warped(meshOf(sphere(), materialOf(true)), options, offset),
  byHand: () => warped(meshOf(movedByHand(sphere(), 1, 0), materialOf(false)), options),
  withoutExact: () => warped(meshOf(sphere(), materialOf(true, false)), options),
})

/** The warp comes before the positionNode. */
const before = (options, isInstanced) => ({
  both: () => warped(meshOf(sphere(), materialOf(true), isInstanced), options),
  byHand: () => meshOf(movedByHand(sphere(), 2, 1), materialOf(true), isInstanced),
  withoutExact: () => warped(meshOf(sphere(), materialOf(true, false), isInstanced), options),
})

export const warpBeside = {
  local: after({}),
  world: after({ space: 'world' }),
  rest: before({ space: 'rest' }),
  instances: before({}, true),
  'a function that both call': after({}, offsets.tsl),
  'normals of the warp at pixels': after({ normals: 'auto' }),
}
