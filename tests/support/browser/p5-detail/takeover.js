// Shapes that compute passes divide or leave to the CPU, and the buffers that they hold.
import { differingPixels } from '../pixels.js'
import { buffers, errors, startSketch, wait } from './sketches.js'
import { around, boxOf, sketch } from './warped-shapes.js'

/** Maps a name → how a sketch differs from one that draws a box. */
const kinds = {
  box: {},
  strokes: {
    look(p, i) {
      if (i) p.stroke(0, 0, 200)
    },
  },
  instances: { shape: (p, i) => p.model(boxOf(p), i + 1) },
  curved: { shape: 'ball', detail: { tolerance: 1, curved: true } },
  'an edge of no face': {
    setup: (p) => boxOf(p).edges.push([0, 7]),
    shape: (p) => p.model(boxOf(p)),
  },
  'a shape that changes': {
    shape(p) {
      const shape = boxOf(p)
      shape.vertices[0].x = -0.6 - Math.random() / 10
      shape.dirtyFlags.vertices = true
      p.model(shape)
    },
  },
}

const areIndirect = ({ draws }) => draws.map(({ indirectBuffer }) => !!indirectBuffer)

/**
 * Draws picture 0 until passes have begun, then pictures 0, 1 and 0. Returns which shapes of the last three pictures were drawn by passes.
 */
export async function leave({ kind }) {
  const started = await startSketch(sketch({ shape: 'box', name: 'twist', ...kinds[kind] }))
  await started.begin()
  const pictures = []
  for (const i of [0, 1, 0]) pictures.push(await started.picture(i))
  started.remove()
  return {
    areIndirect: pictures.map(areIndirect),
    differing: differingPixels(pictures[0].image, pictures[2].image, 0),
    errors: errors.splice(0),
  }
}

/**
 * Draws pictures for longer than passes need to take over a box on another canvas. Returns whether they take over the shapes of this kind.
 */
export async function begin({ kind }) {
  const box = await startSketch(sketch({ shape: 'box', name: 'twist' }))
  const started = await startSketch(sketch({ shape: 'box', name: 'twist', ...kinds[kind] }))
  let found
  for (let later = 0; later < 40 && !found?.every(Boolean);) {
    if (areIndirect(await box.picture()).every(Boolean)) later++
    found = areIndirect(await started.picture())
    await wait(10)
  }
  started.remove()
  box.remove()
  return { found, errors: errors.splice(0) }
}

/** Frees a shape, and changes it. Returns how many buffers there are after each step, and how the pictures differ. */
export async function life() {
  let shape
  const before = buffers.size
  const started = await startSketch(
    sketch({ name: 'twist', places: around, shape: (p) => p.model((shape = boxOf(p))) }),
  )
  const held = async () => {
    await wait(20)
    return buffers.size - before
  }
  await started.begin()
  const counts = { held: await held() }
  // Frees the shape within a frame, after it was drawn.
  const { draw } = started.p
  started.p.draw = () => {
    draw()
    started.p.freeGeometry(shape)
  }
  const { image } = await started.picture()
  counts.freed = await held()
  started.p.draw = draw
  counts.differing = differingPixels(image, (await started.picture()).image, 24)
  await started.begin()
  counts.again = await held()
  shape.vertices.forEach((vertex) => vertex.mult(0.9))
  shape.dirtyFlags.vertices = true
  const changed = await started.picture()
  counts.areIndirect = areIndirect(changed)
  await started.begin()
  counts.changed = await held()
  started.remove()
  return { counts, errors: errors.splice(0) }
}
