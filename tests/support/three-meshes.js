// Meshes, a wave and rays for tests of warps in three.js.
import * as THREE from 'three'

export const wave = ({ glsl, position, uniforms, millis }) =>
  glsl.vec3(0, 0, position.x().mult(3).add(millis.div(500)).sin().mult(uniforms.height))

export const plane = (material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })) =>
  new THREE.Mesh(new THREE.PlaneGeometry(2, 2, 40, 40), material)

/** Returns a generator of random numbers from 0 to 1 that are the same in each run. */
export function randomNumbers(seed = 1) {
  let state = seed
  return () => (state = (state * 16807) % 2147483647) / 2147483647
}

/** Makes a ray from a random point at a distance of 8 to a random point near `target`. */
export const rayFrom = (random, target, spread) => {
  const from = new THREE.Vector3(random() - 0.5, random() - 0.5, random() - 0.5)
    .normalize()
    .multiplyScalar(8)
  const to = new THREE.Vector3(random() - 0.5, random() - 0.5, random() - 0.5)
    .multiplyScalar(spread)
    .add(target)
  return new THREE.Raycaster(from, to.sub(from).normalize())
}

/** Moves, rotates and unevenly scales a mesh. */
export function transform(mesh) {
  mesh.position.set(0.3, -0.2, 0.1)
  mesh.rotation.set(0.4, 0.8, -0.3)
  mesh.scale.set(1.2, 0.8, 1)
  mesh.updateMatrixWorld(true)
  return mesh
}

export function makeSkinnedMesh() {
  const geometry = new THREE.CylinderGeometry(0.2, 0.2, 2, 8, 10)
  const { position } = geometry.attributes
  const weights = []
  for (let i = 0; i < position.count; i++) {
    const amount = (position.getY(i) + 1) / 2
    weights.push(1 - amount, amount, 0, 0)
  }
  geometry.setAttribute(
    'skinIndex',
    new THREE.Uint16BufferAttribute(
      weights.map((_, i) => [0, 1, 0, 0][i % 4]),
      4,
    ),
  )
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4))
  const bones = [new THREE.Bone(), new THREE.Bone()]
  bones[0].add(bones[1])
  const mesh = new THREE.SkinnedMesh(
    geometry,
    new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }),
  )
  mesh.add(bones[0])
  mesh.bind(new THREE.Skeleton(bones))
  return mesh
}

export function makeMorphingMesh() {
  const mesh = plane()
  const target = mesh.geometry.attributes.position.clone()
  for (let i = 0; i < target.count; i++) target.setXYZ(i, 2 * target.getX(i), target.getY(i), 1)
  mesh.geometry.morphAttributes.position = [target]
  mesh.updateMorphTargets()
  return mesh
}
