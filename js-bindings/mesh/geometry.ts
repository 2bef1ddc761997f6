// Makes geometries of three.js from meshes. Attributes that we don't know are copied, or interpolated for new vertices.
import {
  arraysOf,
  attributeNumbers,
  geometryAttributes,
  type Attribute,
  type Geometry,
} from '../core/inputs/geometry.js'
import type { Mesh, MeshInput } from './mesh-arrays.js'

/** The members of a new BufferGeometry that we use. */
interface Made extends Geometry {
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
  setFromPoints(points: unknown[]): Made
  copy(other: unknown): Made
}

interface Range {
  start: number
  count: number
}
interface Group extends Range {
  materialIndex?: number
}

type GeometryClass = new () => Made
type AttributeClass = new (array: unknown, size: number, normalized?: boolean) => Attribute

/** The type that three.js' own methods convert a geometry to: BufferGeometry for a BoxGeometry. */
export type Plain<Given> = Given extends { toNonIndexed(): infer Made } ? Made : Given

/** Returns the class in the prototype chain of `value` that defines `method`. */
function classWith(value: object, method: string) {
  let prototype: object | null = value
  while (prototype && !Object.hasOwn(prototype, method))
    prototype = Object.getPrototypeOf(prototype)
  return prototype!.constructor
}

/** Finds classes of three.js through a geometry, since we don't import three.js. */
function classesOf(geometry: object) {
  const method = 'isInstancedBufferGeometry' in geometry ? 'constructor' : 'setFromPoints'
  const Plain = classWith(Object.getPrototypeOf(geometry) as object, method) as GeometryClass
  const { position } = new Plain().setFromPoints([]).attributes
  return { Plain, Numbers: classWith(position!, 'setXYZ') as AttributeClass }
}

/** Converts a loaded mesh to a geometry of the class, with the material and warnings in its `userData`. */
export function geometryAs(Class: new () => unknown, mesh: Mesh): unknown {
  const made = new Class() as Made
  const { Numbers } = classesOf(made)
  put(made, mesh, Numbers)
  if (mesh.indices) made.setIndex(new Numbers(mesh.indices, 1))
  const { material, warnings } = mesh
  Object.assign(made.userData, material && { material }, warnings && { warnings })
  return made
}

function put(made: Made, mesh: Mesh, Numbers: AttributeClass) {
  for (const [name, [attribute, size]] of Object.entries(geometryAttributes)) {
    const numbers = mesh[name as keyof typeof geometryAttributes]
    if (numbers) made.setAttribute(attribute, new Numbers(numbers, size))
  }
}

/**
 * Returns a copy of a geometry with the vertices of `baked`, and also its triangles if `isReversed`. `bake` warps the morph targets.
 */
export function movedGeometry(
  given: Geometry,
  baked: Mesh,
  isReversed: boolean,
  bake: (mesh: MeshInput) => Mesh,
): unknown {
  const { Plain, Numbers } = classesOf(given)
  const made = withoutBounds(new Plain().copy(given))
  const { positions, normals, tangents } = baked
  put(made, { positions, normals, ...(tangents && { tangents }) }, Numbers)
  if (isReversed) made.setIndex(new Numbers(baked.indices, 1))
  moveTargets(made, given as Made, baked, (mesh) => bake({ ...arraysOf(given), ...mesh }), Numbers)
  return made
}

/**
 * Warps each morph target: the mesh with this target at full influence and no other. A target without normals gets some, since
 * the warp transforms normals differently at its positions.
 */
function moveTargets(
  made: Made,
  given: Made,
  baked: Mesh,
  bake: (mesh: Targets) => Mesh,
  Numbers: AttributeClass,
) {
  const { position, normal } = given.morphAttributes
  const count = Math.max(position?.length ?? 0, normal?.length ?? 0)
  if (count === 0) return
  const isRelative = given.morphTargetsRelative
  const rest = arraysOf(given) as unknown as Targets
  const whole = (target: Attribute | undefined, rest: Float32Array) =>
    target ? sum(attributeNumbers(target, 3), isRelative ? rest : undefined) : rest
  const targets = Array.from({ length: count }, (_, i) =>
    bake({
      positions: whole(position?.[i], rest.positions),
      ...(rest.normals && { normals: whole(normal?.[i], rest.normals) }),
    }),
  )
  for (const [name, attribute] of [
    ['positions', 'position'],
    ['normals', 'normal'],
  ] as const)
    made.morphAttributes[attribute] = targets.map((target, i) => {
      const numbers = sum(target[name], isRelative ? baked[name] : undefined, -1)
      const { name: called } =
        ((position?.[i] ?? normal?.[i]) as { name?: string } | undefined) ?? {}
      return Object.assign(new Numbers(numbers, 3), called && { name: called })
    })
}

