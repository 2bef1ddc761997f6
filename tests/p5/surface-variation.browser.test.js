// Warps along the normal in p5 sketches must have exact normals, with addSurfaceVariation() and by default. The normal material shows the
// normals that the GPU computes.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import * as m from '../support/browser/matrix.js'
import { directions, geometryCode, sphereMesh } from '../support/browser/mesh.js'
import { colorAt, differingPixels, litPixels, readPixels } from '../support/browser/pixels.js'
import { openHost, p5Versions, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 200

const { browser, server } = await openHost()

/** Returns bumps along the unit normal, as code and as a function of numbers, for a model of size `u`. */
const bumps = (u) => ({
  code: `({ position, normal }) => normal.normalize().mult(
    position.x().mult(${4 / u}).add(1).sin().add(position.y().mult(${5 / u}).sin()).mult(${0.12 * u}))`,
  offset: ([x, y], normal) => {
    const height = 0.12 * u * (Math.sin((4 / u) * x + 1) + Math.sin((5 / u) * y))
    return m.normalize(normal).map((k) => height * k)
  },
})

/** Bumps that depend on the texture coordinates of `sphereMesh`, which start at the back. */
const uvBumps = {
  code: `({ normal, uv }) => normal.mult(
    uv.x().mult(${12 * Math.PI}).sin().mult(uv.y().mult(${Math.PI}).sin()).mult(0.1))`,
  offset: ([x, y, z], normal) => {
    const u = ((Math.atan2(x, z) / (2 * Math.PI)) % 1) + 1
    const v = Math.acos(-y) / Math.PI
    const height = 0.1 * Math.sin(12 * Math.PI * u) * Math.sin(Math.PI * v)
    return normal.map((k) => height * k)
  },
}

const view = m.lookAt([60, -90, 300], [10, 5, 0], [0, 1, 0])
const model = m.product(
  m.translation(20, -15, 10),
  m.rotation(0.5, 0, 1),
  m.rotation(-0.8, 2, 0),
  m.rotation(0.4, 1, 2),
  m.scaling(100, 65, 90),
)
const placed = `
  perspective(PI / 3, 1, 10, 2000)
  camera(60, -90, 300, 10, 5, 0, 0, 1, 0)
  translate(20, -15, 10)
  rotateZ(0.5)
  rotateY(-0.8)
  rotateX(0.4)
  scale(100, 65, 90)`
const identity = m.scaling(1, 1, 1)
const spaces = {
  local: { ...bumps(1), before: identity, after: m.product(view, model) },
  world: { ...bumps(80), before: model, after: view },
  camera: { ...bumps(80), before: m.product(view, model), after: identity },
  uv: { ...uvBumps, before: identity, after: m.product(view, model) },
}

/** Returns the warped position of a point of the unit sphere, and its normal from finite differences, in view space. */
function warpedVertex(p, { offset, before, after }) {
  const move = (q) => {
    const position = m.transformPoint(before, q)
    // p5's normals are also transformed by the inverse transpose, but not normalized.
    const normal = m.transformNormal(before, q)
    return m.transformPoint(after, m.add(position, offset(position, normal)))
  }
  const tangent = m.normalize(m.cross(p, Math.abs(p[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0]))
  const slope = (t) => {
    const movedAt = (s) => move(m.normalize(p.map((x, k) => x + s * t[k])))
    return m.subtract(movedAt(1e-4), movedAt(-1e-4))
  }
  const normal = m.normalize(m.cross(slope(tangent), slope(m.cross(p, tangent))))
  return { position: move(p), normal }
}

describe('createWarp on p5 2.x, along the normal', () => {
  test('is exact for a shape with addSurfaceVariation, and for others by default', async () => {
    const sphere = sphereMesh(160, 120)
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['2.x'], addon],
      `let scene = () => (window.done = true)
      const warps = {}, rough = {}
      let varied, plain
      async function setup() {
        pixelDensity(1)
        createCanvas(${size}, ${size}, WEBGL)
        noLoop()
        varied = ${geometryCode(sphere, 'varied')}
        plain = ${geometryCode(sphere, 'plain')}
        if ((await addSurfaceVariation(varied)) !== varied) throw new Error('addSurfaceVariation returned another shape')
        ${Object.entries(spaces)
          .map(([name, { code }]) => {
            const space = name === 'uv' ? 'local' : name
            const options = `type: 'normal', space: '${space}'`
            return `warps.${name} = createWarp(${code}, { ${options} })
            rough.${name} = createWarp(${code}, { ${options}, surfaceVariation: false })`
          })
          .join('\n')}
      }
      function draw() {
        background(0)
        push()
        ${placed}
        scene()
        pop()
      }`,
    )
    const draw = async (code) => {
      await page.evaluate(`scene = () => { ${code} }; redraw()`)
      return readPixels(page)
    }
    for (const [name, space] of Object.entries(spaces)) {
      const exact = await draw(`warps.${name}(); model(varied)`)
      // Draws the plain shape after the varied one, whose attributes p5 leaves enabled.
      const plain = await draw(
        `warps.${name}(); model(varied); clear(); background(0); model(plain)`,
      )
      const rough = await draw(`rough.${name}(); model(varied)`)
      const lit = litPixels(exact).length
      assert.ok(
        differingPixels(exact, rough, 10) > 0.15 * lit,
        `${name}: surfaceVariation: false does not change the picture`,
      )

      const focal = 1 / Math.tan(Math.PI / 6)
      const seen = directions(300)
        .filter(
          ([x, y, z]) => name !== 'uv' || (Math.abs(y) < 0.9 && !(Math.abs(x) < 0.05 && z > 0)),
        )
        .map((direction) => warpedVertex(direction, space))
        .map(({ position: [x, y, z], normal }) => ({
          normal,
          toEye: m.normalize([-x, -y, -z]),
          screen: [x, y].map((c) => ((1 + (focal * c) / -z) * size) / 2),
        }))
        .filter(({ normal, toEye }) => m.dot(normal, toEye) > 0.45)
      assert.ok(seen.length >= 20, `${name}: ${seen.length} points face the camera`)
      const errors = (image) =>
        seen.map(({ normal, screen }) => {
          const expected = normal.map((value) => 255 * Math.max(value, 0))
          const color = colorAt(image, ...screen)
          return Math.max(...color.map((value, i) => Math.abs(value - expected[i])))
        })
      assert.ok(
        Math.max(...errors(plain)) <= 3,
        `${name}: ${Math.max(...errors(plain))} levels off by default`,
      )
      assert.ok(
        Math.max(...errors(exact)) <= 3,
        `${name}: ${Math.max(...errors(exact))} levels off`,
      )
      assert.ok(
        Math.max(...errors(rough)) >= 10,
        `${name}: ${Math.max(...errors(rough))} levels off without surface variation`,
      )
    }
    await leavePage(page)
    assert.deepEqual(messages, [])
  })
})

for (const [version, p5] of Object.entries(p5Versions))
  test(`p5 ${version} prints nothing for warps along the normal, and reports the requirements of addSurfaceVariation`, async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5, addon],
      `let warp, other
      async function setup() {
        createCanvas(50, 50, WEBGL)
        const bumpy = ({ normal, position }) => normal.mult(position.x())
        warp = createWarp(bumpy)
        other = createWarp(bumpy, { surfaceVariation: false })
        window.problem = await addSurfaceVariation(buildGeometry(() => sphere(20))).then(() => 'none', ({ message }) => message)
      }
      function draw() {
        for (const distort of [warp, other]) if (distort) {
          distort(); sphere(50)
          beginShape(); vertex(0, 0, 0, 0, 0); vertex(9, 0, 0, 1, 0); vertex(0, 9, 0, 0, 1); endShape()
        }
        if (frameCount > 6) window.done = true
      }`,
    )
    const expected =
      version === '2.x'
        ? 'none'
        : 'addSurfaceVariation: this p5 has no vertex properties; use p5 2.'
    assert.equal(await page.evaluate('problem'), expected)
    await leavePage(page)
    assert.deepEqual(messages, [])
  })
