// Measures compute passes in p5: sketches that use them, beside sketches that leave all to the CPU.
import { beyondEdges, differingPixels } from '../pixels.js'
import { countOpenSides } from '../three/detail/sides.js'
import { buffers, errors, size, startSketch, wait } from './sketches.js'

const offsets = {
  twist({ glsl, position }) {
    const angle = position.y().mult(1.8)
    const [c, s] = [angle.cos(), angle.sin()]
    const [x, y, z] = [position.x(), position.y(), position.z()]
    return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c))).sub(position)
  },
  flag: ({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(9).sin().mult(uv.x()).mult(30)),
  // It bends more on one side, or a uniform division would do, which only the CPU chooses.
  bend: ({ glsl, position }) => glsl.vec3(0, position.x().mult(0.03).exp().mult(10), 0),
  noise: ({ normal, position, uniforms }) =>
    normal.mult(
      position.mult(2).add(uniforms.shift).simplex().mult(uniforms.height, position.y().add(1)),
    ),
  swelling: ({ normal, position, uniforms }) =>
    normal.mult(position.y().mult(0.05).add(uniforms.shift).sin().mult(uniforms.height)),
  waves: ({ glsl, position, uniforms }) =>
    glsl.vec3(0, position.x().mult(uniforms.waves).sin().mult(0.1), 0),
}

/** Uniforms of each call, by the number of the picture. */
const uniforms = {
  noise: (i) => ({ shift: i / 10, height: 0.15 }),
  // A normal in the world has the length 1/60 below a scale of 60.
  swelling: (i) => ({ shift: i / 10, height: 900 }),
  waves: (i) => ({ waves: i ? 60 : 4 }),
}

const shapes = {
  box: (p) => p.box(120),
  plane: (p) => p.plane(170, 170, 1, 1),
  ball(p) {
    p.scale(60)
    p.model(ballOf(p))
  },
}

const balls = new WeakMap()

/** An octahedron that is divided three times, of radius 1. Spheres of p5 have a seam, whose sides differ by rounding. */
function ballOf(p) {
  if (balls.has(p)) return balls.get(p)
  const places = [0, 1, 2].flatMap((axis) =>
    [1, -1].map((sign) => [0, 1, 2].map((i) => (i === axis ? sign : 0))),
  )
  let faces = [0, 1].flatMap((x) =>
    [2, 3].flatMap((y) => [4, 5].map((z) => ((x + y + z) % 2 ? [x, z, y] : [x, y, z]))),
  )
  const middles = new Map()
  const middleOf = (a, b) => {
    const key = `${Math.min(a, b)} ${Math.max(a, b)}`
    if (!middles.has(key)) {
      const sum = places[a].map((x, i) => x + places[b][i])
      middles.set(key, places.push(sum.map((x) => x / Math.hypot(...sum))) - 1)
    }
    return middles.get(key)
  }
  for (let k = 0; k < 3; k++)
    faces = faces.flatMap(([a, b, c]) => {
      const [d, e, f] = [middleOf(a, b), middleOf(b, c), middleOf(c, a)]
      return [
        [a, d, f],
        [d, b, e],
        [f, e, c],
        [d, e, f],
      ]
    })
  const ball = new p5.Geometry(1, 1, function () {
    this.gid = 'ball'
    this.vertices = places.map((place) => p.createVector(...place))
    this.vertexNormals = places.map((place) => p.createVector(...place))
    this.uvs = places.flatMap(() => [0, 0])
    this.faces = faces
  })
  balls.set(p, ball)
  return ball
}

