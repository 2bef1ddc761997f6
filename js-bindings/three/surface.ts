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

/** `toWorld` is for a warp of that space: the geometry is in it then. */
export function warpedGeometry(
  warp: ThreeWarp,
  object: Warpable,
  toWorld?: Matrix4,
): BufferGeometry {
  const isRest = warp.settings.space === 'rest'
  const { geometry } = object
  const vertices = verticesOf(object, !isRest, fillOf(object.material))
  const placed = toWorld ? inWorld(vertices, toWorld) : vertices
  const { positions, normals } = warp.evaluateNow(placed)
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
  made.boundingBox = boxOfFinite(positions)
  made.boundingSphere = made.boundingBox.getBoundingSphere(new Sphere())
  return made
}

/** Around all places that rays can meet. */
function boxOfFinite(positions: Float32Array): Box3 {
  const box = new Box3()
  const place = new Vector3()
  for (let i = 0; i < positions.length; i += 3)
    // NaN unless all three are finite.
    if (positions[i]! * 0 + positions[i + 1]! * 0 + positions[i + 2]! * 0 === 0)
      box.expandByPoint(place.fromArray(positions, i))
  return box
}

/** The colour that vertices without one have. */
export function fillOf(material: Material | Material[]): number[] {
  const { color, opacity } = [material].flat()[0] as Material & {
    color?: { r: number; g: number; b: number }
  }
  return [color?.r ?? 1, color?.g ?? 1, color?.b ?? 1, opacity]
}

/** Transforms vertices to world space as the shader does: see weave.ts. */
export function inWorld(vertices: Vertices, toWorld: Matrix4): Vertices {
  const covariant = new Matrix3().getNormalMatrix(toWorld)
  const { positions, normals, ...others } = vertices as unknown as Arrays
  const ofUvs = gradientsOfUvs.flatMap((name) => {
    const numbers = others[name]
    return numbers ? [[name, each(numbers, (v) => v.applyMatrix3(covariant))] as const] : []
  })
  const made: Arrays = {
    ...others,
    ...Object.fromEntries(ofUvs),
    positions: each(positions!, (vector) => vector.applyMatrix4(toWorld)),
    ...(normals && { normals: each(normals, (v) => v.applyMatrix3(covariant).normalize()) }),
  }
  if (normals && gradientsOfNormals.every((name) => name in others))
    Object.assign(made, turnedGradients(vertices as unknown as Arrays, covariant))
  return made as unknown as Vertices
}

type Arrays = Record<string, Float32Array>

const gradients = variationNames.map((name) => `${name}s`)
const gradientsOfNormals = gradients.filter((name) => name.startsWith('normal'))
const gradientsOfUvs = gradients.filter((name) => !name.startsWith('normal'))

/**
 * The rows of the derivative of the normal. That is C n / |C n| in the world, C being `covariant`: its derivative loses what
 * would change its length, and is by the position in the world, which the transpose of C leads back from.
 */
function turnedGradients(vertices: Arrays, covariant: Matrix3): Arrays {
  const rows = gradientsOfNormals.map((name) => vertices[name]!)
  const turned = rows.map((numbers) => new Float32Array(numbers.length))
  const back = covariant.clone().transpose()
  const varies = new Matrix3()
  const normal = new Vector3()
  const column = new Vector3()
  const along = new Vector3()
  for (let i = 0; i < rows[0]!.length; i += 3) {
    normal.fromArray(vertices.normals!, i).applyMatrix3(covariant)
    const length = normal.length() || 1
    normal.divideScalar(length)
    rows.forEach((numbers, k) =>
      column.fromArray(numbers, i).toArray(varies.elements as unknown as number[], 3 * k),
    )
    varies.premultiply(covariant).multiply(back)
    along.copy(normal).applyMatrix3(varies)
    turned.forEach((numbers, k) =>
      column
        .fromArray(varies.elements, 3 * k)
        .addScaledVector(along, -normal.getComponent(k))
        .divideScalar(length)
        .toArray(numbers, i),
    )
  }
  return Object.fromEntries(gradientsOfNormals.map((name, k) => [name, turned[k]!]))
}

function each(numbers: Float32Array, work: (vector: Vector3) => Vector3) {
  const moved = new Float32Array(numbers.length)
  const vector = new Vector3()
  for (let i = 0; i < numbers.length; i += 3) work(vector.fromArray(numbers, i)).toArray(moved, i)
  return moved
}
