// Makes geometries of three.js from meshes and other geometries. Attributes that this library doesn't know are copied, and interpolated for
// new vertices.
import {
  arraysOf,
  attributeNumbers,
  geometryAttributes,
  type Attribute,
  type Geometry,
} from '../core/inputs/geometry.js'
import type { Mesh, MeshInput } from './mesh-arrays.js'

/** The members of a BufferGeometry that this file uses. */
interface BufferGeometry extends Geometry {
  attributes: Record<string, Attribute>
  morphAttributes: Record<string, Attribute[]>
  morphTargetsRelative: boolean
  groups: Group[]
  drawRange: Range
  boundingBox: unknown
  boundingSphere: unknown
  userData: Record<string, unknown>
  setIndex(index: unknown): void
  setAttribute(name: string, attribute: unknown): void
  setFromPoints(points: unknown[]): BufferGeometry
  copy(other: unknown): BufferGeometry
}

interface Range {
  start: number
  count: number
}
interface Group extends Range {
  materialIndex?: number
}

type GeometryClass = new () => BufferGeometry
type AttributeClass = new (array: unknown, size: number, normalized?: boolean) => Attribute

/** The type of a geometry that is derived from one of type `Original` by methods of three.js: BufferGeometry for a BoxGeometry. */
export type Plain<Original> = Original extends { toNonIndexed(): infer Derived }
  ? Derived
  : Original

/** Returns the first class in the prototype chain of `value` that defines `method`. */
function classWith(value: object, method: string) {
  let prototype: object | null = value
  while (prototype && !Object.hasOwn(prototype, method))
    prototype = Object.getPrototypeOf(prototype)
  return prototype!.constructor
}

/**
 * Finds classes of three.js through a geometry, since this library doesn't import three.js: `Plain`, the class of a copy, and
 * `Numbers`, BufferAttribute.
 */
function classesOf(geometry: object) {
  const method = 'isInstancedBufferGeometry' in geometry ? 'constructor' : 'setFromPoints'
  const Plain = classWith(Object.getPrototypeOf(geometry) as object, method) as GeometryClass
  const { position } = new Plain().setFromPoints([]).attributes
  return { Plain, Numbers: classWith(position!, 'setXYZ') as AttributeClass }
}

/** Converts a loaded mesh to a geometry of the class, with the material and warnings in its `userData`. */
export function geometryAs(Class: new () => unknown, mesh: Mesh): unknown {
  const geometry = new Class() as BufferGeometry
  const { Numbers } = classesOf(geometry)
  setAttributes(geometry, mesh, Numbers)
  if (mesh.indices) geometry.setIndex(new Numbers(mesh.indices, 1))
  const { material, warnings } = mesh
  Object.assign(geometry.userData, material && { material }, warnings && { warnings })
  return geometry
}

function setAttributes(geometry: BufferGeometry, mesh: Mesh, Numbers: AttributeClass) {
  for (const [name, [attribute, size]] of Object.entries(geometryAttributes)) {
    const numbers = mesh[name as keyof typeof geometryAttributes]
    if (numbers) geometry.setAttribute(attribute, new Numbers(numbers, size))
  }
}

/**
 * Returns a copy of a geometry with the vertices of `baked`, and if `isReversed` also with the triangles of `baked`. `bake` warps the morph
 * targets.
 */
export function movedGeometry(
  original: Geometry,
  baked: Mesh,
  isReversed: boolean,
  bake: (mesh: MeshInput) => Mesh,
): unknown {
  const { Plain, Numbers } = classesOf(original)
  const moved = withoutBounds(new Plain().copy(original))
  const { positions, normals, tangents } = baked
  setAttributes(moved, { positions, normals, ...(tangents && { tangents }) }, Numbers)
  if (isReversed) moved.setIndex(new Numbers(baked.indices, 1))
  moveTargets(
    moved,
    original as BufferGeometry,
    baked,
    (target) => bake({ ...arraysOf(original), ...target }),
    Numbers,
  )
  return moved
}

