// The warped surface on the CPU: a geometry like that of the object, its vertices warped.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Matrix3,
  Sphere,
  Vector3,
  type Material,
  type Matrix4,
} from 'three'
import { variationNames, type Vertices } from '../compile/hosts.js'
import { verticesOf, type Warpable } from './pose.js'
import type { ThreeWarp } from './three-warp.js'

/** Returns the object's geometry with warped vertices. For a warp in world space, pass `toWorld`; then the geometry is in that space. */
export function warpedGeometry(
  warp: ThreeWarp,
  object: Warpable,
  toWorld?: Matrix4,
): BufferGeometry {
  const isRest = warp.settings.space === 'rest'
  const { geometry } = object
  const vertices = verticesOf(object, !isRest, fillOf(object.material))
  const unwarped = toWorld ? inWorld(vertices, toWorld) : vertices
  const { positions, normals } = warp.evaluateNow(unwarped)
  const warped = new BufferGeometry()
  Object.assign(warped.attributes, geometry.attributes, {
    position: new BufferAttribute(positions, 3),
    ...(normals && { normal: new BufferAttribute(normals, 3) }),
  })
  const { index, groups, drawRange } = geometry
  Object.assign(warped, { index, groups, drawRange: { ...drawRange } })
  if (isRest) {
    warped.morphAttributes = geometry.morphAttributes
    warped.morphTargetsRelative = geometry.morphTargetsRelative
  }
  warped.boundingBox = boxOfFinite(positions)
  warped.boundingSphere = warped.boundingBox.getBoundingSphere(new Sphere())
  return warped
}

/** Returns a box around all finite positions: rays cannot hit others. */
function boxOfFinite(positions: Float32Array): Box3 {
  const box = new Box3()
  const point = new Vector3()
  for (let i = 0; i < positions.length; i += 3)
    // NaN unless all three are finite.
    if (positions[i]! * 0 + positions[i + 1]! * 0 + positions[i + 2]! * 0 === 0)
      box.expandByPoint(point.fromArray(positions, i))
  return box
}

/** Returns the colour of vertices without a colour of their own. */
export function fillOf(material: Material | Material[]): number[] {
  const { color, opacity } = [material].flat()[0] as Material & {
    color?: { r: number; g: number; b: number }
  }
  return [color?.r ?? 1, color?.g ?? 1, color?.b ?? 1, opacity]
}

/** Transforms vertices to world space as the shader does: see weave.ts. */
function inWorld(vertices: Vertices, toWorld: Matrix4): Vertices {
  const covariant = new Matrix3().getNormalMatrix(toWorld)
  const { positions, normals, ...others } = vertices as unknown as Arrays
  const uvGradients = gradientsOfUvs.flatMap((name) => {
    const numbers = others[name]
    return numbers ? [[name, mapVectors(numbers, (v) => v.applyMatrix3(covariant))] as const] : []
  })
  const transformed: Arrays = {
    ...others,
    ...Object.fromEntries(uvGradients),
    positions: mapVectors(positions!, (vector) => vector.applyMatrix4(toWorld)),
    ...(normals && { normals: mapVectors(normals, (v) => v.applyMatrix3(covariant).normalize()) }),
  }
  if (normals && gradientsOfNormals.every((name) => name in others))
    Object.assign(transformed, transformedGradients(vertices as unknown as Arrays, covariant))
  return transformed as unknown as Vertices
}

type Arrays = Record<string, Float32Array>

const gradients = variationNames.map((name) => `${name}s`)
const gradientsOfNormals = gradients.filter((name) => name.startsWith('normal'))
const gradientsOfUvs = gradients.filter((name) => !name.startsWith('normal'))

/**
 * Returns the rows of the derivative of the normal in the world. With C = `covariant`, that normal is C n / |C n|. Its derivative has no
 * part along the normal, and is with respect to the position in the world, which Cᵀ transforms back to the geometry.
 */
function transformedGradients(vertices: Arrays, covariant: Matrix3): Arrays {
  const rows = gradientsOfNormals.map((name) => vertices[name]!)
  const transformed = rows.map((numbers) => new Float32Array(numbers.length))
  const transposed = covariant.clone().transpose()
  const normalDerivative = new Matrix3()
  const normal = new Vector3()
  const column = new Vector3()
  const along = new Vector3()
  for (let i = 0; i < rows[0]!.length; i += 3) {
    normal.fromArray(vertices.normals!, i).applyMatrix3(covariant)
    const length = normal.length() || 1
    normal.divideScalar(length)
    rows.forEach((numbers, k) =>
      column.fromArray(numbers, i).toArray(normalDerivative.elements as unknown as number[], 3 * k),
    )
    normalDerivative.premultiply(covariant).multiply(transposed)
    along.copy(normal).applyMatrix3(normalDerivative)
    transformed.forEach((numbers, k) =>
      column
        .fromArray(normalDerivative.elements, 3 * k)
        .addScaledVector(along, -normal.getComponent(k))
        .divideScalar(length)
        .toArray(numbers, i),
    )
  }
  return Object.fromEntries(gradientsOfNormals.map((name, k) => [name, transformed[k]!]))
}

function mapVectors(numbers: Float32Array, work: (vector: Vector3) => Vector3) {
  const moved = new Float32Array(numbers.length)
  const vector = new Vector3()
  for (let i = 0; i < numbers.length; i += 3) work(vector.fromArray(numbers, i)).toArray(moved, i)
  return moved
}
