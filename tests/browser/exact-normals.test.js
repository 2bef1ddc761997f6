// exactNormals: p5's own hooks and p5.strands with right light, beside the same warp by createWarp.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowser } from './support/browser.js'
import { differingPixels, litPixels } from './support/pixels.js'
import { servePages } from './support/server.js'
import { drawScenes, p5Versions, runSketch } from './support/sketch.js'

const scripts = [p5Versions['2.x'], '/dist/p5.warpjet.min.js', '/dist/warpjet.glsl.min.js']

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

/** What each scene draws. */
const scene = (shading) =>
  `noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); ${shading}; fill('coral'); rotateX(0.4); sphere(60, 48, 32)`

const wave = `createWarp(({ glsl, position }) =>
  glsl.vec3(position.y().mult(4).sin().mult(0.25), position.z().mult(3).cos().mult(0.125), 0))`

test('a hook in GLSL, a strands sketch with a loop and an if, and a text, each as the same warp by hand', async () => {
  const images = await drawScenes(browser, server, scripts, {
    setup: `
      warps.byHand = ${wave}
      warps.plain = baseMaterialShader().modify({
        uniforms: { 'float amount': () => 0.25 },
        vertexDeclarations: 'const float less = 0.125;',
        'float wave': '(float x) { return sin(x * 4.0) * amount; }',
        'Vertex getObjectInputs': \`(Vertex inputs) {
          inputs.position += vec3(wave(inputs.position.y), cos(inputs.position.z * 3.0) * less, 0.0);
          return inputs;
        }\`,
      })
      warps.hook = exactNormals(warps.plain)
      warps.strands = exactNormals(baseMaterialShader().modify(() => {
        const amount = uniformFloat(() => 0.25)
        getObjectInputs((inputs) => {
          let x = inputs.position.x
          let y = inputs.position.y
          if (y > -100) { x += sin(y * 4) * amount } else { x -= 5 }
          let extra = 0
          for (let i = 0; i < 2; i++) { extra += cos(inputs.position.z * 3) * 0.0625 }
          inputs.position = [x, y + extra, inputs.position.z]
          return inputs
        })
      }))
      const { glslOffset } = warpjet
      warps.text = createWarp(glslOffset(\`uniform float amount;
        vec3 offset(vec3 p) { return vec3(sin(p.y * 4.0) * amount, cos(p.z * 3.0) * 0.125, 0.0); }\`),
        { uniforms: { amount: 0.25 } })`,
    scenes: {
      byHand: scene('warps.byHand()'),
      plain: scene('shader(warps.plain)'),
      hook: scene('shader(warps.hook)'),
      strands: scene('shader(warps.strands)'),
      text: scene('warps.text()'),
    },
  })
  assert.ok(litPixels(images.byHand).length > 5000)
  assert.ok(differingPixels(images.plain, images.byHand, 8) > 2000, 'wrong light would show')
  for (const name of ['hook', 'strands', 'text'])
    assert.ok(
      differingPixels(images[name], images.byHand, 2) < 20,
      `${name}: ${differingPixels(images[name], images.byHand, 2)} pixels differ`,
    )
})

test('what cannot be is told, and the shader stays as it was', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    scripts,
    `function setup() {
      createCanvas(50, 50, WEBGL)
      const sized = baseMaterialShader().modify({
        vertexDeclarations: 'in float aSize;',
        'Vertex getObjectInputs': '(Vertex inputs) { inputs.position *= aSize; return inputs; }',
      })
      window.isSame = exactNormals(sized) === sized
      const colours = baseMaterialShader().modify({
        'Vertex getObjectInputs': '(Vertex inputs) { inputs.color = vec4(1.0); return inputs; }',
      })
      window.isLeft = exactNormals(colours) === colours
      try { exactNormals({}) } catch (error) { window.message = error.message }
      window.done = true
    }`,
  )
  assert.equal(await page.evaluate('isSame'), true)
  assert.equal(await page.evaluate('isLeft'), true)
  assert.match(await page.evaluate('message'), /a shader was expected/)
  assert.equal(messages.length, 1, messages.join('; '))
  assert.match(messages[0], /the shader stays as it is.*attribute aSize/)
})
