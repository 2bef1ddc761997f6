// createWarp on a WebGPU canvas must draw the same pictures as on WebGL, which other tests check. p5.browser.test.js and
// inputs.browser.test.js test materials, spaces, inputs and uniforms on each host.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as deformers from '../../dist/deformers.js'
import { leavePage } from '../support/browser/browser.js'
import { beyondEdges, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5Versions, p5WebGPU, runSketch } from '../support/browser/sketch.js'
import { warps as listings } from '../warps/listings.js'
import { stress } from '../warps/stress.js'

const p5 = p5Versions['2.x']
const scripts = ['/dist/p5.warpjet.min.js', '/dist/warpjet.deformers.min.js']

const { browser, server } = await openHost('WEBGPU')

/** Draws scenes with both renderers, and compares the pictures. No scene has highlights, which p5 itself draws differently. */
async function compare({ setup, scenes, tolerance = 6, share = 0.005 }) {
  const images = {}
  for (const [renderer, more] of Object.entries({ WEBGL: [], WEBGPU: [p5WebGPU] }))
    images[renderer] = await drawScenes(browser, server, [p5, ...more, ...scripts], {
      setup,
      scenes,
      renderer,
    })
  for (const name of Object.keys(scenes)) {
    const lit = litPixels(images.WEBGL[name]).length
    assert.ok(lit > 400, `${name}: ${lit} pixels are lit`)
    const beyond = beyondEdges(images.WEBGPU[name], images.WEBGL[name], tolerance)
    assert.ok(beyond <= 5 + share * lit, `${name}: ${beyond} of ${lit} pixels differ`)
  }
  return images.WEBGPU
}

const wave = `({ glsl, position }) => glsl.vec3(
  position.y().mult(2.4).add(1).sin().mult(0.15), position.z().mult(3.2).sin().mult(0.11), 0)`

