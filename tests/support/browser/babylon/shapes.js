// Meshes of Babylon.js, of about radius 1, for pictures of their normals.
import { Bone } from '@babylonjs/core/Bones/bone.js'
import { Skeleton } from '@babylonjs/core/Bones/skeleton.js'
import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import { Matrix } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'

/** A matrix that scales unevenly, for an instance or a bone. */
export const uneven = Matrix.Scaling(0.9, 0.5, 1.2).multiply(
  Matrix.RotationYawPitchRoll(0.3, 0.2, 0.5),
)

/** Maps a name → a function that makes a mesh of about radius 1. */
export const shapes = {
  sphere: (scene) => MeshBuilder.CreateSphere('sphere', { diameter: 2, segments: 10 }, scene),
  box: (scene) => MeshBuilder.CreateBox('box', { size: 1 }, scene),
  torus: (scene) =>
    MeshBuilder.CreateTorus('torus', { diameter: 1.8, thickness: 0.5, tessellation: 24 }, scene),
  plane: (scene) => MeshBuilder.CreatePlane('plane', { size: 1.6 }, scene),
  'plane with colors'(scene) {
    const mesh = shapes.plane(scene)
    const colors = Array.from({ length: mesh.getTotalVertices() }, () => [0.5, 1, 1, 1])
    mesh.setVerticesData(VertexBuffer.ColorKind, colors.flat())
    return mesh
  },
  facets(scene) {
    const mesh = shapes.sphere(scene)
    mesh.convertToFlatShadedMesh()
    return mesh
  },
  // Its only bone has a matrix that applies before that of the mesh.
  'sphere with a bone'(scene) {
    const mesh = shapes.sphere(scene)
    const firstOfFour = (value) =>
      Array.from({ length: 4 * mesh.getTotalVertices() }, (_, i) => (i % 4 ? 0 : value))
    mesh.setVerticesData(VertexBuffer.MatricesIndicesKind, firstOfFour(0))
    mesh.setVerticesData(VertexBuffer.MatricesWeightsKind, firstOfFour(1))
    mesh.numBoneInfluencers = 1
    mesh.skeleton = new Skeleton('skeleton', 'skeleton', scene)
    const bone = new Bone('bone', mesh.skeleton, null, Matrix.Identity())
    bone.getLocalMatrix().copyFrom(uneven)
    bone.markAsDirty()
    return mesh
  },
  // Its tangents are along u.
  'plane with tangents'(scene) {
    const mesh = shapes.plane(scene)
    const tangents = Array.from({ length: mesh.getTotalVertices() }, () => [1, 0, 0, 1])
    mesh.setVerticesData(VertexBuffer.TangentKind, tangents.flat())
    return mesh
  },
  'sphere with tangents'(scene) {
    const mesh = shapes.sphere(scene)
    const positions = mesh.getVerticesData(VertexBuffer.PositionKind)
    const tangents = Array.from({ length: positions.length / 3 }, (_, i) => {
      const [x, , z] = positions.slice(3 * i, 3 * i + 3)
      const length = Math.hypot(x, z)
      return length > 1e-6 ? [-z / length, 0, x / length, 1] : [1, 0, 0, 1]
    })
    mesh.setVerticesData(VertexBuffer.TangentKind, tangents.flat())
    return mesh
  },
}
