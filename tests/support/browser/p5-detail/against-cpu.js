// Compares pictures and meshes that compute passes divide with those that the CPU divides, and with dense shapes.
import { beyondEdges, differingPixels } from '../pixels.js'
import { countOpenSides } from '../three/detail/sides.js'
import { buffers, errors, startSketch, wait } from './sketches.js'
import { around, sketch, turn } from './warped-shapes.js'

const countTriangles = async ({ read }, { draws }) =>
  Promise.all(draws.map(async (draw) => (await read(draw)).indices.length / 3))

/** Counts the coordinates of two meshes with the same indices that differ. */
const countDiffering = (a, b) => a.filter((x, i) => Math.abs(x - b[i]) > 1e-6).length

/** Counts the vertices of mesh a without a vertex of mesh b at the same place. Both are lists of coordinates. */
function countStrays(a, b) {
  const keysOf = (places) =>
    Array.from({ length: places.length / 3 }, (_, i) => places.subarray(3 * i, 3 * i + 3).join())
  const keysOfB = new Set(keysOf(b))
  return keysOf(a).filter((key) => !keysOfB.has(key)).length
}

const sum = (numbers) => numbers.reduce((a, b) => a + b, 0)

/** Draws pictures with passes and by the CPU. Returns what differs in each draw of each picture. */
export async function divide({ frames = 6, hasPlaces, ...given }) {
  const options = { ...given, ...(hasPlaces && { places: around }) }
  const byPasses = await startSketch(sketch(options))
  const byCpu = await startSketch(sketch({ ...options, hasPasses: false }))
  await byPasses.begin()
  await byCpu.picture()
  const found = []
  for (let i = 0; i < frames; i++) {
    // The buffers may be too small at first.
    for (let k = 0; k < 3; k++) {
      await byPasses.picture(i)
      await wait(30)
    }
    const picture = await byPasses.picture(i)
    const expected = await byCpu.picture(i)
    if (picture.draws.length !== expected.draws.length)
      throw new Error(`${picture.draws.length} draws, ${expected.draws.length} by the CPU`)
    for (const [k, draw] of picture.draws.entries()) {
      const [ours, right] = [await byPasses.read(draw), await byCpu.read(expected.draws[k])]
      const isEqual = `${ours.indices}` === `${right.indices}`
      found.push({
        isIndirect: !!draw.indirectBuffer && !expected.draws[k].indirectBuffer,
        triangles: ours.indices.length / 3,
        expected: right.indices.length / 3,
        vertices: right.places.length / 3,
        strays: isEqual
          ? countDiffering(ours.places, right.places)
          : countStrays(ours.places, right.places),
        isEqual,
        openSides: countOpenSides(ours.indices, ours.places),
      })
    }
    found.at(-1).beyond = beyondEdges(picture.image, expected.image, 24)
  }
  byPasses.remove()
  byCpu.remove()
  return { found, errors: errors.splice(0) }
}

/** Counts the pixels at which a coarse shape differs from a dense one: without detail (`before`), and divided by passes (`after`). */
export async function resemble({ name, coarse, dense }) {
  const [coarseShape, denseShape] = [coarse, dense].map(
    ([call, ...numbers]) =>
      (p) =>
        p[call](...numbers),
  )
  const atRest = { places: [(p) => turn(p, 0)] }
  const byPasses = await startSketch(sketch({ ...atRest, name, shape: coarseShape }))
  await byPasses.begin()
  const { image } = await byPasses.picture()
  const pictureOf = async (shape) => {
    const started = await startSketch(sketch({ ...atRest, name, shape, detail: false }))
    const { image } = await started.picture()
    started.remove()
    return image
  }
  const [without, expected] = [await pictureOf(coarseShape), await pictureOf(denseShape)]
  byPasses.remove()
  return {
    before: differingPixels(without, expected, 24),
    after: differingPixels(image, expected, 24),
    errors: errors.splice(0),
  }
}

/** Moves the camera close to a shape that was small, so that its buffers have to grow. */
export async function approach() {
  const places = [(p, i) => p.scale(i ? 1.4 : 0.1)]
  const byPasses = await startSketch(sketch({ shape: 'ball', name: 'noise', places }))
  const byCpu = await startSketch(
    sketch({ shape: 'ball', name: 'noise', places, hasPasses: false }),
  )
  await byPasses.begin()
  const far = await byPasses.picture(0)
  const before = sum(await countTriangles(byPasses, far))
  const bufferCount = buffers.size
  const beyond = []
  let near
  const expected = await byCpu.picture(1)
  const addedByCpu = buffers.size - bufferCount
  for (let k = 0; k < 6; k++) {
    near = await byPasses.picture(1)
    beyond.push(beyondEdges(near.image, expected.image, 24))
    await wait(10)
  }
  const result = {
    ...{ before, beyond },
    after: sum(await countTriangles(byPasses, near)),
    isSame: near.draws[0].index === far.draws[0].index,
    left: buffers.size - bufferCount - addedByCpu,
    errors: errors.splice(0),
  }
  byPasses.remove()
  byCpu.remove()
  return result
}

/** Makes waves shorter or moves a bump, so that the shape has to be cut anew. */
export async function refine({ name }) {
  const places = [(p) => p.rotateX(-0.4)]
  const byPasses = await startSketch(sketch({ shape: 'box', name, places }))
  const byCpu = await startSketch(sketch({ shape: 'box', name, places, hasPasses: false }))
  await byPasses.begin()
  await byCpu.picture(0)
  const first = await byPasses.picture(1)
  const expected = await byCpu.picture(1)
  await byPasses.begin(1)
  const later = await byPasses.picture(1)
  const result = {
    triangles: sum(await countTriangles(byPasses, later)),
    beyond: [first, later].map(({ image }) => beyondEdges(image, expected.image, 24)),
    errors: errors.splice(0),
  }
  byPasses.remove()
  byCpu.remove()
  return result
}

/**
 * Draws three pictures of a growing shape, by one call of `redraw` and by three. Returns in how many pixels the last pictures differ, in
 * each of four rounds.
 */
export async function redrawOften({ hasPasses }) {
  const places = [(p, i) => p.scale([0.1, 0.7, 1.4][i])]
  const start = () => startSketch(sketch({ shape: 'ball', name: 'noise', places, hasPasses }))
  const [byOneCall, byThree] = [await start(), await start()]
  if (hasPasses) {
    // Passes take over within a call.
    await byOneCall.begin(0, 1, 2)
    await byThree.begin()
  }
  const differing = []
  for (let i = 0; i < 4; i++) {
    const { image } = await byOneCall.picture(0, 1, 2)
    for (const k of [0, 1]) await byThree.picture(k)
    const expected = await byThree.picture(2)
    differing.push(differingPixels(image, expected.image, 0))
    await wait(10)
  }
  byOneCall.remove()
  byThree.remove()
  return { differing, errors: errors.splice(0) }
}
