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
  'beyondFlat',
  'error',
  'aim',
  'hysteresis',
  'minLength',
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

/**
 * Declares the struct `State`; passes may set its `flag` at the same time if that is atomic. `bentSides` are those of `Needs` in
 * src/detail/needs.hpp. They share this buffer because a pass can bind only eight storage buffers.
 */
export const stateOf = (flag: 'u32' | 'atomic<u32>') => `struct State {
  isStale: ${flag},
  isWritten: u32,
  vertices: u32,
  triangles: u32,
  bentSides: array<f32>,
}`

/** Declares functions that read the chosen levels, from the bindings `pieces` and `topology`. */
export const levelOf = `fn levelOf(side: u32) -> u32 {
  return pieces[topology[6 * parameters.triangles + 3 * side + 2]];
}

/** Returns the index of a triangle's tessellation in the table. */
fn tessellationOf(triangle: u32) -> u32 {
  let at = 6 * triangle + 3;
  let first = levelOf(topology[at] >> 1);
  return (first * levels + levelOf(topology[at + 1] >> 1)) * levels + levelOf(topology[at + 2] >> 1);
}`
