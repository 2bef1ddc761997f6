/** `warpBox`: p5's own box has no vertices besides its corners. */
import { WarpError, describe } from '../../errors/errors.js'
import type { Canvas } from '../host.js'
import { emptyModel } from './load-model.js'
import type { P5Constructors, WarpModel } from './model.js'
import type { Triple } from './triple.js'

/** The faces, in the order of p5's box: each one's first corner, and the edges from there to its second and third corner. */
const faces: readonly (readonly [Triple, Triple, Triple])[] = [
  [
    [-0.5, -0.5, -0.5],
    [0, 0, 1],
    [0, 1, 0],
  ],
  [
    [0.5, -0.5, -0.5],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [-0.5, -0.5, -0.5],
    [1, 0, 0],
    [0, 0, 1],
  ],
  [
    [-0.5, 0.5, -0.5],
    [0, 0, 1],
    [1, 0, 0],
  ],
  [
    [-0.5, -0.5, -0.5],
    [0, 1, 0],
    [1, 0, 0],
  ],
  [
    [-0.5, -0.5, 0.5],
    [1, 0, 0],
    [0, 1, 0],
  ],
]

const maxDetail = 200

/** Boxes by renderer and detail: p5 keeps the buffers of a shape per renderer. */
const boxes = new WeakMap<object, Map<number, WarpModel>>()

/** The drawing functions of a sketch. */
interface Drawing extends Canvas {
  push(): void
  pop(): void
  scale(x: number, y: number, z: number): void
  model(shape: WarpModel): void
}

/** Draws p5's `box(width, height, depth)`, with `detail` squares along each edge. Throws a `WarpError` if an argument is not a number. */
export function drawBox(
  p5: P5Constructors,
  canvas: object,
  width = 50,
  height = width,
  depth = height,
  detail = 20,
) {
  for (const [name, value] of Object.entries({ width, height, depth, detail }))
    if (!Number.isFinite(value))
      throw new WarpError(`warpBox: ${name}: expected a number, got ${describe(value)}.`)
  if (!(Number.isInteger(detail) && detail >= 1 && detail <= maxDetail))
    throw new WarpError(
      `warpBox: detail, the number of squares along each edge: expected a whole number from 1 to ${maxDetail}, got ${describe(detail)}.`,
    )
  const { _renderer: renderer } = canvas as Drawing
  if (!renderer?.isP3D)
    throw new WarpError(
      'warpBox: needs a 3D canvas; call createCanvas(width, height, WEBGL) first.',
    )
  const boxesByDetail = boxes.get(renderer) ?? new Map<number, WarpModel>()
  boxes.set(renderer, boxesByDetail)
  const shape = boxesByDetail.get(detail) ?? makeBox(p5, renderer, detail)
  boxesByDetail.set(detail, shape)
  const drawing = canvas as Drawing
  drawing.push()
  drawing.scale(width, height, depth)
  drawing.model(shape)
  drawing.pop()
}

/** Makes a box of size 1, like p5's own. */
function makeBox(p5: P5Constructors, renderer: object, detail: number): WarpModel {
  const box = emptyModel(p5, renderer)
  const steps = Array.from({ length: detail + 1 }, (_, i) => i / detail)
  faces.forEach(([corner, right, down], face) => {
    const first = box.vertices.length
    const vertexAt = (i: number, j: number) => first + j * (detail + 1) + i
    const normal = [1, 2, 0].map((i, k) => {
      const j = [2, 0, 1][k]!
      return right[i]! * down[j]! - right[j]! * down[i]!
    }) as unknown as Triple
    steps.forEach((v, j) =>
      steps.forEach((u, i) => {
        const position = corner.map((c, k) => c + u * right[k]! + v * down[k]!)
        box.vertices.push(new p5.Vector(...(position as unknown as Triple)))
        box.vertexNormals.push(new p5.Vector(...normal))
        box.uvs.push(u, v)
        if (i === detail || j === detail) return
        box.faces.push([vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i, j + 1)])
        box.faces.push([vertexAt(i, j + 1), vertexAt(i + 1, j), vertexAt(i + 1, j + 1)])
      }),
    )
    // Lines along the twelve edges of the box, each once: all edges of two opposite faces, and the four that connect them.
    for (let i = 0; i < detail; i++)
      for (const end of [0, detail]) {
        if (face === 0 || face > 3) box.edges.push([vertexAt(i, end), vertexAt(i + 1, end)])
        if (face === 1 || face > 3) box.edges.push([vertexAt(end, i), vertexAt(end, i + 1)])
      }
  })
  return box
}