/**
 * Warps each morph target: the mesh with this target at full influence and no other. A target without normals gets some, since
 * the warp transforms normals differently at the target's positions.
 */
function moveTargets(
  moved: BufferGeometry,
  original: BufferGeometry,
  baked: Mesh,
  bake: (target: TargetMesh) => Mesh,
  Numbers: AttributeClass,
) {
  const { position, normal } = original.morphAttributes
  const count = Math.max(position?.length ?? 0, normal?.length ?? 0)
  if (count === 0) return
  const isRelative = original.morphTargetsRelative
  const rest = arraysOf(original) as unknown as TargetMesh
  const absoluteVectors = (target: Attribute | undefined, rest: Float32Array) =>
    target ? sum(attributeNumbers(target, 3), isRelative ? rest : undefined) : rest
  const targets = Array.from({ length: count }, (_, i) =>
    bake({
      positions: absoluteVectors(position?.[i], rest.positions),
      ...(rest.normals && { normals: absoluteVectors(normal?.[i], rest.normals) }),
    }),
  )
  for (const [name, attribute] of [
    ['positions', 'position'],
    ['normals', 'normal'],
  ] as const)
    moved.morphAttributes[attribute] = targets.map((target, i) => {
      const numbers = sum(target[name], isRelative ? baked[name] : undefined, -1)
      const { name: targetName } =
        ((position?.[i] ?? normal?.[i]) as { name?: string } | undefined) ?? {}
      return Object.assign(new Numbers(numbers, 3), targetName && { name: targetName })
    })
}

/** The vectors of a mesh with a morph target at full influence. */
interface TargetMesh {
  positions: Float32Array
  normals?: Float32Array
}

/** Returns numbers + factor * others, or without `others` the numbers themselves. */
const sum = (numbers: Float32Array, others: Float32Array | undefined, factor = 1) =>
  others ? numbers.map((number, i) => number + factor * others[i]!) : numbers

/**
 * The origins of new vertices and triangles, from C++: `ends` has the 2 ends of the edge that each new vertex divides, `triangles` the
 * original triangle of each triangle.
 */
export interface Origins {
  ends: Uint32Array
  triangles: Uint32Array
}

/** Returns the geometry with the finer mesh, and all attributes that the mesh lacks interpolated like positions. */
export function finerGeometry(
  original: Geometry,
  mesh: Mesh,
  { ends, triangles }: Origins,
): Geometry {
  const { Plain, Numbers } = classesOf(original)
  const finer = withoutBounds(new Plain().copy(original))
  const interpolate = (attribute: Attribute) => finerAttribute(attribute, ends, Numbers)
  for (const [name, attribute] of Object.entries(finer.attributes))
    if (!('isInstancedBufferAttribute' in attribute))
      finer.setAttribute(name, interpolate(attribute))
  for (const [name, targets] of Object.entries(finer.morphAttributes))
    finer.morphAttributes[name] = targets.map(interpolate)
  mergeBones(finer, ends)
  const { positions, normals, tangents } = mesh
  setAttributes(finer, { positions, normals, ...(tangents && { tangents }) }, Numbers)
  if (mesh.indices) finer.setIndex(new Numbers(mesh.indices, 1))
  finer.groups = finer.groups.map((group) => ({ ...group, ...finerRange(group, triangles) }))
  finer.drawRange = finerRange(finer.drawRange, triangles)
  if (mesh.warnings) finer.userData = { ...finer.userData, warnings: mesh.warnings }
  return finer
}

/** Removes bounds that were computed for other vertices; three.js computes them anew. */
function withoutBounds(geometry: BufferGeometry) {
  geometry.boundingBox = geometry.boundingSphere = null
  return geometry
}

/**
 * Converts a range of the original's indices to that of the triangles made from it. The new triangles are in the order of the original
 * ones.
 */
