// Lines, wireframes and points under a warp, against p5's own `rotate`: the oracle is the host's own transformation.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { colorAt, differingPixels, litPixels } from './support/pixels.js'
import { servePages } from './support/server.js'
import { drawScenes, launchFor, p5HostsInThisRun } from './support/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

let browsers, server
before(async () => {
  server = await servePages()
  browsers = await launchFor(p5HostsInThisRun)
})
after(async () => {
  for (const browser of Object.values(browsers)) await browser.close()
  await server.close()
})

/** Twice the same turn: by p5, and as an offset. */
const turn = 'rotateZ(0.6); rotateX(0.5)'
const turned = `({ glsl, position }) =>
  glsl.rotateZ(0.6).mult(glsl.rotateX(0.5)).mult(position).sub(position)`

/** With what pop() does not bring back. */
const camera = 'camera(0, 0, 700, 0, 0, 0, 0, 1, 0); strokeJoin(ROUND); strokeCap(ROUND)'

/** What is drawn, after the turn. */
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
  points: {
    style: 'stroke(255); strokeWeight(11)',
    shape: 'point(-40, 20, 30); point(50, 0, -30)',
  },
}

for (const [version, renderer, scripts] of p5HostsInThisRun) {
  const draw = (options) =>
    drawScenes(browsers[renderer], server, [...scripts, addon], { renderer, ...options })

  describe(`strokes on p5 ${version} by ${renderer}`, () => {
    test('follow a warp as they follow p5, in each space', async () => {
      const setup = `
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

    test('are as the sketch and the option `stroke` say', async () => {
      const setup = `
        const still = ({ glsl }) => glsl.vec3(0, 0, 0)
        warps.left = createWarp(still)
        warps.on = createWarp(still, { stroke: true })
        warps.off = createWarp(still, { stroke: false })
        warps.normal = createWarp(({ normal }) => normal.mult(1e-6), { surfaceVariation: false })
        warps.refused = createWarp(({ uv, glsl }) => glsl.vec3(uv.x().mult(1e-6), 0, 0),
          { stroke: true, surfaceVariation: false })
        warps.away = createWarp(({ glsl }) => glsl.vec3(500, 0, 0), { space: 'world', stroke: true })
        fill(255, 0, 0)`
      const lines = `stroke(0, 0, 255); strokeWeight(10);`
      const scenes = {
        // p5 begins with thin black lines.
        'a sketch that never asked': 'warps.left(); plane(100)',
        'the option': `strokeWeight(10); warps.on(); plane(100)`,
        'a sketch that asked': `${lines} warps.left(); plane(100)`,
        'one that asks afterwards': `warps.left(); ${lines} plane(100)`,
        'noStroke() before': `${lines} noStroke(); warps.on(); plane(100)`,
        'noStroke() after': `${lines} warps.on(); noStroke(); plane(100)`,
        'turned off': `${lines} warps.off(); plane(100)`,
        'an offset by normal': `${lines} warps.normal(); plane(100)`,
        'another shader': `${lines} warps.away(); shader(baseMaterialShader()); plane(100)`,
        resetShader: `${lines} warps.away(); resetShader(); plane(100)`,
        'after pop()': `${lines} push(); warps.away(); plane(100); pop(); plane(100)`,
        refused: `${lines} try { warps.refused() } catch ({ message }) {
          if (/lines have no normal, uv or fill/.test(message)) { noStroke(); fill(0, 255, 0); plane(100) } }`,
      }
      const expected = {
        'a sketch that never asked': 'red',
        'the option': 'black',
        'noStroke() before': 'red',
        'noStroke() after': 'red',
        'turned off': 'red',
        'an offset by normal': 'red',
        refused: 'green',
      }
      const colors = { red: [255, 0, 0], blue: [0, 0, 255], black: [0, 0, 0], green: [0, 255, 0] }
      const images = await draw({ setup, scenes })
      for (const [name, image] of Object.entries(images))
        assert.deepEqual(colorAt(image, 52, 100), colors[expected[name] ?? 'blue'], name)
    })
  })
}
