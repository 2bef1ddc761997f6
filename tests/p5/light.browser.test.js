// Offsets that read normal and uv, on p5's own shapes, in sketches that do not call for gradients: compares the light at each vertex with
// the normal of the warped surface, which is computed by finite differences, in double, from p5's documented shapes.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import * as m from '../support/browser/matrix.js'
import { addon, font, openP5Hosts } from '../support/browser/p5-hosts.js'
import {
  distance,
  isTorn,
  seenCorners,
  size,
  trianglesOf,
  unit,
} from '../support/browser/p5-seen-corners.js'
import { radius, surfaces } from '../support/browser/p5-surfaces.js'
import { colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, p5Versions, runSketch } from '../support/browser/sketch.js'

const hosts = await openP5Hosts()
const [{ webgl, server }] = hosts
/** The hosts on WebGL. */
const webglHosts = hosts.filter(({ isWebGPU }) => !isWebGPU)

const { PI, sin } = Math

/**
 * Offsets as code, and as functions of numbers (`at`). Both take the `grain` of a shape, { height, length, normals }, to adapt to its
 * size: they divide positions by `length`, multiply heights by `height`, and multiply normals by `normals`.
 */
const offsets = {
  'a blob along the normal': {
    code: ({
      height,
      length,
      normals,
    }) => `({ position, normal }) => { const p = position.div(${length})
      return normal.mult(p.x().mult(3).add(1).sin().add(p.y().mult(4).sin()).mult(${0.06 * height * normals})) }`,
    at: ([x, y], n, _, { height, normals }) =>
      n.map((k) => 0.06 * height * normals * k * (sin(3 * x + 1) + sin(4 * y))),
  },
  'a flag that depends on uv': {
    code: ({ height }) =>
      `({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(${4 * PI}).sin().mult(uv.y()).mult(${0.05 * height}))`,
    at: (_, __, [u, v], { height }) => [0, 0, 0.05 * height * v * sin(4 * PI * u)],
  },
}

/** A word, as a model that p5 makes of its letters. */
const word = {
  setup: `textSize(180)
    warps.word = (await loadFont('${font}')).textToModel('We', -130, 50, { extrude: 60, sampleFactor: 0.5 })
    // p5 adds another canvas for text; the canvas with the pictures must be the first.
    document.body.prepend(document.querySelector('#defaultCanvas0'))`,
  code: 'model(warps.word)',
  grain: { height: radius, length: radius, normals: 1 },
}

/**
 * Returns the shapes for a host. p5 1.11 has no text models, and on WebGPU p5 2.3.4 itself fails to draw them: "flat is not a function".
 */
const shapesOn = ({ isV1, isWebGPU }) =>
  Object.entries({
    ...surfaces,
    ...(!isV1 && !isWebGPU && { 'a word': word }),
  })

/**
 * Rotations about x and y. The normal material shows only positive components; with these rotations, all three are positive in many places.
 */
const turns = [
  [-0.6, 0.8],
  [-0.6, 3.9],
  [0.6, 2.4],
  [0.6, 5.5],
]
const camera = `perspective(2 * atan(${size / 2 / distance}), 1, 100, 5000)
  camera(0, 0, ${distance}, 0, 0, 0, 0, 1, 0)`

/** Makes shapes in p5. Returns an object that maps their names to { vertices, normals, uvs, faces, gradients }. */
async function makeGeometries(p5, shapes) {
  const { page, messages } = await runSketch(
    webgl,
    server,
    [p5, addon],
    `const shapes = {}, warps = {}
    ${p5 === p5Versions['2.x'] ? 'async ' : ''}function setup() {
      createCanvas(100, 100, WEBGL)
      const distort = createWarp(({ normal, uv }) => normal.mult(uv.x().add(uv.y())))
      noLoop()
      noStroke()
      ${shapes.map(([, { setup }]) => setup ?? '').join('\n')}
      const { prototype } = p5.Geometry
      const { get } = Object.getOwnPropertyDescriptor(prototype, 'warpjet_uGradient')
      let drawn
      Object.defineProperty(prototype, 'warpjet_uGradient', {
        get() { drawn = this; return get.call(this) } })
      const names = 'normalXGradient normalYGradient normalZGradient uGradient vGradient'.split(' ')
      const draw = { ${shapes.map(([name, { code }]) => `'${name}': () => { ${code} }`).join(', ')} }
      for (const [name, shape] of Object.entries(draw)) {
        distort(); shape()
        const list = (vectors) => vectors.map(({ x, y, z }) => [x, y, z])
        shapes[name] = { vertices: list(drawn.vertices), normals: list(drawn.vertexNormals),
          uvs: [...drawn.uvs].flat(), faces: drawn.faces,
          gradients: names.map((each) => [...drawn['warpjet_' + each]]) }
      }
      done = true
    }`,
  )
  // Passes a string, which Playwright transfers without conversion.
  const geometries = JSON.parse(await page.evaluate('JSON.stringify(shapes)'))
  await leavePage(page)
  assert.deepEqual(messages, [])
  return geometries
}