/** Draws a shape with detail; `places` moves it, by the number of the picture. */
function sketch({ shape, name, space, detail = 1, look, places = [turn], isInside, ...others }) {
  let warp, framebuffer
  return {
    ...others,
    setup(p) {
      const given = uniforms[name]?.(0)
      warp = p.createWarp(offsets[name], {
        ...{ space, detail, normals: 'pixel' },
        ...(given && { uniforms: given }),
      })
      if (isInside) framebuffer = p.createFramebuffer()
      others.setup?.(p)
    },
    draw(p, i) {
      framebuffer?.begin()
      if (framebuffer) p.background(0, 0, 100)
      p.noStroke()
      p.lights()
      p.fill(255, 127, 80)
      look?.(p, i)
      warp(uniforms[name]?.(i))
      for (const place of places) {
        p.push()
        place(p, i)
        const draw = typeof shape === 'function' ? shape : shapes[shape]
        draw(p, i)
        p.pop()
      }
      if (!framebuffer) return
      framebuffer.end()
      p.resetShader()
      p.noLights()
      p.image(framebuffer, -size / 2, -size / 2)
    },
  }
}

function turn(p, i) {
  p.rotateX(-0.4 + i / 3)
  p.rotateY(0.5 + i / 2)
  p.scale(0.8 + ((i * 0.382) % 1) / 2)
}

/** Several places in a picture, near and far. */
const around = [
  [0, 60, 0, 1],
  [60, 40, -100, 1.2],
  [0, -50, 50, 0.8],
].map(([x, y, z, size]) => (p, i) => {
  p.translate(x, y, z)
  p.rotateY(0.4 + i / 5)
  p.scale(size)
})

const triangles = async ({ read }, { draws }) =>
  Promise.all(draws.map(async (draw) => (await read(draw)).indices.length / 3))

/** Counts the vertices of one mesh that are not at the same place in another one with the same indices. */
const countMoved = (a, b) => a.filter((x, i) => Math.abs(x - b[i]) > 1e-6).length

/** Counts the vertices of one mesh that another one lacks. */
function countStrays(a, b) {
  const keysOf = (places) =>
    Array.from({ length: places.length / 3 }, (_, i) => places.subarray(3 * i, 3 * i + 3).join())
  const known = new Set(keysOf(b))
  return keysOf(a).filter((key) => !known.has(key)).length
}

const sum = (numbers) => numbers.reduce((a, b) => a + b, 0)