describe('createWarp on WEBGPU looks as in WEBGL', () => {
  test("with images and the sketch's WGSL", async () => {
    const world = `space: 'world'`
    await compare({
      setup: `
        const heights = createImage(16, 16)
        for (let y = 0; y < 16; y++)
          for (let x = 0; x < 16; x++) heights.set(x, y, color(128 + 100 * sin(x * 0.7) * cos(y)))
        heights.updatePixels()
        warps.map = createWarp(({ glsl, uv, uniforms }) =>
          glsl.vec3(0, 0, glsl.texture(uniforms.map, uv, { filter: 'bicubic' }).x().mult(40)),
          { ${world}, uniforms: { map: heights }, surfaceVariation: false })
        warps.declared = createWarp(({ glsl }) =>
          glsl.vec3(glsl.param('a').add(glsl.vec2Param('v').y), glsl.mat3Param('m').mult(glsl.vec3(0, 1, 0)).x, 0),
          { ${world}, defs: 'uniform float a, unread; uniform highp vec2 v;\\nuniform mat3 m;' })
        warps.relief = createWarp(({ glsl, position }) =>
          glsl.vec3(0, 0, glsl.texture('map', position.xy.div(120).add(0.5), { filter: 'bicubic' }).x.mult(40)),
          { ${world}, defs: 'uniform sampler2D map;' })
        window.heights = heights
        warps.called = createWarp(({ glsl }) => glsl.vec3(glsl.param('lifted(1.5)'), glsl.param('a'), 0), { ${world},
          defs: 'uniform float a;\\n' + (document.querySelector('canvas').getContext('webgpu')
            ? 'fn lifted(x: f32) -> f32 { return 10.0 * x; }'
            : 'float lifted(float x) { return 10.0 * x; }') })`,
      scenes: {
        'uniforms of defs': `warps.declared({ a: 5, unread: 3, v: createVector(0, 10), m: [0, 1, 0, -10, 0, 0, 0, 0, 1] }); fill('red'); plane(60)`,
        'one of the uniforms of defs unchanged': `warps.declared({ a: -20 }); fill('red'); plane(60)`,
        'an image of defs': `lights(); rotateX(0.6); warps.relief({ map: heights }); fill('white'); plane(120, 120, 60, 60)`,
        'a function of defs': `warps.called({ a: 12 }); fill('red'); plane(60)`,
        image: `lights(); rotateX(0.6); warps.map(); fill('white'); plane(120, 120, 60, 60)`,
      },
    })
  })

  test('with each deformer and composition', async () => {
    const composing = ['add', 'blend', 'chain', 'inSpace', 'mask']
    const names = Object.keys(deformers).filter((name) => !composing.includes(name))
    assert.equal(names.length, 13)
    await compare({
      setup: `
        const { chain, blend, twist, bend } = warpjet
        const options = { space: 'world', surfaceVariation: false }
        const still = (warp) => (inputs) => warp({ ...inputs, millis: inputs.glsl.val(1234) })
        for (const name of ${JSON.stringify(names)}) warps[name] = createWarp(still(warpjet[name]()), options)
        warps.chain = createWarp(chain(twist({ length: 200, angle: 1 }), bend({ from: -60, to: 60, angle: 1 })), options)`,
      scenes: Object.fromEntries(
        [...names, 'chain'].map((name) => [
          name,
          `lights(); warps['${name}'](); fill('coral'); sphere(50, 60, 40)`,
        ]),
      ),
      tolerance: 10,
    })
  })

  test('with compositions of each kind of warp, also nested', async () => {
    const compositions = {
      'add of a deformer and an offset function': 'add(turn, own)',
      'blend with a number': 'blend(turn, own, 0.4)',
      'blend with a weight that depends on the position': 'blend(turn, own, above)',
      'mask with a weight that depends on the position': 'mask(turn, above)',
      'inSpace with a translation': 'inSpace(aside, turn)',
      'inSpace of a uniform': 'inSpace(({ uniforms }) => uniforms.aside, turn)',
      'inSpace with a rotation': 'inSpace(({ glsl }) => glsl.rotateZ(0.5), swing)',
      'add of a mask and a space': 'add(mask(turn, above), inSpace(aside, swing))',
      'blend of chains': 'blend(chain(turn, swing), chain(swing, turn), above)',
      'mask in a chain': 'chain(mask(turn, above), inSpace(aside, swing), own)',
      'inSpace of a blend': 'inSpace(aside, blend(turn, swing, 0.5))',
    }
    const images = await compare({
      setup: `
        const { add, bend, blend, chain, inSpace, mask, twist } = warpjet
        const aside = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 25, 10, 0, 1]
        const turn = twist({ length: 150, angle: 1.4 })
        const swing = bend({ from: -60, to: 60, angle: 1 })
        const own = ({ glsl, position }) => glsl.vec3(0, 0, position.x.mult(0.05).sin().mult(12))
        const above = ({ glsl, position }) => glsl.smoothstep(25, -25, position.y)
        ${Object.entries(compositions)
          .map(
            ([name, code]) =>
              `warps['${name}'] = createWarp(${code}, { space: 'world', type: 'normal', uniforms: { aside } })`,
          )
          .join('\n')}`,
      scenes: Object.fromEntries(
        Object.keys(compositions).map((name) => [
          name,
          `rotateY(0.5); warps['${name}'](); ellipsoid(40, 60, 28, 60, 40)`,
        ]),
      ),
      tolerance: 10,
    })
    const different = new Set(Object.values(images).map(({ data }) => data.toString('base64')))
    assert.equal(different.size, Object.keys(compositions).length)
  })

  test('with the examples in the documentation of p5.warp', async () => {
    const names = Object.keys(listings).filter((name) => /of p5\.warp/.test(name))
    assert.equal(names.length, 3)
    await compare({
      setup: `
        const { warps: listings } = await import('/tests/warps/listings.js')
        for (const name of ${JSON.stringify(names)}) {
          const { warp, size } = listings[name]
          const still = (inputs) => warp({ ...inputs, millis: inputs.glsl.val(1234) })
          for (const type of ['specular', 'normal'])
            warps[name + type] = createWarp(still, { space: size === 1 ? 'local' : 'world', type })
        }`,
      scenes: Object.fromEntries(
        names.flatMap((name) =>
          ['specular', 'normal'].map((type) => [
            `${name}, ${type}`,
            `camera(900, -300, 2220, 0, 0, 0, 0, 1, 0); lights(); warps['${name}${type}'](); fill('coral'); sphere(180, 60, 40)`,
          ]),
        ),
      ),
      tolerance: 12,
      share: 0.02,
    })
  })

  test('beside a p5.Graphics on WEBGL, since p5 has no p5.Graphics on WEBGPU', async () => {
    await compare({
      setup: `
        const layer = createGraphics(120, 120, WEBGL)
        layer.pixelDensity(1)
        const inside = layer.createWarp(${wave})
        warps.main = createWarp(${wave})
        warps.layer = () => {
          layer.background(0); layer.noStroke(); layer.lights()
          inside(); layer.fill('teal'); layer.sphere(40)
          image(layer, -90, -60)
        }`,
      scenes: {
        both: `warps.layer(); translate(50, 0); lights(); warps.main(); fill('coral'); sphere(40)`,
      },
    })
  })

  test("with p5.warp's stress test", async () => {
    await compare({
      setup: `
        const { stress } = await import('/tests/warps/stress.js')
        warps.all = stress.map(({ warp, size }) => {
          const still = (inputs) => warp({ ...inputs, millis: inputs.glsl.val(1234) })
          return createWarp(still, { space: size === 1 ? 'local' : 'world' })
        })`,
      scenes: Object.fromEntries(
        stress.map(({ name }, i) => [
          name,
          `camera(300, -100, 740, 0, 0, 0, 0, 1, 0); lights(); warps.all[${i}](); fill('coral'); sphere(60, 60, 40)`,
        ]),
      ),
      tolerance: 12,
      // Rotations far from their axis differ visibly if the drivers' sines differ in precision.
      share: 0.02,
    })
  })
})