/** Maps a version of p5 → its shapes. */
const geometries = new Map()

for (const host of hosts)
  describe(`${host.name}, lights`, () => {
    const { version, draw } = host
    const shapes = shapesOn(host)
    for (const [what, offset] of Object.entries(offsets))
      test(`${what} within half a degree, on each shape`, async () => {
        if (!geometries.has(version))
          geometries.set(version, await makeGeometries(p5Versions[version], shapes))
        const seen = shapes.flatMap(([name, shape]) => {
          const triangles = trianglesOf(geometries.get(version)[name], shape)
          return turns
            .map((turn) => ({ name, turn, corners: seenCorners(triangles, shape, offset, turn) }))
            .filter(({ corners }) => corners.length > 0)
        })
        const scenes = seen.map(({ name, turn: [x, y] }) => [
          `${name} ${x} ${y}`,
          `${camera}\nrotateX(${x}); rotateY(${y}); noStroke(); warps['${name}']()
          ${surfaces[name]?.code ?? word.code}`,
        ])
        const images = await draw({
          size,
          setup: shapes
            .map(
              ([name, { setup = '', grain = unit }]) => `noStroke(); ${setup}
              warps['${name}'] = createWarp(${offset.code(grain)}, { type: 'normal', normals: 'vertex' })`,
            )
            .join('\n'),
          scenes: Object.fromEntries(scenes),
        })
        for (const [name] of shapes) {
          const vertices = new Set()
          for (const { turn, corners } of seen.filter((view) => view.name === name))
            for (const { normal, at, vertex, p } of corners) {
              vertices.add(vertex)
              const color = m.normalize(colorAt(images[`${name} ${turn.join(' ')}`], ...at))
              const degrees = (180 / PI) * Math.acos(Math.min(1, m.dot(color, normal)))
              assert.ok(degrees < 0.5, `${name}, from ${turn}: ${degrees} degrees off at ${p}`)
            }
          assert.ok(vertices.size >= 5, `${name}: ${vertices.size} vertices are seen`)
        }
      })
  })

for (const host of webglHosts)
  test(`${host.name}: the gradients of p5's own shapes equal those of the formula`, async () => {
    const { version } = host
    const shapes = shapesOn(host)
    if (!geometries.has(version))
      geometries.set(version, await makeGeometries(p5Versions[version], shapes))
    for (const [name, { sides, isBuilt }] of shapes) {
      const geometry = geometries.get(version)[name]
      assert.ok(geometry.gradients.flat().every(Number.isFinite), name)
      if (!sides || isBuilt) continue
      let [count, torn] = [0, 0]
      for (const corner of trianglesOf(geometry, { sides }).flat()) {
        const { side, where, n, vertex } = corner
        const [s, t] = where
        const gradients = geometry.gradients.map((list) => list.slice(3 * vertex, 3 * vertex + 3))
        if (isTorn(corner)) {
          // At a torn corner, we can only check that the gradient of u is large, and its direction.
          const u = gradients[3]
          const tNearby = side.edges.includes(0) && t < 0.5 ? 1e-3 : t - 1e-3
          const alongU = m.subtract(side.at(s + 1e-4, tNearby).p, side.at(s - 1e-4, tNearby).p)
          assert.ok(Math.hypot(...u) > 1e3, `${name}, ${vertex}: ${u}`)
          assert.ok(
            m.dot(m.normalize(u), m.normalize(alongU)) > 1 - 1e-6,
            `${name}, ${vertex}: ${u}`,
          )
          torn++
          continue
        }
        count++
        for (const [ds, dt] of [
          [1e-5, 0],
          [0, 1e-5],
        ]) {
          const [a, b] = [side.at(s - ds, t - dt), side.at(s + ds, t + dt)]
          const slope = (x, y) => y.map((value, i) => (value - x[i]) / 2e-5)
          const tangent = slope(a.p, b.p)
          const slopes = [...slope(a.n, b.n), ...slope(a.uv, b.uv)]
          gradients.forEach((gradient, k) => {
            const error = Math.abs(m.dot(gradient, tangent) - slopes[k])
            assert.ok(error < 5e-3, `${name}, vertex ${vertex}, ${k}: ${error}`)
            assert.ok(
              Math.abs(m.dot(gradient, m.normalize(n))) < 1e-4,
              `${name}: the gradient is not tangent to the surface`,
            )
          })
        }
      }
      assert.ok(count >= 90, `${name}: ${count} corners`)
      assert.ok(name === 'torus' || torn >= 20, `${name}: ${torn} corners where u has no slope`)
    }
  })

/** Maps a pole or an apex to its shape and the side from which it is in the middle of the picture. */
const ends = {
  "a sphere's pole": ['sphere', 1],
  'its other pole': ['sphere', -1],
  "a cone's apex": ['cone', 1],
}

