// exactNormals gives p5's own hooks and p5.strands exact normals: compares them with the same warp by createWarp.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5Versions, runSketch } from '../support/browser/sketch.js'

const scripts = [p5Versions['2.x'], '/dist/p5.warpjet.min.js', '/dist/warpjet.glsl.min.js']

const { browser, server } = await openHost()

/** Returns the code of a scene: a sphere with this shading. */
const scene = (shading) =>
  `noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); ${shading}; fill('coral'); rotateX(0.4); sphere(60, 48, 32)`

/** Code that defines atVertices(): createWarp() with normals at vertices, where exactNormals computes them. */
const defineAtVertices = `window.atVertices = (offset, options) => createWarp(offset, { ...options, normals: 'vertex' });
`

const wave = `atVertices(({ glsl, position }) =>
  glsl.vec3(position.y().mult(4).sin().mult(0.25), position.z().mult(3).cos().mult(0.125), 0))`

test('a hook in GLSL, a strands sketch with a loop and an if, and GLSL source each look like the same warp by createWarp', async () => {
  const images = await drawScenes(browser, server, scripts, {
    setup: `${defineAtVertices}
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
      warps.text = atVertices(glslOffset(\`uniform float amount;
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
  assert.ok(
    differingPixels(images.plain, images.byHand, 8) > 2000,
    'wrong light would not be detected',
  )
  for (const name of ['hook', 'strands', 'text'])
    assert.ok(
      differingPixels(images[name], images.byHand, 2) < 20,
      `${name}: ${differingPixels(images[name], images.byHand, 2)} pixels differ`,
    )
})

test('an integer uniform keeps all its bits, and p5 declares it as an integer', async () => {
  const text = `warpjet.glslOffset(\`uniform int n;
    vec3 offset(vec3 p) { return vec3(0.0, float(n % 1000) * 0.03125, 0.0); }\`)`
  const images = await drawScenes(browser, server, scripts, {
    setup: `${defineAtVertices}
      warps.whole = createWarp(${text}, { defs: 'uniform int n;' })
      warps.byHand = atVertices(({ glsl }) => glsl.vec3(0, 0.28125, 0))
      warps.still = atVertices(({ glsl }) => glsl.vec3(0, 0, 0))
      try {
        createWarp(${text})()
        throw new Error('no message')
      } catch ({ message }) {
        if (!message.includes('add the option { defs: "uniform int n;" }')) throw new Error(message)
      }`,
    scenes: {
      whole: scene('warps.whole({ n: 20000009 })'),
      byHand: scene('warps.byHand()'),
      still: scene('warps.still()'),
    },
  })
  assert.ok(
    differingPixels(images.still, images.byHand, 8) > 500,
    'a missing motion would not be detected',
  )
  assert.ok(differingPixels(images.whole, images.byHand, 2) < 20)
})

test("p5.strands in world and camera space, written as in p5's reference, looks like the same warp by createWarp", async () => {
  const shiftScene = (isStrands) =>
    isStrands
      ? `exactNormals(baseMaterialShader().modify(() => {
        getWorldInputs((inputs) => {
          inputs.position.y += 12 * sin(inputs.position.x * 0.0625 + inputs.position.z * 0.03125)
          return inputs
        })
      }))`
      : `atVertices(({ glsl, position: p }) => {
        const phase = p.x().mult(0.0625).add(p.z().mult(0.03125))
        return glsl.vec3(0, phase.sin().mult(12), 0)
      }, { space: 'world' })`
  const pullScene = (isStrands) =>
    isStrands
      ? `exactNormals(baseMaterialShader().modify(() => {
        getCameraInputs((inputs) => {
          const far = length(inputs.position.xy)
          inputs.position.z += 20 * sin(far * 0.0625)
          return inputs
        })
      }))`
      : `atVertices(({ glsl, position: p }) => {
        const far = p.xy().length()
        return glsl.vec3(0, 0, far.mult(0.0625).sin().mult(20))
      }, { space: 'camera' })`
  const images = await drawScenes(browser, server, scripts, {
    setup: `${defineAtVertices}
      warps.waves = ${shiftScene(true)}
      warps.wavesByHand = ${shiftScene(false)}
      warps.lens = ${pullScene(true)}
      warps.lensByHand = ${pullScene(false)}`,
    scenes: {
      waves: scene('shader(warps.waves)'),
      wavesByHand: scene('warps.wavesByHand()'),
      lens: scene('shader(warps.lens)'),
      lensByHand: scene('warps.lensByHand()'),
    },
  })
  for (const name of ['waves', 'lens']) {
    assert.ok(litPixels(images[name]).length > 5000, name)
    const differing = differingPixels(images[name], images[`${name}ByHand`], 2)
    assert.ok(differing < 20, `${name}: ${differing} pixels differ`)
  }
})

test("p5.strands written as in p5's reference and tutorials looks like the same warp by createWarp", async () => {
  const strands = (base, moves) => `exactNormals(${base}().modify(() => { ${moves} }))`
  // Maps a title to [a strands sketch, the same warp].
  const sketches = {
    'a flag in the wind, with millis()': [
      strands(
        'baseMaterialShader',
        `getWorldInputs((inputs) => {
          const t = millis()
          inputs.position.y += 14 * sin(t * 0.002 + inputs.position.x * 0.05)
          return inputs
        })`,
      ),
      `atVertices(({ glsl, position, millis }) =>
        glsl.vec3(0, millis.mult(0.002).add(position.x.mult(0.05)).sin().mult(14), 0), { space: 'world' })`,
    ],
    'jelly in camera space, with normalMaterial()': [
      strands(
        'baseNormalShader',
        `getCameraInputs((inputs) => {
          const t = millis() * 0.001
          inputs.position.x += 12 * sin(t + inputs.position.y * 0.06)
          inputs.position.y += 12 * cos(t + inputs.position.x * 0.04)
          return inputs
        })`,
      ),
      // The second line reads the result of the first.
      `atVertices(({ glsl, position, millis }) => {
        const t = millis.mult(0.001)
        const x = t.add(position.y.mult(0.06)).sin().mult(12)
        const y = t.add(position.x.add(x).mult(0.04)).cos().mult(12)
        return glsl.vec3(x, y, 0)
      }, { space: 'camera', type: 'normal' })`,
    ],
    'a ball that swells along its normal, with a uniform and a function': [
      strands(
        'baseMaterialShader',
        `const size = uniformFloat(() => 0.2)
        const pulse = (a) => sin(a * 5) * size
        getObjectInputs((inputs) => {
          inputs.position += inputs.position * pulse(inputs.position.y)
          return inputs
        })`,
      ),
      `atVertices(({ position, uniforms }) =>
        position.mult(position.y.mult(5).sin().mult(uniforms.swell)), { uniforms: { swell: 0.2 } })`,
    ],
    'a twist, with sines and an else': [
      strands(
        'baseMaterialShader',
        `getObjectInputs((inputs) => {
          let angle = 0
          if (inputs.position.y > 0) { angle = inputs.position.y * 1.5 } else { angle = inputs.position.y * 0.5 }
          const x = inputs.position.x
          const z = inputs.position.z
          inputs.position = [x * cos(angle) - z * sin(angle), inputs.position.y, x * sin(angle) + z * cos(angle)]
          return inputs
        })`,
      ),
      `atVertices(({ glsl, position }) => {
        const { x, y, z } = position
        const angle = y.gt(0).ifElse(y.mult(1.5), y.mult(0.5))
        const [c, s] = [angle.cos(), angle.sin()]
        return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c)))
      }, { returns: 'position' })`,
    ],
  }
  const entries = Object.entries(sketches)
  const images = await drawScenes(browser, server, scripts, {
    setup: `${defineAtVertices}p5.prototype.millis = () => 1700
      ${entries.map(([, [own, byHand]], i) => `warps.own${i} = ${own}\nwarps.byHand${i} = ${byHand}`).join('\n')}`,
    scenes: Object.fromEntries(
      entries.flatMap(([name], i) => [
        [name, scene(`shader(warps.own${i})`)],
        [`${name}, by hand`, scene(`warps.byHand${i}()`)],
      ]),
    ),
  })
  for (const [name] of entries) {
    assert.ok(litPixels(images[name]).length > 4000, name)
    const differing = differingPixels(images[name], images[`${name}, by hand`], 2)
    assert.ok(differing < 20, `${name}: ${differing} pixels differ`)
  }
})

test('p5 1.11: hooks in local and view space look like the same warp by createWarp', async () => {
  const oldScripts = [p5Versions['1.11'], ...scripts.slice(1)]
  const images = await drawScenes(browser, server, oldScripts, {
    setup: `${defineAtVertices}
      warps.byHand = ${wave}
      warps.plain = baseMaterialShader().modify({
        uniforms: { 'float amount': () => 0.25 },
        'vec3 getLocalPosition': \`(vec3 position) {
          return position + vec3(sin(position.y * 4.0) * amount, cos(position.z * 3.0) * 0.125, 0.0);
        }\`,
      })
      warps.hook = exactNormals(warps.plain)
      const bulge = 'position.z += 20.0 * sin(length(position.xy) * 0.0625); return position;'
      warps.view = exactNormals(baseMaterialShader().modify({
        'vec3 getWorldPosition': \`(vec3 position) { \${bulge} }\`,
      }))
      warps.viewByHand = atVertices(({ glsl, position: p }) =>
        glsl.vec3(0, 0, p.xy().length().mult(0.0625).sin().mult(20)), { space: 'camera' })
      warps.both = exactNormals(warps.plain.modify({
        'vec3 getWorldPosition': \`(vec3 position) { \${bulge} }\`,
      }))
      const own = warps.plain.modify({ 'vec3 getLocalNormal': '(vec3 normal) { return normal.zyx; }' })
      const warn = console.warn
      console.warn = (message) => (window.warning = message)
      window.isUnchanged = exactNormals(own) === own
      console.warn = warn
      if (!window.isUnchanged || !/hook getLocalNormal of its own/.test(window.warning))
        throw new Error('unexpected warning: ' + window.warning)`,
    scenes: {
      byHand: scene('warps.byHand()'),
      plain: scene('shader(warps.plain)'),
      hook: scene('shader(warps.hook)'),
      view: scene('shader(warps.view)'),
      viewByHand: scene('warps.viewByHand()'),
      both: scene('shader(warps.both)'),
    },
  })
  assert.ok(litPixels(images.byHand).length > 5000)
  assert.ok(litPixels(images.both).length > 5000)
  assert.ok(
    differingPixels(images.plain, images.byHand, 8) > 2000,
    'wrong light would not be detected',
  )
  assert.ok(differingPixels(images.both, images.byHand, 8) > 2000, 'only one hook moves vertices')
  for (const [name, expected] of [
    ['hook', 'byHand'],
    ['view', 'viewByHand'],
  ]) {
    const differing = differingPixels(images[name], images[expected], 2)
    assert.ok(differing < 20, `${name}: ${differing} pixels differ`)
  }
})

test('warns about unsupported hooks, and leaves the shader unchanged', async () => {
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
      window.isUnchanged = exactNormals(colours) === colours
      try { exactNormals({}) } catch (error) { window.message = error.message }
      window.done = true
    }`,
  )
  assert.equal(await page.evaluate('isSame'), true)
  assert.equal(await page.evaluate('isUnchanged'), true)
  assert.match(
    await page.evaluate('message'),
    /expected a shader of surfaces, such as .*, got an empty object/,
  )
  assert.equal(messages.length, 1, messages.join('; '))
  assert.match(messages[0], /the shader stays as it is.*attribute aSize/)
})

test('loops run until they end, or a message says where one is cut off', async () => {
  // The sum of sin(a + d i) over n terms is sin(d n / 2) / sin(d / 2) sin(a + d (n - 1) / 2).
  const [n, d] = [1000, 0.001]
  const height = 0.25 / (Math.sin((d * n) / 2) / Math.sin(d / 2))
  const term = `${height} * sin(4.0 * inputs.position.y + ${d} * i)`
  const hookOf = (loop) => `(Vertex inputs) {
    float sum = 0.0;
    ${loop}
    inputs.position.x += sum;
    return inputs;
  }`
  const looped = `for (float i = 0.0; i < count; i++) sum += ${term};`
  // Each element of the array is a number that the loop changes.
  const manyStates = `float all[40];
    for (int k = 0; k < 40; k++) all[k] = 0.0;
    for (float i = 0.0; i < count; i++) all[int(i) % 40] += ${term};
    for (int k = 0; k < 40; k++) sum += all[k];`
  const [all, withMessages] = await Promise.all([
    drawScenes(browser, server, scripts, {
      setup: `${defineAtVertices}
      const shaderOf = (hook) => baseMaterialShader().modify({
        uniforms: { 'float count': () => ${n} },
        'Vertex getObjectInputs': hook,
      })
      warps.byHand = atVertices(({ glsl, position }) =>
        glsl.vec3(position.y().mult(4).add(${(d * (n - 1)) / 2}).sin().mult(0.25), 0, 0))
      warps.plain = shaderOf(\`${hookOf(looped)}\`)
      warps.looped = exactNormals(warps.plain)
      warps.limited = exactNormals(warps.plain, { maxIterations: 300 })`,
      scenes: {
        byHand: scene('warps.byHand()'),
        plain: scene('shader(warps.plain)'),
        looped: scene('shader(warps.looped)'),
        limited: scene('shader(warps.limited)'),
      },
    }),
    runSketch(
      browser,
      server,
      scripts,
      `function setup() {
        createCanvas(50, 50, WEBGL)
        const makeShader = () => baseMaterialShader().modify({
          uniforms: { 'float count': () => ${n} },
          'Vertex getObjectInputs': \`${hookOf(manyStates)}\`,
        })
        exactNormals(makeShader())
        exactNormals(makeShader(), { maxIterations: 100 })
        try { exactNormals(makeShader(), { maxIterations: 4097 }) } catch (error) { window.message = error.message }
        window.done = true
      }`,
    ),
  ])
  const difference = (name) => differingPixels(all[name], all.byHand, 2)
  assert.ok(difference('plain') > 2000, 'wrong light would not be detected')
  assert.ok(difference('limited') > 500, `${difference('limited')} pixels differ`)
  assert.ok(difference('looped') < 20, `${difference('looped')} pixels differ`)
  const { page, messages } = withMessages
  assert.equal(messages.length, 1, messages.join('; '))
  assert.match(
    messages[0],
    /exactNormals: getObjectInputs has normals as if a loop ended early: line \d+, column \d+: only the shader knows .* after 256 iterations; [^]*\n\s+for \(float i = 0\.0; i < count; i\+\+\) all/,
  )
  assert.match(
    await page.evaluate('message'),
    /exactNormals: expected a whole number from 1 to 4096 for the option "maxIterations", got the number 4097/,
  )
})