interface Targets {
  positions: Float32Array
  normals?: Float32Array
}

const sum = (numbers: Float32Array, others: Float32Array | undefined, factor = 1) =>
  others ? numbers.map((number, i) => number + factor * others[i]!) : numbers

/** The origins of new elements, from C++: `ends` has 2 vertices per new vertex, `triangles` the original of each triangle. */
export interface Origins {
  ends: Uint32Array
  triangles: Uint32Array
}

/** Returns a finer geometry, with texture coordinates, colours and all other attributes interpolated like positions. */
export function finerGeometry(given: Geometry, mesh: Mesh, { ends, triangles }: Origins): Geometry {
  const { Plain, Numbers } = classesOf(given)
  const made = withoutBounds(new Plain().copy(given))
  const finer = (attribute: Attribute) => finerAttribute(attribute, ends, Numbers)
  for (const [name, attribute] of Object.entries(made.attributes))
    if (!('isInstancedBufferAttribute' in attribute)) made.setAttribute(name, finer(attribute))
  for (const [name, targets] of Object.entries(made.morphAttributes))
    made.morphAttributes[name] = targets.map(finer)
  mergeBones(made, ends)
  const { positions, normals, tangents } = mesh
  put(made, { positions, normals, ...(tangents && { tangents }) }, Numbers)
  if (mesh.indices) made.setIndex(new Numbers(mesh.indices, 1))
  made.groups = made.groups.map((group) => ({ ...group, ...finerRange(group, triangles) }))
  made.drawRange = finerRange(made.drawRange, triangles)
  if (mesh.warnings) made.userData = { ...made.userData, warnings: mesh.warnings }
  return made
}

function withoutBounds(made: Made) {
  made.boundingBox = made.boundingSphere = null
  return made
}

/** Converts a range of indices; triangles keep their order. */
function finerRange({ start, count }: Range, triangles: Uint32Array): Range {
  const before = (end: number) => triangles.findIndex((origin) => 3 * origin >= end)
  const [first, last] = [before(start), before(start + count)]
  const from = 3 * (first < 0 ? triangles.length : first)
  return {
    start: from,
    count: last < 0 ? (count === Infinity ? count : 3 * triangles.length - from) : 3 * last - from,
  }
}

/** Interpolates an attribute. Integers that are not normalized cannot be interpolated: a new vertex copies its first end. */
function finerAttribute(given: Attribute, ends: Uint32Array, Numbers: AttributeClass): Attribute {
  const { itemSize: size, count, normalized } = given
  const read = readerOf(given)
  const List = given.array.constructor as new (length: number) => Float32Array
  const numbers = new List(size * (count + ends.length / 2))
  const isWhole = !(numbers instanceof Float32Array) && !('isFloat16BufferAttribute' in given)
  for (let i = 0; i < count; i++) for (let k = 0; k < size; k++) numbers[size * i + k] = read(i, k)
  for (let i = count, e = 0; e < ends.length; i++, e += 2)
    for (let k = 0; k < size; k++) {
      const [a, b] = [numbers[size * ends[e]! + k]!, numbers[size * ends[e + 1]! + k]!]
      const middle = (a + b) / 2
      numbers[size * i + k] = !isWhole ? middle : normalized ? Math.round(middle) : a
    }
  const made = new Numbers(numbers, size, normalized)
  const { name, usage, gpuType } = given as never
  return Object.assign(made, name && { name }, usage && { usage }, gpuType && { gpuType })
}

/** Returns a function that reads raw numbers, also if several attributes share an array. */
function readerOf(given: Attribute) {
  const { data, offset } = given as {
    data?: { array: ArrayLike<number>; stride: number }
    offset?: number
  }
  if (data) return (i: number, k: number) => data.array[data.stride * i + offset! + k]!
  return (i: number, k: number) => given.array[given.itemSize * i + k]!
}

/** Moves a vertex between vertices with different bones by all of these bones, up to the four with the largest weights. */
function mergeBones({ attributes }: Made, ends: Uint32Array) {
  const { skinIndex, skinWeight } = attributes as Record<string, Attribute & Settable>
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
    const all = [...weights.values()].reduce((sum, weight) => sum + weight)
    const largest = [...weights].sort(([, a], [, b]) => b - a).slice(0, 4)
    const kept = largest.reduce((sum, [, weight]) => sum + weight, 0)
    while (largest.length < 4) largest.push([0, 0])
    const four = (of: (each: [number, number]) => number) =>
      largest.map(of) as [number, number, number, number]
    skinIndex.setXYZW(first + e / 2, ...four(([bone]) => bone))
    skinWeight.setXYZW(
      first + e / 2,
      ...four(([, weight]) => (kept > 0 ? (weight * all) / kept : 0)),
    )
  }
}

interface Settable {
  setXYZW(i: number, x: number, y: number, z: number, w: number): void
}
