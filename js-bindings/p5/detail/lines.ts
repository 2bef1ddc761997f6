/** The lines of a divided shape: p5's own arrays of lines, with a segment for each piece of an edge. */
import type { Renderer } from '../host.js'
import { buffersOf, valuesOf, type DrawnShape, type FillBuffer } from './shape.js'

/** p5 makes each segment of a line of six vertices, and also each cap; a join has twelve. */
const group = 6
/** The sides of the vertices of a segment, by which it differs from caps and joins. */
const segmentSides = [1, 1, -1, 1, -1, -1]
const isAtEnd = [false, true, false, true, true, false]

interface Column {
  readonly buffer: FillBuffer
  readonly values: Float32Array
}

/** The lines of a shape as p5 has them. */
export interface LineBase {
  readonly columns: readonly Column[]
  /** The edge of each group; -1 for caps and joins, which stay where they are. */
  readonly edges: readonly number[]
  /** Two vertices of the shape for each edge that has a segment. */
  readonly ends: readonly number[]
}

/** Reads the lines of a shape; `undefined` if they do not follow its edges. */
export function linesOf(renderer: Renderer, shape: DrawnShape): LineBase | undefined {
  const buffers = buffersOf(renderer, 'stroke')
  const positions = shape.lineVertices as Lines | undefined
  const sides = shape.lineSides as Lines | undefined
  if (!positions?.length || !sides) return undefined
  const places = numbersOf(positions)
  const groups = numbersOf(sides)
  const edges: number[] = []
  const ends: number[] = []
  // There are segments for some of the edges, in their order.
  let next = 0
  for (let at = 0; at < groups.length; at += group) {
    if (segmentSides.some((side, i) => groups[at + i] !== side)) {
      edges.push(-1)
      continue
    }
    const from = places.subarray(3 * at, 3 * at + 3)
    const to = places.subarray(3 * at + 3, 3 * at + 6)
    const given = shape.edges as readonly (readonly [number, number])[]
    while (next < given.length && !areAt(shape, given[next]!, from, to)) next++
    if (next === given.length) return undefined
    edges.push(ends.length / 2)
    ends.push(...given[next++]!)
  }
  const count = positions.length / 3
  const columns = buffers.flatMap((buffer) => {
    const values = valuesOf(buffer, shape, { lineVertices: new Array<number>(count).fill(0) })
    return values.length >= buffer.size * count ? [{ buffer, values: numbersOf(values) }] : []
  })
  return { columns, edges, ends }
}

/** An array of p5, such as its DataArray. */
type Lines = ArrayLike<number> & { dataArray?(): Float32Array }

const numbersOf = (values: Lines) => values.dataArray?.() ?? Float32Array.from(values)

/** Tests whether the edge has these ends. */
function areAt(
  { vertices }: DrawnShape,
  edge: readonly [number, number],
  ...places: [Float32Array, Float32Array]
): boolean {
  return places.every((place, i) => {
    const { x, y, z } = vertices[edge[i]!]!
    return [x, y, z].every((value, k) => Math.fround(value) === place[k])
  })
}

/**
 * Returns the divided values of each column. `lines` has, for each edge, the number of divided vertices along it, then these vertices.
 * `positions` are those of all divided vertices.
 */
export function divideLines(
  { columns, edges, ends }: LineBase,
  lines: ArrayLike<number>,
  positions: Float32Array,
): Float32Array[] {
  const starts: number[] = []
  for (let at = 0; starts.length < ends.length / 2; at += lines[at]! + 1) starts.push(at)
  const piecesOf = (edge: number) => (edge < 0 ? 1 : lines[starts[edge]!]! - 1)
  const groups = edges.reduce((sum, edge) => sum + piecesOf(edge), 0)
  return columns.map(({ buffer: { src, size }, values }) => {
    const divided = new Float32Array(groups * group * size)
    let at = 0
    edges.forEach((edge, i) => {
      const own = values.subarray(group * size * i, group * size * (i + 1))
      const pieces = piecesOf(edge)
      for (let piece = 0; piece < pieces; piece++, at += group * size) {
        divided.set(own, at)
        if (edge < 0 || (src !== 'lineVertices' && src !== 'lineVertexColors')) continue
        for (let vertex = 0; vertex < group; vertex++) {
          const place = piece + Number(isAtEnd[vertex])
          const to = divided.subarray(at + size * vertex, at + size * (vertex + 1))
          const number = 3 * lines[starts[edge]! + 1 + place]!
          if (src === 'lineVertices') to.set(positions.subarray(number, number + 3))
          else mix(to, own, own.subarray(size), shareOf(positions, lines, starts[edge]!, place))
        }
      }
    })
    return divided
  })
}

function mix(to: Float32Array, from: Float32Array, end: Float32Array, share: number) {
  for (let k = 0; k < to.length; k++) to[k] = from[k]! + share * (end[k]! - from[k]!)
}

/** Returns the distance of a vertex from the start of its line, as a share of the line's length. */
function shareOf(
  positions: Float32Array,
  lines: ArrayLike<number>,
  start: number,
  place: number,
): number {
  const last = lines[start]! - 1
  const distanceTo = (i: number) => {
    const [a, b] = [3 * lines[start + 1]!, 3 * lines[start + 1 + i]!]
    return Math.hypot(...[0, 1, 2].map((k) => positions[b + k]! - positions[a + k]!))
  }
  return distanceTo(place) / (distanceTo(last) || 1)
}
