// Offsets of normal and of uv on p5's own shapes, as a sketch draws them, with no call beside: the light at each vertex is that
// of the surface which the offset makes, whose normal comes from differences in double of what p5 documents its shapes to be.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { leavePage } from './support/browser.js'
import * as m from './support/matrix.js'
import { colorAt } from './support/pixels.js'
import { servePages } from './support/server.js'
import {
  drawScenes,
  launchFor,
  p5HostsInThisRun,
  p5InThisRun,
  runSketch,
} from './support/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 900

let browsers, server
before(async () => {
  server = await servePages()
  browsers = await launchFor(p5HostsInThisRun)
})
after(async () => {
  for (const browser of Object.values(browsers)) await browser.close()
  await server.close()
})

const { PI, sin, cos } = Math

/** Each shape of size 1 by u and v, with its normal; `grid` is p5's default detail, as steps of u and v. */
const surfaces = {
  sphere: {
    code: 'sphere(R)',
    grid: [24, 16],
    at: (u, v) => {
      const [theta, phi] = [2 * PI * u, PI * v - PI / 2]
      const p = [cos(phi) * sin(theta), sin(phi), cos(phi) * cos(theta)]
      return { p, n: p }
    },
  },
  torus: {
    code: 'torus(R, 0.3 * R)',
    grid: [24, 16],
    at: (u, v) => {
      const [theta, phi] = [2 * PI * u, 2 * PI * v]
      const r = 1 + 0.3 * cos(phi)
      return {
        p: [r * cos(theta), r * sin(theta), 0.3 * sin(phi)],
        n: [cos(phi) * cos(theta), cos(phi) * sin(theta), sin(phi)],
      }
    },
  },
  cylinder: {
    code: 'cylinder(R, R)',
    // p5 puts one column fewer around than it says.
    grid: [23, 1],
    at: (u, v) => {
      const theta = 2 * PI * u
      return { p: [sin(theta), v - 0.5, cos(theta)], n: [sin(theta), 0, cos(theta)] }
    },
  },
  cone: {
    code: 'cone(R, R)',
    grid: [23, 1],
    at: (u, v) => {
      const theta = 2 * PI * u
      const [r, h] = [1 - v, Math.SQRT1_2]
      return {
        p: [r * sin(theta), v - 0.5, r * cos(theta)],
        n: [h * sin(theta), h, h * cos(theta)],
      }
    },
  },
  plane: {
    // plane(R, R) would leave z as it is.
    code: 'scale(R); plane(1, 1, 20, 20)',
    grid: [20, 20],
    at: (u, v) => ({ p: [u - 0.5, v - 0.5, 0], n: [0, 0, 1] }),
  },
  box: {
    code: 'box(R)',
    grid: [1, 1],
    // The face towards the eye.
    at: (u, v) => ({ p: [u - 0.5, v - 0.5, 0.5], n: [0, 0, 1] }),
  },
}

const offsets = {
  'a blob along the normal': {
    code: `({ position, normal }) => normal.mult(
      position.x().mult(3).add(1).sin().add(position.y().mult(4).sin()).mult(0.06))`,
    at: ([x, y], n) => n.map((k) => 0.06 * k * (sin(3 * x + 1) + sin(4 * y))),
  },
  'a flag by uv': {
    code: `({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(${4 * PI}).sin().mult(uv.y()).mult(0.05))`,
    at: (_, __, [u, v]) => [0, 0, 0.05 * v * sin(4 * PI * u)],
  },
}

/** The angles about x and y by which many vertices have normals of three positive parts, which a picture can show. */
const turns = { sphere: [0.5, -0.4], plane: [-0.5, 0.5] }
const [radius, distance] = [300, 1500]
const placed = ([x, y]) => `perspective(2 * atan(${size / 2 / distance}), 1, 100, 5000)
  camera(0, 0, ${distance}, 0, 0, 0, 0, 1, 0)
  rotateX(${x}); rotateY(${y})`

/** The vertices that are seen, away from edges, each with its true normal and where it is on the canvas. */
function seenVertices({ grid, at }, offset, [aboutX, aboutY]) {
  const turn = m.product(m.rotation(aboutX, 1, 2), m.rotation(aboutY, 2, 0))
  const [columns, rows] = grid
  const moved = (u, v) => {
    const { p, n } = at(u, v)
    return m.movePoint(turn, m.add(p, offset.at(p, n, [u, v])))
  }
  const seen = []
  for (let i = 1; i < columns; i++)
    for (let j = 1; j < rows; j++) {
      const [u, v] = [i / columns, j / rows]
      const slope = (du, dv) => m.subtract(moved(u + du, v + dv), moved(u - du, v - dv))
      const unit = m.normalize(m.cross(slope(1e-4, 0), slope(0, 1e-4)))
      // Outwards, as p5's normals are.
      const normal = m.dot(unit, m.turnNormal(turn, at(u, v).n)) < 0 ? unit.map((x) => -x) : unit
      const [x, y, z] = moved(u, v).map((k) => radius * k)
      const screen = [x, y].map((k) => size / 2 + (distance * k) / (distance - z))
      if (Math.min(...normal) > 0.1 && normal[2] > 0.5) seen.push({ normal, screen })
    }
  return seen
}