function finerRange({ start, count }: Range, triangles: Uint32Array): Range {
  const firstTriangleFrom = (index: number) => triangles.findIndex((origin) => 3 * origin >= index)
  const [first, end] = [firstTriangleFrom(start), firstTriangleFrom(start + count)]
  const finerStart = 3 * (first < 0 ? triangles.length : first)
  const finerEnd = 3 * (end < 0 ? triangles.length : end)
  return {
    start: finerStart,
    count: end < 0 && count === Infinity ? count : finerEnd - finerStart,
  }
}

/** Interpolates an attribute. Integers that are not normalized cannot be interpolated: a new vertex has those of its first end. */
function finerAttribute(
  attribute: Attribute,
  ends: Uint32Array,
  Numbers: AttributeClass,
): Attribute {
  const { itemSize: size, count, normalized } = attribute
  const read = readerOf(attribute)
  const TypedArray = attribute.array.constructor as new (length: number) => Float32Array
  const numbers = new TypedArray(size * (count + ends.length / 2))
  const hasIntegers =
    !(numbers instanceof Float32Array) && !('isFloat16BufferAttribute' in attribute)
  for (let i = 0; i < count; i++) for (let k = 0; k < size; k++) numbers[size * i + k] = read(i, k)
  for (let i = count, e = 0; e < ends.length; i++, e += 2)
    for (let k = 0; k < size; k++) {
      const [a, b] = [numbers[size * ends[e]! + k]!, numbers[size * ends[e + 1]! + k]!]
      const middle = (a + b) / 2
      numbers[size * i + k] = !hasIntegers ? middle : normalized ? Math.round(middle) : a
    }
  const finer = new Numbers(numbers, size, normalized)
  const { name, usage, gpuType } = attribute as never
  return Object.assign(finer, name && { name }, usage && { usage }, gpuType && { gpuType })
}

/** Returns a function that reads component `k` of vertex `i` as it is stored, also from an array that attributes share. */
function readerOf(attribute: Attribute) {
  const { data, offset } = attribute as {
    data?: { array: ArrayLike<number>; stride: number }
    offset?: number
  }
  if (data) return (i: number, k: number) => data.array[data.stride * i + offset! + k]!
  return (i: number, k: number) => attribute.array[attribute.itemSize * i + k]!
}

/**
 * Gives each new vertex the bones of both ends of its edge, each with the mean of its weights there: the four with the largest means, if
 * there are more.
 */
function mergeBones({ attributes }: BufferGeometry, ends: Uint32Array) {
  const { skinIndex, skinWeight } = attributes as Record<string, Attribute & WithSetter>
  if (!skinIndex || !skinWeight) return
  const parts = ['getX', 'getY', 'getZ', 'getW'] as const
  const first = skinIndex.count - ends.length / 2
  for (let e = 0; e < ends.length; e += 2) {
    const weights = new Map<number, number>()
    for (const end of [ends[e]!, ends[e + 1]!])
      for (const part of parts) {
        const bone = skinIndex[part](end)
        weights.set(bone, (weights.get(bone) ?? 0) + skinWeight[part](end) / 2)
      }
    const sumOfAll = [...weights.values()].reduce((sum, weight) => sum + weight)
    const largest = [...weights].sort(([, a], [, b]) => b - a).slice(0, 4)
    const sumOfLargest = largest.reduce((sum, [, weight]) => sum + weight, 0)
    while (largest.length < 4) largest.push([0, 0])
    const mapFour = (convert: (boneAndWeight: [number, number]) => number) =>
      largest.map(convert) as [number, number, number, number]
    skinIndex.setXYZW(first + e / 2, ...mapFour(([bone]) => bone))
    skinWeight.setXYZW(
      first + e / 2,
      ...mapFour(([, weight]) => (sumOfLargest > 0 ? (weight * sumOfAll) / sumOfLargest : 0)),
    )
  }
}

interface WithSetter {
  setXYZW(i: number, x: number, y: number, z: number, w: number): void
}