/** Draws with passes and by the CPU → what differs in each draw of each picture. */
async function divide({ frames = 6, hasPlaces, ...given }) {
  const options = { ...given, ...(hasPlaces && { places: around }) }
  const byPasses = await startSketch(sketch(options))
  const byCpu = await startSketch(sketch({ ...options, hasPasses: false }))
  await byPasses.begin()
  await byCpu.picture()
  const found = []
  for (let i = 0; i < frames; i++) {
    // There may be too little room at first.
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
        isIndirect: !!draw.numbers && !expected.draws[k].numbers,
        triangles: ours.indices.length / 3,
        expected: right.indices.length / 3,
        vertices: right.places.length / 3,
        strays: isEqual
          ? countMoved(ours.places, right.places)
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

/** Pixels at which a coarse shape by passes, and without detail, differs from a dense one. */
async function resemble({ name, coarse, dense }) {
  const [coarseShape, denseShape] = [coarse, dense].map(
    ([call, ...numbers]) =>
      (p) =>
        p[call](...numbers),
  )
  const at = { places: [(p) => turn(p, 0)] }
  const byPasses = await startSketch(sketch({ ...at, name, shape: coarseShape }))
  await byPasses.begin()
  const { image } = await byPasses.picture()
  const pictureOf = async (shape) => {
    const one = await startSketch(sketch({ ...at, name, shape, detail: false }))
    const { image } = await one.picture()
    one.remove()
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

/** Comes close to a shape that was small, so that its buffers have to grow. */
async function approach() {
  const places = [(p, i) => p.scale(i ? 1.4 : 0.1)]
  const byPasses = await startSketch(sketch({ shape: 'ball', name: 'noise', places }))
  const byCpu = await startSketch(
    sketch({ shape: 'ball', name: 'noise', places, hasPasses: false }),
  )
  await byPasses.begin()
  const far = await byPasses.picture(0)
  const before = sum(await triangles(byPasses, far))
  const held = buffers.size
  const beyond = []
  let near
  const expected = await byCpu.picture(1)
  const heldByCpu = buffers.size - held
  for (let k = 0; k < 6; k++) {
    near = await byPasses.picture(1)
    beyond.push(beyondEdges(near.image, expected.image, 24))
    await wait(10)
  }
  const result = {
    ...{ before, beyond },
    after: sum(await triangles(byPasses, near)),
    isSame: near.draws[0].index === far.draws[0].index,
    left: buffers.size - held - heldByCpu,
    errors: errors.splice(0),
  }
  byPasses.remove()
  byCpu.remove()
  return result
}

/** Waves that become shorter, so that the shape has to be cut anew. */
async function refine() {
  const places = [(p) => p.rotateX(-0.4)]
  const byPasses = await startSketch(sketch({ shape: 'box', name: 'waves', places }))
  const byCpu = await startSketch(sketch({ shape: 'box', name: 'waves', places, hasPasses: false }))
  await byPasses.begin()
  await byCpu.picture(0)
  const first = await byPasses.picture(1)
  const expected = await byCpu.picture(1)
  await byPasses.begin(1)
  const later = await byPasses.picture(1)
  const result = {
    triangles: sum(await triangles(byPasses, later)),
    beyond: [first, later].map(({ image }) => beyondEdges(image, expected.image, 24)),
    errors: errors.splice(0),
  }
  byPasses.remove()
  byCpu.remove()
  return result
}

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

const areIndirect = ({ draws }) => draws.map(({ numbers }) => !!numbers)

const boxes = new WeakMap()

/** A p5.Geometry of the sketch. */
function boxOf(p) {
  if (!boxes.has(p))
    boxes.set(
      p,
      p.buildGeometry(() => p.box(1)),
    )
  return boxes.get(p)
}

/** Draws picture 0 until passes have begun, then the pictures 1 and 0 → whether passes drew the shapes in these. */
async function leave({ kind }) {
  const one = await startSketch(sketch({ shape: 'box', name: 'twist', ...kinds[kind] }))
  await one.begin()
  const pictures = []
  for (const i of [0, 1, 0]) pictures.push(await one.picture(i))
  one.remove()
  return {
    areIndirect: pictures.map(areIndirect),
    differing: differingPixels(pictures[0].image, pictures[2].image, 0),
    errors: errors.splice(0),
  }
}

/** Draws pictures for longer than passes need to begin with a box of another canvas → whether they do with other shapes. */
async function begin({ kind }) {
  const box = await startSketch(sketch({ shape: 'box', name: 'twist' }))
  const one = await startSketch(sketch({ shape: 'box', name: 'twist', ...kinds[kind] }))
  let found
  for (let later = 0; later < 40 && !found?.every(Boolean);) {
    if (areIndirect(await box.picture()).every(Boolean)) later++
    found = areIndirect(await one.picture())
    await wait(10)
  }
  one.remove()
  box.remove()
  return { found, errors: errors.splice(0) }
}

/** Frees a shape and changes it → the buffers that are held. */
async function life() {
  let shape
  const before = buffers.size
  const one = await startSketch(
    sketch({ name: 'twist', places: around, shape: (p) => p.model((shape = boxOf(p))) }),
  )
  const held = async () => {
    await wait(20)
    return buffers.size - before
  }
  await one.begin()
  const counts = { held: await held() }
  // In the middle of a picture, after it was drawn.
  const { draw } = one.p
  one.p.draw = () => {
    draw()
    one.p.freeGeometry(shape)
  }
  const { image } = await one.picture()
  counts.freed = await held()
  one.p.draw = draw
  counts.differing = differingPixels(image, (await one.picture()).image, 24)
  await one.begin()
  counts.again = await held()
  shape.vertices.forEach((vertex) => vertex.mult(0.9))
  shape.dirtyFlags.vertices = true
  const changed = await one.picture()
  counts.areIndirect = areIndirect(changed)
  await one.begin()
  counts.changed = await held()
  one.remove()
  return { counts, errors: errors.splice(0) }
}

globalThis.compute = { divide, resemble, approach, refine, leave, begin, life }
