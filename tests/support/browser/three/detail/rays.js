// Compares rays that meet meshes with detail with rays that meet fine ones.
import * as THREE from 'three'
import { camera, sceneOf, warpBy } from './pictures.js'

const raysAcross = 24

function cast(view, mesh) {
  const raycaster = new THREE.Raycaster()
  const all = []
  for (let y = 0; y < raysAcross; y++)
    for (let x = 0; x < raysAcross; x++) {
      const position = [x, y].map((i) => ((i + 0.5) / raysAcross) * 2 - 1)
      raycaster.setFromCamera(new THREE.Vector2(...position), view)
      all.push(raycaster.intersectObject(mesh)[0])
    }
  return all
}

/** Compares hits on a divided box with those on a fine one, and checks that hits name triangles of the user's mesh. */
export async function rays({ draw }, { space, isMoved = false }) {
  const view = camera()
  const hitsOf = async (shape, detail) => {
    const { scene, mesh } = sceneOf(shape)
    mesh.material.side = THREE.DoubleSide
    mesh.rotation.y = 0.3
    const warped = warpBy(mesh, 'twist', detail, { space })
    if (detail && !isMoved) await draw(scene, view)
    if (isMoved) {
      await draw(scene, view)
      warped.uniforms.amount.value = 0.7
    }
    mesh.updateMatrixWorld()
    view.updateMatrixWorld()
    const hits = cast(view, mesh)
    warped.dispose()
    return { hits, mesh }
  }
  const expected = await hitsOf('fine')
  const coarse = await hitsOf('box')
  const divided = await hitsOf('box', 1)
  const distances = ({ hits }) =>
    hits.map((hit, i) => {
      const expectedHit = expected.hits[i]
      if (!hit || !expectedHit) return hit === expectedHit ? 0 : Infinity
      return hit.point.distanceTo(expectedHit.point)
    })
  const { geometry } = divided.mesh
  const errorsOfUv = divided.hits.filter(Boolean).map(({ face, faceIndex, barycoord, uv }) => {
    const corners = [0, 1, 2].map((k) => geometry.index.getX(3 * faceIndex + k))
    if (`${corners}` !== `${[face.a, face.b, face.c]}`) return Infinity
    if (!barycoord) return 0
    const at = new THREE.Vector2()
    corners.forEach((corner, k) =>
      at.addScaledVector(
        new THREE.Vector2().fromBufferAttribute(geometry.attributes.uv, corner),
        barycoord.getComponent(k),
      ),
    )
    return at.distanceTo(uv)
  })
  const areOnMesh = divided.hits.every((hit) => !hit || hit.object === divided.mesh)
  const beyond = (found) => distances(found).filter((distance) => distance > 0.05).length
  return {
    hits: divided.hits.filter(Boolean).length,
    beyond: beyond(divided),
    without: beyond(coarse),
    errorOfUv: Math.max(...errorsOfUv),
    areOnMesh,
  }
}
