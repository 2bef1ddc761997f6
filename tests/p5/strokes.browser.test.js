// Lines, wireframes and points under a warp, compared with p5's own `rotate`: the oracle is p5's own transformation.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { beyondEdges, colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import {
  drawScenes,
  openHosts,
  p5HostsInThisRun,
  p5Versions,
  runSketch,
} from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const font = '/node_modules/@fontsource/fredoka/files/fredoka-latin-700-normal.woff'

const { browsers, server } = await openHosts(p5HostsInThisRun)
const word = await contoursOf('We8')

/** The outlines of a word, computed by p5 2.x since 1.11 cannot: [[[x, y], …], …]. */
async function contoursOf(text) {
  const { page, messages } = await runSketch(
    browsers.WEBGL,
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

/** The same rotation twice: through p5, and as an offset. */
const turn = 'rotateZ(0.6); rotateX(0.5)'
const turned = `({ glsl, position }) =>
  glsl.rotateZ(0.6).mult(glsl.rotateX(0.5)).mult(position).sub(position)`

/** Resets settings that pop() does not restore. */
const camera = 'camera(0, 0, 700, 0, 0, 0, 0, 1, 0); strokeJoin(ROUND); strokeCap(ROUND)'

/** The drawing after the rotation. */
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

/** Points of a line, close enough that chords approximate its tangents, and their warped positions in double. */
const straight = Array.from({ length: 161 }, (_, i) => [i - 80, 0.3 * i - 24, 20])
const bent = ([x, y, z]) => [x, y + 40 * Math.sin(x / 20), z + 30 * Math.cos(x / 30)]
const bending = `({ glsl, position: { x } }) => glsl.vec3(0, x.div(20).sin().mult(40), x.div(30).cos().mult(30))`
const through = (points) =>
  `beginShape(); ${points.map((point) => `vertex(${point})`).join('; ')}; endShape()`

const bentStyle = 'noFill(); stroke(255)'
const bentStyles = {
  'round caps': 'strokeWeight(9)',
  'ends cut off': 'strokeWeight(14); strokeCap(SQUARE)',
  thin: 'strokeWeight(2)',
}

for (const [version, renderer, scripts] of p5HostsInThisRun) {
  const draw = (options) =>
    drawScenes(browsers[renderer], server, [...scripts, addon], { renderer, ...options })

  describe(`strokes on p5 ${version}, ${renderer},`, () => {
    test("follow a warp in the same way as p5's transforms, in each space", async () => {
      const setup = `
        word = ${JSON.stringify(word)}
        const turn = ${turned}
        warps.world = createWarp(turn, { space: 'world' })
        warps.camera = createWarp(({ glsl, position }) => {
          const moved = glsl.vec3(0, 0, 700)
          return turn({ glsl, position: position.add(moved) })
        }, { space: 'camera' })
        warps.local = createWarp(turn)`
      const scenes = {}
      for (const [name, { style, shape }] of Object.entries(shapes)) {
        scenes[`${name}, by p5`] = `${camera}; ${turn}; ${style}; ${shape}`
        for (const space of ['world', 'camera', 'local'])
          scenes[`${name}, in ${space} space`] = `${camera}; ${style}; warps.${space}(); ${shape}`
      }
      const images = await draw({ setup, scenes })
      for (const name of Object.keys(scenes)) {
        const byP5 = images[`${name.split(',')[0]}, by p5`]
        const lit = litPixels(byP5).length
        assert.ok(lit > 150, `${name}: ${lit} pixels`)
        const differing = differingPixels(images[name], byP5, 8)
        assert.equal(differing, 0, `${name}: ${differing} of ${lit} pixels differ`)
      }
    })

    test('bend with a warp like a line through the moved points', async () => {
      const scenes = {}
      for (const [name, style] of Object.entries(bentStyles)) {
        scenes[`${name}, by p5`] =
          `${camera}; ${bentStyle}; ${style}; ${through(straight.map(bent))}`
        for (const space of ['world', 'camera', 'local'])
          scenes[`${name}, in ${space} space`] =
            `${camera}; ${bentStyle}; ${style}; warps.${space}(); ${through(straight)}`
      }
      const setup = `
        const bend = ${bending}
        warps.world = createWarp(bend, { space: 'world' })
        warps.camera = createWarp(({ glsl, position }) => 
          bend({ glsl, position: position.add(glsl.vec3(0, 0, 700)) }), { space: 'camera' })
        warps.local = createWarp(bend)`
      const images = await draw({ setup, scenes })
      for (const name of Object.keys(scenes)) {
        const byP5 = images[`${name.split(',')[0]}, by p5`]
        const lit = litPixels(byP5).length
        assert.ok(lit > 150, `${name}: ${lit} pixels`)
        assert.equal(beyondEdges(images[name], byP5, 8), 0, name)
        // Chords approximate tangents, which antialiasing shows along the edges.
        const differing = differingPixels(images[name], byP5, 8)
        assert.ok(differing < 0.04 * lit, `${name}: ${differing} of ${lit} pixels differ`)
      }
    })

    test('depend on the sketch and the option `stroke`', async () => {
      const setup = `
        const still = ({ glsl }) => glsl.vec3(0, 0, 0)
        warps.left = createWarp(still)
        warps.on = createWarp(still, { stroke: true })
        warps.off = createWarp(still, { stroke: false })
        warps.normal = createWarp(({ normal }) => normal.mult(1e-6), { surfaceVariation: false })
        warps.uv = createWarp(({ uv, glsl }) => glsl.vec3(uv.x().mult(1e-6), 0, 0), { surfaceVariation: false })
        warps.refused = createWarp(({ uv, glsl }) => glsl.vec3(uv.x().mult(1e-6), 0, 0),
          { stroke: true, surfaceVariation: false })
        warps.away = createWarp(({ glsl }) => glsl.vec3(500, 0, 0), { space: 'world', stroke: true })
        fill(255, 0, 0)`
      const lines = `stroke(0, 0, 255); strokeWeight(10);`
      const scenes = {
        // p5's default is thin black lines.
        'a sketch that never sets a stroke': 'warps.left(); plane(100)',
        'the option': `strokeWeight(10); warps.on(); plane(100)`,
        'a sketch that sets a stroke before': `${lines} warps.left(); plane(100)`,
        'a sketch that sets a stroke afterwards': `warps.left(); ${lines} plane(100)`,
        'noStroke() before': `${lines} noStroke(); warps.on(); plane(100)`,
        'noStroke() after': `${lines} warps.on(); noStroke(); plane(100)`,
        'turned off': `${lines} warps.off(); plane(100)`,
        'an offset that depends on the normal': `${lines} warps.normal(); plane(100)`,
        'an offset that depends on uv': `${lines} warps.uv(); plane(100)`,
        'another shader': `${lines} warps.away(); shader(baseMaterialShader()); plane(100)`,
        resetShader: `${lines} warps.away(); resetShader(); plane(100)`,
        'after pop()': `${lines} push(); warps.away(); plane(100); pop(); plane(100)`,
        refused: `${lines} try { warps.refused() } catch ({ message }) {
          if (/lines have no normal, uv or fill/.test(message)) { noStroke(); fill(0, 255, 0); plane(100) } }`,
      }
      const expected = {
        'a sketch that never sets a stroke': 'red',
        'the option': 'black',
        'noStroke() before': 'red',
        'noStroke() after': 'red',
        'turned off': 'red',
        'an offset that depends on the normal': 'red',
        'an offset that depends on uv': 'red',
        refused: 'green',
      }
      const colors = { red: [255, 0, 0], blue: [0, 0, 255], black: [0, 0, 0], green: [0, 255, 0] }
      const images = await draw({ setup, scenes })
      for (const [name, image] of Object.entries(images))
        assert.deepEqual(colorAt(image, 52, 100), colors[expected[name] ?? 'blue'], name)
    })
  })
}
