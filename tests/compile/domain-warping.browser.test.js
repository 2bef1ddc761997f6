// Evaluates domain warping in the fragment shader, in a hook of p5's material shader, on each version of p5: compares numbers on the canvas
// with an oracle in double precision, and draws the sketches of the gallery.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { launchBrowser, leavePage } from '../support/browser/browser.js'
import { differingPixels, readPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { drawScenes, p5InThisRun, p5Versions, runSketch } from '../support/browser/sketch.js'
import { domainWarp, plainDomainWarp } from '../support/domain-warp.js'

const addon = '/dist/p5.warpjet.min.js'

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

const size = 32
const width = 1.3

/** Encodes a number from 0 to 1 in two 8-bit channels, the high and the low part. */
const numberShader = `(name) => {
  const { code, declarations } = warpjet.compile((glsl) => {
    const p = glsl.vec2Param('p')
    const { value } = domainWarp(glsl, p, 2)
    return { value, slope: glsl.gradient(value, p) }
  })
  return baseMaterialShader().modify({
    fragmentDeclarations: declarations,
    'Inputs getPixelInputs': \`(Inputs inputs) {
      vec2 p = \${(${width}).toFixed(3)} * inputs.texCoord;
      \${code}
      float number = 255.0 * (\${name});
      inputs.color = vec4(floor(number) / 255.0, fract(number), 0.0, 1.0);
      return inputs;
    }\`,
  })
}`

// Maps an expression of the shader → function that computes it from the oracle's result. Slopes reach 31 here, and change by up to 39,000
// per unit: rounding of the pixel's coordinates alone causes an error of 0.004, which is 6e-5 of the range of 64 that colors represent.
const numbers = {
  value: ({ value }) => value,
  'slope.x / 64.0 + 0.5': ({ slope }) => slope[0] / 64 + 0.5,
  'slope.y / 64.0 + 0.5': ({ slope }) => slope[1] / 64 + 0.5,
}

function oracle(p) {
  const value = (at) => plainDomainWarp(at, 2).value
  const difference = (axis, h) =>
    (value(p.with(axis, p[axis] + h)) - value(p.with(axis, p[axis] - h))) / (2 * h)
  const slope = (axis) => (4 * difference(axis, 1e-5) - difference(axis, 2e-5)) / 3
  return { value: value(p), slope: [slope(0), slope(1)] }
}

const expected = Array.from({ length: size * size }, (_, i) =>
  oracle([(i % size) + 0.5, Math.floor(i / size) + 0.5].map((x) => (width * x) / size)),
)

// In the default test run, gallery.test.js draws the other sketches.
const sketches = isRun('deep domain warping')
  ? ['domain-warping-2d', 'domain-warping-colours', 'domain-warping-lit', 'domain-warping-3d']
  : ['domain-warping-colours']

/** Returns the picture of a sketch of the gallery at `millis`. */
async function drawSketch(p5, name, millis) {
  const source = readFileSync(new URL(`../../examples/${name}/sketch.js`, import.meta.url), 'utf8')
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5, addon],
    `p5.prototype.millis = () => ${millis}
${source}
const [begin, paint] = [setup, draw]
window.setup = () => { begin(); noLoop() }
window.draw = () => { paint(); window.done = true }`,
  )
  const image = await readPixels(page)
  await leavePage(page)
  assert.deepEqual(messages, [])
  return image
}

const pictures = {}

for (const [version, p5] of p5InThisRun)
  describe(`domain warping on p5 ${version}`, () => {
    test('has the value and the gradient of the oracle in every pixel', async () => {
      const names = Object.keys(numbers)
      const images = await drawScenes(browser, server, [p5, addon], {
        size,
        setup: `${domainWarp}
          const shaderFor = ${numberShader}
          for (const name of ${JSON.stringify(names)}) warps[name] = shaderFor(name)`,
        scenes: Object.fromEntries(
          names.map((name) => [name, `noStroke(); shader(warps['${name}']); plane(width, height)`]),
        ),
      })
      for (const [name, number] of Object.entries(numbers)) {
        const errors = expected.map((truth, i) => {
          const [high, low] = images[name].data.subarray(4 * i, 4 * i + 2)
          return Math.abs((high + low / 255) / 255 - number(truth))
        })
        const worst = Math.max(...errors)
        const bound = name === 'value' ? 1e-4 : 2e-4
        assert.ok(worst < bound, `${name} is ${worst} off`)
      }
    })

    for (const name of sketches)
      test(`draws ${name}, and prints nothing`, async () => {
        const image = await drawSketch(p5, name, 4000)
        const colors = new Set()
        for (let i = 0; i < image.data.length; i += 4)
          colors.add(
            image.data
              .subarray(i, i + 3)
              .map((x) => x >> 3)
              .join(),
          )
        assert.ok(colors.size > 60, `only ${colors.size} colours`)
        pictures[name] ??= []
        pictures[name].push(image)
      })
  })

if (isRun('p5 1.11'))
  test('the sketches without light draw the same on both versions of p5', () => {
    for (const name of ['domain-warping-2d', 'domain-warping-colours'])
      assert.ok(differingPixels(...pictures[name], 4) < 300, name)
  })

test('the picture changes with time', async () => {
  const later = await drawSketch(p5Versions['2.x'], 'domain-warping-colours', 6000)
  assert.ok(differingPixels(pictures['domain-warping-colours'][0], later, 16) > 50_000)
})
