// WGSL that several passes have in common.
import type { DetailModule } from '../../wasm/detail.js'

/** The members of the struct `Parameters`, each with 4 bytes. */
export const parameterNames = [
  'vertices',
  'triangles',
  'sides',
  'edges',
  'samples',
  'views',
  'instances',
  'maxVertices',
  'maxTriangles',
] as const

export type Counts = Record<(typeof parameterNames)[number], number>

/** The size of `Parameters`: these members and the tolerance, rounded up to 16 bytes. */
export const parametersBytes = 16 * Math.ceil((parameterNames.length + 1) / 4)

export const parameters = `struct Parameters {
  ${parameterNames.map((name) => `${name}: u32,`).join('\n  ')}
  tolerance: f32,
}
@group(0) @binding(0) var<uniform> parameters: Parameters;`

/** The names of the members of `Criterion` in src/detail/criterion.hpp, in the order of the binding `criterionNumbers`. */
const criterionNames = [
  'margin',
  'nearest',
  'aside',
  'away',
  'beyondCells',
  'beyondFlat',
  'error',
  'aim',
  'hysteresis',
  'lowest',
  'minGain',
]

/** Declares the constants by which src/detail chooses numbers of pieces. */
export function constantsOf(bound: DetailModule): string {
  const numbers = bound.criterionNumbers()
  const counts = [...bound.pieceNumbers()]
  return [
    ...criterionNames.map((name, i) => `const ${name} = f32(${numbers[i]!});`),
    `const levels = ${counts.length}u;`,
    `const pieceCounts = array<u32, levels>(${counts.map((count) => `${count}u`).join(', ')});`,
  ].join('\n')
}

/** The invocations of a workgroup in the passes that do not sum up. */
export const groupSize = 64

/** The invocations of a workgroup in the passes that sum up. */
export const blockSize = 256

/** The invocations that write one side or one triangle. */
export const lanes = 8

/** The members of the struct `State`, each with 4 bytes. They are followed by three numbers for each triangle of the base. */
export const stateNames = ['isStale', 'isWritten', 'vertices', 'triangles'] as const

/** `squaredSides` are those of `Needs` in src/detail/need.hpp. They are here since passes can have eight storage buffers. */
export const state = `struct State {
  isStale: ATOMIC,
  isWritten: u32,
  vertices: u32,
  triangles: u32,
  squaredSides: array<f32>,
}`

export const plainState = state.replace('ATOMIC', 'u32')

/** Finds the sum of the counts before an item. Items are the sides of the base, followed by its triangles. */
export const startOf = `fn startOf(item: u32) -> vec2u {
  return sums[item] + sums[parameters.sides + parameters.triangles + item / ${blockSize}u];
}`