test('a mistake in the WGSL of defs is reported with its line in defs and in the sketch', async () => {
  const { page } = await runSketch(
    browser,
    server,
    [p5, p5WebGPU, ...scripts],
    `p5.disableFriendlyErrors = true
    const reported = []
    addEventListener('unhandledrejection', (event) => {
      reported.push([event.reason.name, event.reason.message])
      window.done = true
    })
    const shift = ({ glsl }) => glsl.vec3(glsl.param('twice(1.0)'), 0, 0)
    async function setup() {
      await createCanvas(100, 100, WEBGPU)
      noLoop()
      createWarp(shift, { defs: 'uniform float a;\\nfn twice(x: f32) -> f32 {\\n  return 2.0 * x; }' })
      createWarp(shift, { defs: 'uniform float a;\\nfn twice(x: f32) -> f32 {\\n  return 2.0 * y; }' })
      createWarp(shift, { defs: 'fn twice(x: f32) -> f32 { return 2.0 * x' })
    }`,
  )
  await page.waitForFunction('reported.length >= 2')
  const reported = await page.evaluate('reported')
  await leavePage(page)
  const plain = ([name, message]) => [name, message.replace(/ \(\S+, line \d+\)$/, '')]
  assert.deepEqual(reported.map(plain), [
    [
      'WarpError',
      `createWarp: the option "defs" has a mistake in its line 3, "return 2.0 * y; }": unresolved value 'y'.`,
    ],
    [
      'WarpError',
      `createWarp: the option "defs" has a mistake in its line 1, "fn twice(x: f32) -> f32 { return 2.0 * x": expected ';' for return statement.`,
    ],
  ])
  const [first, second] = reported.map(([, message]) => +/, line (\d+)\)$/.exec(message)[1])
  assert.equal(second - first, 1)
})

