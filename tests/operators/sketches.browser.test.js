// Tests typical p5 sketches with the script of operators: each draws the same picture as its version with methods, on a page without that
// script, or prints a message with advice. Each sketch runs on its own page, since the variables around its functions matter.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { launchBrowser, leavePage } from '../support/browser/browser.js'
import { differingPixels, litPixels, readPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { drawScenes, p5InThisRun, runSketch } from '../support/browser/sketch.js'
import { sketches as conditions } from './sketches/conditions.js'
import { sketches as functions } from './sketches/functions.js'
import { sketches as helpers } from './sketches/helpers.js'
import { sketches as names } from './sketches/names.js'
import { sketches as others } from './sketches/others.js'

const warpjet = '/dist/p5.warpjet.min.js'
const operators = '/dist/warpjet.operators.min.js'
const allSketches = Object.entries({
  ...helpers,
  ...names,
  ...functions,
  ...conditions,
  ...others,
})
/** Returns each `step`-th sketch. A page takes more than half a second of a core. */
const pickEvery = (step) => allSketches.filter((_, i) => i % step === 0)
const sketches = pickEvery(isRun('every sketch') ? 1 : 10)

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

const clock = 'p5.prototype.millis = () => 1700'

/**
 * Returns the source of a sketch, which has either `source` or the parts `top` and `setup`. Its `error` or `warning` matches the message
 * that it prints, and `twin` is the same offset function with methods.
 */
const sketchSource = ({ source, top = '', setup }) =>
  `${clock}
${
  source ??
  `let wave
${top}
function setup() {
  createCanvas(100, 100, WEBGL)
  noLoop()
  ${setup}
}
function draw() {
  background(0); lights(); noStroke(); fill('coral'); wave(); sphere(40)
  window.done = true
}`
}`

/** Runs a sketch on a page; returns its picture and all console messages. */
async function run(scripts, sketch) {
  const { page, messages } = await runSketch(browser, server, scripts, sketchSource(sketch))
  const image = (await page.$('canvas')) && (await readPixels(page))
  await leavePage(page)
  return { image, messages }
}

/** Draws the versions with methods, and the sphere without a warp as `plain`, on one page. Returns the pictures by name. */
function drawTwins(p5) {
  const twins = sketches.filter(([, { twin }]) => twin)
  const draw = (call) => `lights(); noStroke(); fill('coral'); ${call} sphere(40)`
  const warpOf = (name) => `warps[${JSON.stringify(name)}]`
  return drawScenes(browser, server, [p5, warpjet], {
    size: 100,
    setup: [
      clock,
      ...twins.map(([name, { twin }]) => `${warpOf(name)} = createWarp(${twin})`),
    ].join('\n'),
    scenes: {
      plain: draw(''),
      ...Object.fromEntries(twins.map(([name]) => [name, draw(`${warpOf(name)}();`)])),
    },
  })
}

test('there are at least sixty sketches', () => assert.ok(allSketches.length >= 60))

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: each sketch draws the same picture as with methods, or has a message`, async () => {
    const pictures = await drawTwins(p5)
    const problems = []
    for (const [name, sketch] of sketches) {
      const { image, messages } = await run([p5, warpjet, operators], sketch)
      const expected = sketch.error ?? sketch.warning
      const isAsExpected = expected
        ? messages.some((message) =>
            expected.test(
              message.replace(/^uncaught: (WarpError: )?|^.*?(?=createWarp:|noise:|v\.mult)/, ''),
            ),
          )
        : !messages.length
      if (!isAsExpected) problems.push(`${name}: it printed ${JSON.stringify(messages)}`)
      if (!sketch.twin) continue
      const twin = pictures[name]
      const differing = image ? differingPixels(image, twin, 4) : 'all'
      const moved = differingPixels(twin, pictures.plain, 4)
      const lit = litPixels(twin).length
      if (!(differing < 5 && moved > 150 && lit > 1000))
        problems.push(
          `${name}: ${differing} pixels differ, the warp changes ${moved}, ${lit} are lit`,
        )
    }
    assert.deepEqual(problems, [])
  })

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version} without the script of operators: each sketch draws the same picture, or has a message of warpjet`, async () => {
    const pictures = await drawTwins(p5)
    const problems = []
    // Messages do not depend on the version of p5.
    for (const [name, sketch] of version === '1.11' ? pickEvery(4) : sketches) {
      const { image, messages } = await run([p5, warpjet], sketch)
      if (messages.some((message) => /WarpError|warpjet|createWarp: |; write /.test(message)))
        continue
      if (messages.length) problems.push(`${name}: it printed ${JSON.stringify(messages)}`)
      else if (!sketch.twin)
        problems.push(
          `${name}: expected a message, since there is no version with methods, got none`,
        )
      else {
        const differing = image ? differingPixels(image, pictures[name], 4) : 'all'
        if (!(differing < 5)) problems.push(`${name}: ${differing} pixels differ`)
      }
    }
    assert.deepEqual(problems, [])
  })
