// The warped surface on the CPU: a geometry like that of the object, its vertices warped.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  type Material,
  Matrix3,
  type Matrix4,
  Sphere,
  Vector3,
} from 'three'
import type { ThreeWarp } from './kept.js'
import { type Warpable, verticesOf } from './pose.js'

interface Arrays {
  positions: Float32Array
  normals?: Float32Array
}

/** `toWorld` is for a warp of that space: the geometry is in it then. */
export function warpedGeometry(
  warp: ThreeWarp,
  object: Warpable,
  toWorld?: Matrix4,
): BufferGeometry {
  const isRest = warp.settings.space === 'rest'
  const { geometry } = object
  const vertices = verticesOf(object, !isRest, fillOf(object.material))
  const { positions, normals } = warp.cpu.evaluate(
    toWorld ? { ...vertices, ...inWorld(vertices as Arrays, toWorld) } : vertices,
    { uniforms: warp.given() },
  )
  const made = new BufferGeometry()
  Object.assign(made.attributes, geometry.attributes, {
    position: new BufferAttribute(positions, 3),
    ...(normals && { normal: new BufferAttribute(normals, 3) }),
  })
  const { index, groups, drawRange } = geometry
  Object.assign(made, { index, groups, drawRange: { ...drawRange } })
  if (isRest) {
    made.morphAttributes = geometry.morphAttributes
    made.morphTargetsRelative = geometry.morphTargetsRelative
  }
  made.boundingBox = new Box3().setFromBufferAttribute(made.attributes.position as BufferAttribute)
  made.boundingSphere = made.boundingBox.getBoundingSphere(new Sphere())
  return made
}

/** The colour that vertices without one have. */
export function fillOf(material: Material | Material[]): number[] {
  const { color, opacity } = [material].flat()[0] as Material & {
    color?: { r: number; g: number; b: number }
  }
  return [color?.r ?? 1, color?.g ?? 1, color?.b ?? 1, opacity]
}

function inWorld({ positions, normals }: Arrays, toWorld: Matrix4): Arrays {
  const covariant = new Matrix3().getNormalMatrix(toWorld)
  return {
    positions: each(positions, (vector) => vector.applyMatrix4(toWorld)),
    ...(normals && { normals: each(normals, (v) => v.applyMatrix3(covariant).normalize()) }),
  }
}

function each(numbers: Float32Array, work: (vector: Vector3) => Vector3) {
  const moved = new Float32Array(numbers.length)
  const vector = new Vector3()
  for (let i = 0; i < numbers.length; i += 3) work(vector.fromArray(numbers, i)).toArray(moved, i)
  return moved
}