/** Those that hide none of their own vertices, and have some inside. */
const shown = Object.keys(turns)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`p5 ${version} by ${renderer} lights`, () => {
    for (const [what, offset] of Object.entries(offsets))
      test(`${what} within half a degree`, async () => {
        const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
          renderer,
          size,
          setup: `warps.it = createWarp(${offset.code}, { type: 'normal' })`,
          scenes: Object.fromEntries(
            shown.map((name) => [
              name,
              `${placed(turns[name])}; noStroke(); warps.it(); ${surfaces[name].code.replaceAll('R', radius)}`,
            ]),
          ),
        })
        for (const name of shown) {
          const seen = seenVertices(surfaces[name], offset, turns[name])
          assert.ok(seen.length >= 8, `${name}: ${seen.length} vertices are seen`)
          for (const { normal, screen } of seen) {
            const color = m.normalize(colorAt(images[name], ...screen))
            const degrees = (180 / PI) * Math.acos(Math.min(1, m.dot(color, normal)))
            assert.ok(degrees < 0.5, `${name}: ${degrees} degrees off at ${screen}`)
          }
        }
      })
  })

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: how each of its shapes varies is by its formula`, async () => {
    const { page, messages } = await runSketch(
      browsers.WEBGL,
      server,
      [p5, addon],
      `const shapes = {}
      function setup() {
        createCanvas(100, 100, WEBGL)
        const distort = createWarp(({ glsl, normal, uv }) => normal.mult(uv.x().add(uv.y())))
        noLoop()
        // Where the shaders ask for it.
        const { prototype } = p5.Geometry
        const { get } = Object.getOwnPropertyDescriptor(prototype, 'warpjet_uGradient')
        let asking
        Object.defineProperty(prototype, 'warpjet_uGradient', {
          get() { asking = this; return get.call(this) } })
        const names = 'normalXGradient normalYGradient normalZGradient uGradient vGradient'.split(' ')
        const draw = { ${Object.entries(surfaces)
          .map(([name, { code }]) => `${name}: () => { ${code.replaceAll('R', 40)} }`)
          .join(', ')} }
        for (const [name, shape] of Object.entries(draw)) {
          distort(); shape()
          const list = (vectors) => vectors.map(({ x, y, z }) => [x, y, z])
          shapes[name] = { vertices: list(asking.vertices), normals: list(asking.vertexNormals), uvs: [...asking.uvs],
            gradients: names.map((each) => [...asking['warpjet_' + each]]) }
        }
        done = true
      }`,
    )
    const shapes = await page.evaluate('shapes')
    await leavePage(page)
    assert.deepEqual(messages, [])
    for (const [name, { at }] of Object.entries(surfaces)) {
      const { vertices, normals, uvs, gradients } = shapes[name]
      let count = 0
      vertices.forEach((vertex, i) => {
        const [u, v] = [uvs[2 * i], uvs[2 * i + 1]]
        const { p, n } = at(u, v)
        const unit = m.normalize(normals[i])
        // Caps, other faces of a box, and where many u meet.
        if (Math.hypot(...m.subtract(p, vertex)) > 1e-5 || m.dot(m.normalize(n), unit) < 0.999)
          return
        const along = [
          [1e-5, 0],
          [0, 1e-5],
        ].map(([du, dv]) => {
          const [a, b] = [at(u - du, v - dv), at(u + du, v + dv)]
          const half = du + dv
          return {
            p: m.subtract(b.p, a.p).map((x) => x / (2 * half)),
            values: [...m.subtract(b.n, a.n).map((x) => x / (2 * half)), du / half, dv / half],
          }
        })
        if (along.some(({ p: step }) => Math.hypot(...step) < 1e-3)) return
        count++
        gradients.forEach((list, k) => {
          const gradient = list.slice(3 * i, 3 * i + 3)
          for (const { p: step, values } of along) {
            const error = Math.abs(m.dot(gradient, step) - values[k])
            assert.ok(error < 5e-3, `${name}, vertex ${i}, ${k}: ${error}`)
          }
          assert.ok(Math.abs(m.dot(gradient, unit)) < 1e-4, `${name}, vertex ${i}: in the surface`)
        })
      })
      assert.ok(count >= 4, `${name}: ${count} vertices`)
    }
  })
