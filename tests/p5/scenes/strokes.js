// Lines, wireframes and points under a warp, compared with p5's transformations and with lines through moved points.
import assert from 'node:assert/strict'
import { leavePage } from '../../support/browser/browser.js'
import { font } from '../../support/browser/p5-hosts.js'
import { p5Versions, runSketch } from '../../support/browser/sketch.js'

/** Returns the outlines of a text, [[[x, y], …], …]. Computes them with p5 2.x, since 1.11 cannot. */
async function computeContours(text, { webgl, server }) {
  const { page, messages } = await runSketch(
    webgl,
    server,
    [p5Versions['2.x']],
    `async function setup() {
      createCanvas(10, 10, WEBGL)
      noLoop()
      textSize(90)
      const contours = (await loadFont('${font}')).textToContours('${text}', -69.7, 30.3, { sampleFactor: 0.3 })
      window.contours = contours.map((points) => points.map(({ x, y }) => [x, y]))
      window.done = true
    }`,
  )
  const contours = await page.evaluate('contours')
  await leavePage(page)
  assert.deepEqual(messages, [])
  return contours
}

/** One rotation, in p5 and as an offset. */
const turn = 'rotateZ(0.6); rotateX(0.5)'
const turned = `({ glsl, position }) =>
  glsl.rotateZ(0.6).mult(glsl.rotateX(0.5)).mult(position).sub(position)`

/** Resets settings that pop() does not restore. */
const camera = 'camera(0, 0, 700, 0, 0, 0, 0, 1, 0); strokeJoin(ROUND); strokeCap(ROUND)'

/** Maps a title → the style and the code of a drawing. */
const shapes = {
  'a wireframe': { style: 'noFill(); stroke(255); strokeWeight(3)', shape: 'box(60)' },
  'a fill with its edges': {
    style: `fill('teal'); stroke('orange'); strokeWeight(4)`,
    shape: 'box(70)',
  },
  'many edges': { style: `fill(90); stroke('gold'); strokeWeight(1)`, shape: 'sphere(60, 12, 8)' },
  'a line with square caps': {
    style: 'stroke(255); strokeWeight(14); strokeCap(PROJECT)',
    shape: 'line(-60, -20, 30, 50, 30, -40)',
  },
  'a curve': {
    style: 'noFill(); stroke(255); strokeWeight(9)',
    shape: 'bezier(-70, 0, 10, -30, -90, 0, 40, 80, 50, 70, 0, -60)',
  },
  'bevelled joins': {
    style: 'noFill(); stroke(255); strokeWeight(12); strokeJoin(BEVEL)',
    shape: 'beginShape(); vertex(-60, -40, 0); vertex(0, 50, 40); vertex(60, -40, -40); endShape()',
  },
  'a line cut off at its ends': {
    style: 'stroke(255); strokeWeight(14); strokeCap(SQUARE)',
    shape: 'line(-60, -20, 30, 50, 30, -40)',
  },
  'mitred joins': {
    style: 'noFill(); stroke(255); strokeWeight(12); strokeJoin(MITER)',
    shape: 'beginShape(); vertex(-60, -40, 0); vertex(0, 50, 40); vertex(60, -40, -40); endShape()',
  },
  'outlines of text': {
    style: 'noFill(); stroke(255); strokeWeight(3)',
    shape: `for (const points of word) {
      beginShape()
      for (const [x, y] of points) vertex(x, y)
      endShape(CLOSE)
    }`,
  },
  points: {
    style: 'stroke(255); strokeWeight(11)',
    shape: 'point(-40, 20, 30); point(50, 0, -30)',
  },
}

/**
 * Points of a line, so close that chords approximate tangents after it is bent; and the warp, as a function of numbers and as an offset.
 */
const straight = Array.from({ length: 161 }, (_, i) => [i - 80, 0.3 * i - 24, 20])
const bent = ([x, y, z]) => [x, y + 40 * Math.sin(x / 20), z + 30 * Math.cos(x / 30)]
const bending = `({ glsl, position: { x } }) => glsl.vec3(0, x.div(20).sin().mult(40), x.div(30).cos().mult(30))`
const lineThrough = (points) =>
  `beginShape(); ${points.map((point) => `vertex(${point})`).join('; ')}; endShape()`

const bentStyles = {
  'round caps': 'strokeWeight(9)',
  'ends cut off': 'strokeWeight(14); strokeCap(SQUARE)',
  thin: 'strokeWeight(2)',
}

const spaces = ['world', 'camera', 'local']

/** Returns code that makes warps with the same offset in each space. Camera space is world space moved by 700 pixels. */
const inSpaces = (offset) => `
  const offset = ${offset}
  warps.world = createWarp(offset, { space: 'world' })
  warps.camera = createWarp(({ glsl, position }) =>
    offset({ glsl, position: position.add(glsl.vec3(0, 0, 700)) }), { space: 'camera' })
  warps.local = createWarp(offset)`

export default [
  {
    title: "strokes follow a warp in the same way as p5's transforms, in each space",
    table: async (host) => ({
      setup: `word = ${JSON.stringify(await computeContours('We8', host))}; ${inSpaces(turned)}`,
      pairs: Object.fromEntries(
        Object.entries(shapes).flatMap(([name, { style, shape }]) =>
          spaces.map((space) => [
            `${name}, in ${space} space`,
            [
              `${camera}; ${style}; warps.${space}(); ${shape}`,
              `${camera}; ${turn}; ${style}; ${shape}`,
            ],
          ]),
        ),
      ),
      ...{ lit: 150, tolerance: 8, differing: 0 },
    }),
  },
  {
    title: 'strokes bend with a warp like a line through the moved points',
    table: () => ({
      setup: inSpaces(bending),
      pairs: Object.fromEntries(
        Object.entries(bentStyles).flatMap(([name, style]) =>
          spaces.map((space) => [
            `${name}, in ${space} space`,
            [`warps.${space}(); ${lineThrough(straight)}`, lineThrough(straight.map(bent))].map(
              (code) => `${camera}; noFill(); stroke(255); ${style}; ${code}`,
            ),
          ]),
        ),
      ),
      // Since chords only approximate tangents, antialiased edges differ slightly.
      ...{ lit: 150, tolerance: 8, differing: 0.04, withinEdges: 'first' },
    }),
  },
]
