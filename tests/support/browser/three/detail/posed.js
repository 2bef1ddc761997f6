// Compares meshes with bones and morph targets, with and without detail, with fine ones that are posed by three's own methods.
import * as THREE from 'three'
import { camera, countBeyond, sceneOf, warpBy } from './pictures.js'

/** Makes a box of few triangles, which bones can bend and a morph target can widen at the top. */
function makePoseable({ hasBones, hasMorphs }) {
  const geometry = new THREE.BoxGeometry(1.1, 1.8, 1.1, 1, 2, 1)
  const { position, normal } = geometry.attributes
  const all = Array.from({ length: position.count }, (_, i) => i)
  const isTop = (i) => position.getY(i) > 0.5
  const attribute = (size, numbersOf) =>
    new THREE.Float32BufferAttribute(all.flatMap(numbersOf), size)
  geometry.setAttribute(
    'color',
    attribute(3, (i) => (isTop(i) ? [0.9, 0.2, 0.1] : [0.1, 0.3, 0.9])),
  )
  if (hasMorphs) {
    geometry.morphTargetsRelative = true
    geometry.morphAttributes.position = [
      attribute(3, (i) => (isTop(i) ? [0.4 * position.getX(i), 0.2, 0] : [0, 0, 0])),
    ]
    geometry.morphAttributes.normal = [attribute(3, (i) => (isTop(i) ? [0.3, 0.5, 0] : [0, 0, 0]))]
    geometry.morphAttributes.color = [attribute(3, (i) => (isTop(i) ? [-0.5, 0.6, 0] : [0, 0, 0]))]
  }
  if (!hasBones) return { geometry, normal }
  geometry.setAttribute(
    'skinIndex',
    new THREE.Uint16BufferAttribute(
      all.flatMap(() => [1, 0, 0, 0]),
      4,
    ),
  )
  geometry.setAttribute(
    'skinWeight',
    attribute(4, (i) => [position.getY(i) / 1.8 + 0.5, 0.5 - position.getY(i) / 1.8, 0, 0]),
  )
  return { geometry, normal }
}

function meshOf(kinds, material) {
  const { geometry } = makePoseable(kinds)
  const Kind = kinds.hasBones ? THREE.SkinnedMesh : THREE.Mesh
  const mesh = new Kind(geometry, material)
  if (kinds.hasMorphs) mesh.morphTargetInfluences[0] = 0.7
  if (!kinds.hasBones) return mesh
  const [root, tip] = [new THREE.Bone(), new THREE.Bone()]
  root.position.y = -0.9
  tip.position.y = 0.9
  mesh.add(root.add(tip))
  mesh.updateMatrixWorld(true)
  mesh.bind(new THREE.Skeleton([root, tip]))
  return mesh
}

/** Rotates the second bone by an angle, or sets the influence of the morph target. */
function pose(mesh, amount) {
  if (mesh.skeleton) mesh.skeleton.bones[1].rotation.set(0, 0, amount)
  else mesh.morphTargetInfluences[0] = amount
  mesh.updateMatrixWorld(true)
}

const pieces = 32

/** Returns the posed triangles of a mesh, each divided into equal ones. */
function fineOf(mesh) {
  const { index, attributes, morphAttributes } = mesh.geometry
  const vectors = Array.from({ length: attributes.position.count }, (_, i) => {
    const target = (name) => {
      const vector = new THREE.Vector3().fromBufferAttribute(attributes[name], i)
      const [morph] = morphAttributes[name] ?? []
      if (!morph) return vector
      const by = new THREE.Vector3().fromBufferAttribute(morph, i)
      return vector.addScaledVector(by, mesh.morphTargetInfluences[0])
    }
    const normal = target('normal')
    if (mesh.isSkinnedMesh) {
      mesh.applyBoneTransform(i, normal)
      normal.sub(mesh.applyBoneTransform(i, new THREE.Vector3()))
    }
    const position = mesh.getVertexPosition(i, new THREE.Vector3())
    return { position, normal, color: target('color') }
  })
  const numbers = { position: [], normal: [], color: [] }
  const add = (corners, weights) => {
    for (const name of Object.keys(numbers)) {
      const sum = new THREE.Vector3()
      corners.forEach((corner, k) => sum.addScaledVector(vectors[corner][name], weights[k]))
      if (name === 'normal') sum.normalize()
      numbers[name].push(...sum)
    }
  }
  for (let t = 0; t < index.count; t += 3) {
    const corners = [0, 1, 2].map((k) => index.getX(t + k))
    const at = (i, j) => add(corners, [1 - (i + j) / pieces, i / pieces, j / pieces])
    for (let i = 0; i < pieces; i++)
      for (let j = 0; i + j < pieces; j++) {
        for (const [u, v] of [
          [i, j],
          [i + 1, j],
          [i, j + 1],
        ])
          at(u, v)
        if (i + j + 1 === pieces) continue
        for (const [u, v] of [
          [i + 1, j],
          [i + 1, j + 1],
          [i, j + 1],
        ])
          at(u, v)
      }
  }
  const geometry = new THREE.BufferGeometry()
  for (const [name, values] of Object.entries(numbers))
    geometry.setAttribute(name, new THREE.Float32BufferAttribute(values, 3))
  return geometry
}

const materials = {
  normals: () => new THREE.MeshNormalMaterial(),
  colors: () => new THREE.MeshBasicMaterial({ vertexColors: true }),
}

/** Compares several poses of a mesh, one after the other. */
export async function comparePoses({ draw, triangles }, { kinds, look, space }) {
  const view = camera()
  const { scene } = sceneOf('box')
  const picturesOf = async (detail, isFine) => {
    const mesh = meshOf(kinds, materials[look]())
    mesh.rotation.z = 0.3
    const shown = isFine ? new THREE.Mesh(fineOf(mesh), mesh.material) : mesh
    shown.rotation.z = 0.3
    scene.clear().add(shown)
    const warped = warpBy(shown, 'twist', detail, { space })
    const pictures = []
    for (const amount of [0.5, -0.8, -0.8]) {
      pose(mesh, amount)
      if (isFine) shown.geometry = fineOf(mesh)
      pictures.push(await draw(scene, view))
    }
    const drawn = triangles()
    warped.dispose()
    return { pictures, drawn, isSkinned: shown.isSkinnedMesh === true, mesh }
  }
  const expected = await picturesOf(undefined, true)
  const coarse = await picturesOf()
  const divided = await picturesOf(1)
  const differences = ({ pictures }) =>
    pictures.map((picture, i) => countBeyond(picture, expected.pictures[i]))
  return {
    beyond: differences(divided),
    without: differences(coarse),
    triangles: divided.drawn,
    fine: expected.drawn,
    isRestored:
      divided.isSkinned === kinds.hasBones && 'position' in divided.mesh.geometry.attributes,
  }
}