/** Lights from the corners of a tetrahedron, so that each unit normal gets at least a third of one light. */
const allAround = ['1, 1, 1', '1, -1, -1', '-1, 1, -1', '-1, -1, 1']
  .map((direction) => `directionalLight(255, 255, 255, ${direction})`)
  .join('; ')

// On WEBGPU p5 2.3 itself uses only the first directional light.
for (const { name: host, draw } of webglHosts)
  test(`${host}: a warp that reads uv has unit normals at poles and apexes, where the surface has no normal`, async () => {
    const shapes = { own: (shape) => `${shape}(60)`, built: (shape) => `model(warps.${shape})` }
    const scenes = Object.entries(shapes).flatMap(([maker, draw]) =>
      Object.entries(ends).map(([name, [shape, side]]) => [
        `${name}, ${maker}`,
        `noStroke(); fill(255); ${allAround}
        rotateX(${(side * PI) / 2}); warps.${maker}(); ${draw(shape)}`,
      ]),
    )
    const flag = offsets['a flag that depends on uv']
    const images = await draw({
      setup: `noStroke()
        warps.own = createWarp(${flag.code(unit)})
        warps.built = createWarp(${flag.code({ height: 60 })})
        warps.sphere = buildGeometry(() => sphere(60))
        warps.cone = buildGeometry(() => cone(60))`,
      scenes: Object.fromEntries(scenes),
    })
    for (const [name, image] of Object.entries(images))
      for (let y = image.height / 2 - 12; y < image.height / 2 + 12; y++)
        for (let x = image.width / 2 - 12; x < image.width / 2 + 12; x++)
          assert.ok(colorAt(image, x, y)[0] > 50, `${name}: dark at ${x}, ${y}`)
  })

for (const { name, canvas, open } of hosts)
  test(`${name}: the gradients of other shapes are computed once and cached`, async () => {
    const { page, messages } = await open(
      `let shape, computations = 0, bend, bulge
      async function setup() {
        ${canvas(100, 100)}
        noLoop()
        noStroke()
        shape = buildGeometry(() => torus(30, 10))
        // Counts the computations of gradients by their calls of this function.
        const { forEach } = shape.vertices
        Object.defineProperty(shape.vertices, 'forEach', {
          value(...all) { computations += /warpjet/.test(new Error().stack); return forEach.apply(this, all) } })
        bend = createWarp(({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(6).sin().mult(5)))
        bulge = createWarp(({ normal, uv }) => normal.mult(uv.y()))
      }
      function draw() {
        background(0)
        for (const warp of [bend, bulge]) { warp(); model(shape) }
        done = true
      }`,
    )
    const redrawAndCount = () => page.evaluate('redraw(), computations')
    const first = await redrawAndCount()
    assert.equal(first, 1)
    for (let frame = 0; frame < 5; frame++) assert.equal(await redrawAndCount(), 1)
    await leavePage(page)
    assert.deepEqual(messages, [])
  })

test(
  'p5 1.11 lights offsets of normal and uv in each space like 2.x, also in WebGL 1',
  { skip: webglHosts.length < 2 },
  async () => {
    const spaces = { local: 0.1, world: 6, camera: 6 }
    const warps = Object.entries(spaces).flatMap(([space, height]) => [
      [
        `by the normal, in ${space} space`,
        space,
        `glsl.vec3(0, normal.normalize().x().mult(4).sin().mult(${3 * height}), 0)`,
      ],
      [
        `by normal and uv, in ${space} space`,
        space,
        `normal.mult(position.x().div(${height}).sin().mult(${height}))
        .add(glsl.vec3(0, 0, uv.x().mult(12).sin().mult(${height})))`,
      ],
    ])
    // From the side, so that view-space normals differ from world-space normals.
    const scene = `camera(500, -400, 500, 10, 5, 0, 0, 1, 0); noStroke()
      rotateX(0.5); rotateY(0.4); scale(1, 1.3, 0.8)`
    const draw = (version, attributes = '') =>
      drawScenes(webgl, server, [p5Versions[version], addon], {
        setup: `${attributes}
          ${warps
            .map(
              ([
                name,
                space,
                code,
              ]) => `warps['${name}'] = createWarp(({ glsl, normal, uv, position }) =>
              ${code}, { type: 'normal', space: '${space}' })`,
            )
            .join('\n')}`,
        scenes: Object.fromEntries(
          warps.map(([name]) => [name, `${scene}\nwarps['${name}'](); sphere(60, 40, 40)`]),
        ),
      })
    const images = await draw('2.x')
    for (const older of [await draw('1.11'), await draw('1.11', 'setAttributes({ version: 1 })')])
      for (const [name] of warps) {
        assert.ok(litPixels(images[name]).length > 5000, name)
        assert.equal(differingPixels(images[name], older[name], 8), 0, name)
      }
  },
)