/** Tests whether pictures of a scene differ by more than their edges. */
const differs = (images, name) =>
  beyondEdges(images.WEBGPU[name], images.WEBGL[name], 12) >
  0.05 * litPixels(images.WEBGL[name]).length

test('p5 itself still draws ortho(), two lights and highlights differently on WEBGPU', async () => {
  const wide = 'ortho(-100, 100, -100, 100, -1000, 1000)'
  const ball = 'noStroke(); fill(200); sphere(60)'
  const scenes = {
    'ortho()': `ortho(); lights(); translate(0, 0, 300); ${ball}`,
    'ortho() around the eye': `${wide}; lights(); translate(0, 0, 300); ${ball}`,
    'two lights': `directionalLight(200, 0, 0, 1, 0, -1); directionalLight(0, 0, 200, -1, 0, -1); ${ball}`,
    'one light': `directionalLight(200, 0, 0, 1, 0, -1); ${ball}`,
    highlights: `directionalLight(90, 90, 90, 0, 0, -1); specularMaterial(255); shininess(2); ${ball}`,
  }
  const images = {}
  for (const [renderer, more] of Object.entries({ WEBGL: [], WEBGPU: [p5WebGPU] }))
    images[renderer] = await drawScenes(browser, server, [p5, ...more], { scenes, renderer })
  const differing = Object.keys(scenes).filter((name) => differs(images, name))
  assert.deepEqual(differing, ['ortho()', 'two lights', 'highlights'])
})

test('p5 itself still fails with GLSL and text models on WEBGPU', async () => {
  const font = '/node_modules/@fontsource/fredoka/files/fredoka-latin-700-normal.woff'
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5, p5WebGPU],
    `const outcomes = {}
    const attempt = (name, draw) => { try { draw(); outcomes[name] = 'drawn' } catch ({ message }) { outcomes[name] = message } }
    async function setup() {
      await createCanvas(100, 100, WEBGPU)
      noLoop()
      const old = createShader('#version 300 es\\nvoid main() {}', '#version 300 es\\nvoid main() {}')
      attempt('GLSL', () => { shader(old); sphere(10) })
      const word = (await loadFont('${font}')).textToModel('w', 0, 0, { extrude: 5, sampleFactor: 1 })
      resetShader()
      attempt('without uvs', () => model(word))
      word.uvs = word.vertices.flatMap(() => [0, 0])
      word.gid += ' with uvs'
      attempt('with uvs', () => model(word))
      done = true
    }`,
  )
  const outcomes = await page.evaluate('outcomes')
  await leavePage(page)
  assert.match(outcomes.GLSL ?? messages.join('\n'), /main/)
  assert.match(outcomes['without uvs'], /flat is not a function/)
  assert.equal(outcomes['with uvs'], 'drawn')
  assert.ok(
    messages.every((message) => /WGSL|#version/.test(message)),
    messages.join('\n'),
  )
})

test('p5 itself draws into a HALF_FLOAT framebuffer, but not into a FLOAT one, with or without antialiasing', async () => {
  const messagesByOptions = {}
  for (const options of [
    'format: HALF_FLOAT',
    'format: FLOAT',
    'format: FLOAT, antialias: false',
  ]) {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5, p5WebGPU],
      `async function setup() {
        await createCanvas(100, 100, WEBGPU)
        noLoop()
        createFramebuffer({ ${options} }).draw(() => sphere(10))
        await get(0, 0)
        done = true
      }`,
    )
    await leavePage(page)
    messagesByOptions[options] = messages.join('\n')
  }
  assert.equal(messagesByOptions['format: HALF_FLOAT'], '')
  assert.match(messagesByOptions['format: FLOAT'], /RGBA32Float\) does not support multisampling/)
  assert.match(
    messagesByOptions['format: FLOAT, antialias: false'],
    /RGBA32Float\) is not blendable/,
  )
})
