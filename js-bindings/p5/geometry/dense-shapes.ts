/** `warpBox`, since p5's box has corners alone. */
import { WarpError, describe } from '../../errors/errors.js'
import type { Canvas } from '../host.js'
import type { Makers, WarpModel } from './model.js'
import { emptyModel } from './load-model.js'
import type { Triple } from './triple.js'

/** As p5's box has its faces: the first corner, and where the second and third lie from it. */
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

const mostDetail = 200

/** By renderer and detail, since p5 keeps what it draws for each. */
const boxes = new WeakMap<object, Map<number, WarpModel>>()

/** A sketch, where it draws. */
interface Drawing extends Canvas {
  push(): void
  pop(): void
  scale(x: number, y: number, z: number): void
  model(shape: WarpModel): void
}

/** `box(width, height, depth)` of p5, with `detail` squares along each edge. Throws a `WarpError` for other things than numbers. */
export function drawBox(
  p5: Makers,
  canvas: object,
  width = 50,
  height = width,
  depth = height,
  detail = 20,
) {
  for (const [name, value] of Object.entries({ width, height, depth, detail }))
    if (!Number.isFinite(value))
      throw new WarpError(`warpBox: ${name} must be a number, but is ${describe(value)}.`)
  if (!(Number.isInteger(detail) && detail >= 1 && detail <= mostDetail))
    throw new WarpError(
      `warpBox: detail, how many squares lie along each edge, must be a whole number from 1 to ${mostDetail}, but is ${describe(detail)}.`,
    )
  const { _renderer: renderer } = canvas as Drawing
  if (!renderer?.isP3D)
    throw new WarpError(
      'warpBox: a 3D canvas is needed, made by createCanvas(width, height, WEBGL).',
    )
  const known = boxes.get(renderer) ?? new Map<number, WarpModel>()
  boxes.set(renderer, known)
  const shape = known.get(detail) ?? makeBox(p5, renderer, detail)
  known.set(detail, shape)
  const drawing = canvas as Drawing
  drawing.push()
  drawing.scale(width, height, depth)
  drawing.model(shape)
  drawing.pop()
}

/** Of size 1, as p5's own. */
function makeBox(p5: Makers, renderer: object, detail: number): WarpModel {
  const box = emptyModel(p5, renderer)
  const steps = Array.from({ length: detail + 1 }, (_, i) => i / detail)
  faces.forEach(([corner, right, down], face) => {
    const first = box.vertices.length
    const at = (i: number, j: number) => first + j * (detail + 1) + i
    const normal = [1, 2, 0].map((i, k) => {
      const j = [2, 0, 1][k]!
      return right[i]! * down[j]! - right[j]! * down[i]!
    }) as unknown as Triple
    steps.forEach((v, j) =>
      steps.forEach((u, i) => {
        const place = corner.map((c, k) => c + u * right[k]! + v * down[k]!)
        box.vertices.push(new p5.Vector(...(place as unknown as Triple)))
        box.vertexNormals.push(new p5.Vector(...normal))
        box.uvs.push(u, v)
        if (i === detail || j === detail) return
        box.faces.push([at(i, j), at(i + 1, j), at(i, j + 1)])
        box.faces.push([at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)])
      }),
    )
    // Lines along the twelve edges of the box, each once: all of two faces, and between these two.
    for (let i = 0; i < detail; i++)
      for (const end of [0, detail]) {
        if (face === 0 || face > 3) box.edges.push([at(i, end), at(i + 1, end)])
        if (face === 1 || face > 3) box.edges.push([at(end, i), at(end, i + 1)])
      }
  })
  return box
}
