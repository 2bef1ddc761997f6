// Common mistakes in first sketches: checks each message and the line that it names.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { openHosts, p5HostsInThisRun, p5InThisRun, runSketch } from '../support/browser/sketch.js'

const { browsers, server } = await openHosts(p5HostsInThisRun)
const browser = browsers.WEBGL

/** The beginning of setup(), up to the call that makes the canvas. */
const setupOf = (renderer) =>
  renderer === 'WEBGPU' ? 'async function setup() { await' : 'function setup() {'

for (const [version, renderer, scripts] of p5HostsInThisRun)
  test(`p5 ${version}, ${renderer}: a warp made in every frame warns once, and a message names a missing script`, async () => {
    const { page, messages } = await runSketch(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      `let said
    try { const { twist } = warpjet } catch (error) { said = [error.name, error.message.replace(/ \\(\\S+, line \\d+\\)$/, '')] }
    ${setupOf(renderer)} createCanvas(20, 20, ${renderer}); noStroke(); isReady = true }
    function draw() {
      if (!window.isReady) return
      createWarp(({ glsl }) => glsl.vec3(1, 0, 0))()
      if (frameCount === 8) { noLoop(); window.done = true }
    }`,
    )
    assert.deepEqual(await page.evaluate('said'), [
      'WarpError',
      'warpjet.twist: no script of this page has it; add the script warpjet.deformers.min.js after p5.warpjet.min.js.',
    ])
    await leavePage(page)
    assert.deepEqual(messages, [
      'createWarp: each call makes a new shader, which is slow in every frame; call it once, in setup(), and in draw() call the function that it returned.',
    ])
  })

const ownOperators =
  "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin(), or add the script warpjet.operators.min.js or import 'warpjet/operators', with which they do."

/** Bodies of offset functions: an expression to return or, in braces, statements. */
const offsets = {
  5: 'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the number 5.',
  'glsl.vec3(position.sine(), 0, 0)': 'sine: an expression has no such method; did you mean sin?',
  'position.rotateY(1)':
    'rotateY: a rotation is a matrix, and its product with a vertex is the new position, not the offset; write glsl.rotateY(angle).mult(v).sub(v).',
  'glsl.vec3(position.y.squareRoot(), 0, 0)':
    'squareRoot: an expression has no such method; did you mean sqrt?',
  'position.multply(2)': 'multply: an expression has no such method; did you mean multiply?',
  'position.normalise()': 'normalise: an expression has no such method; did you mean normalize?',
  'glsl.vec3(position.y.smoothStep(0, 1), 0, 0)':
    'smoothStep: an expression has no such method; did you mean glsl.smoothstep(low, high, x)?',
  'glsl.vec3(position.x.toFixed(2), 0, 0)':
    'toFixed: an expression has no such method; did you mean round?',
  'position.map((x) => x)':
    'map: an expression has no such method; did you mean x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow)?',
  'glsl.vec33(1, 2, 3)': 'glsl.vec33: there is no such function; did you mean vec3?',
  'glsl.Vec3(1, 2, 3)': 'glsl.Vec3: there is no such function; did you mean vec3?',
  'glsl.vector(1, 2, 3)': 'glsl.vector: there is no such function; did you mean vec3?',
  'glsl.rotate_y(1)': 'glsl.rotate_y: there is no such function; did you mean rotateY?',
  'glsl.time':
    'glsl.time: there is no such function; did you mean millis, as in ({ glsl, millis }) => …?',
  '(({ postion }) => postion)(inputs)':
    'An offset function gets no "postion"; did you mean position?',
  '(({ normals }) => normals)(inputs)':
    'An offset function gets no "normals"; did you mean normal?',
  '(({ time }) => time)(inputs)': 'An offset function gets no "time"; did you mean millis?',
  '(({ texCoord }) => texCoord)(inputs)': 'An offset function gets no "texCoord"; did you mean uv?',
  'glsl.vec3(inputs.uniforms.amount, 0, 0)':
    'createWarp: the offset reads uniforms.amount, which nothing declares; add the option { uniforms: { amount: 0.5 } }.',
  'glsl.vec3(position.y * 4, 0, 0)': ownOperators,
  'glsl.vec3(position.y + 1, 0, 0)': ownOperators,
  'glsl.vec3(-position.y, 0, 0)': ownOperators,
  'glsl.vec3(position.y > 0 ? 1 : 0, 0, 0)': ownOperators,
  'glsl.vec3(position.y ** 2, 0, 0)': ownOperators,
  '{ let x = position.x; x += 1; return glsl.vec3(x, 0, 0) }': ownOperators,
  '{ position.x = 3; return position }':
    'x: a component cannot be changed; make a new vector, as in glsl.vec3(x, y, z).',
  '{ for (let i = 0; i < position.x; i++) {} return position }': ownOperators,
  'glsl.vec3(Math.sin(position.y), 0, 0)':
    'Math.sin works on numbers, not on expressions of a warp; write x.sin().',
  'glsl.vec3(Math.max(position.y, 0), 0, 0)':
    'Math.max works on numbers, not on expressions of a warp; write glsl.max(x, y).',
  'glsl.vec3(Math.PI * position.y, 0, 0)': ownOperators,
  'glsl.vec3(sin(position.y), 0, 0)': `p5's sin works on numbers, not on expressions of a warp; write x.sin().`,
  'glsl.vec3(noise(position.x, position.y), 0, 0)': `p5's noise works on numbers, not on expressions of a warp; write position.mult(3).noise(), or glsl.vec3(x, y, z).noise().`,
  'glsl.vec3(map(position.y, -1, 1, 0, 10), 0, 0)': `p5's map works on numbers, not on expressions of a warp; write x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow).`,
  'glsl.vec3(lerp(0, 10, position.y), 0, 0)': `p5's lerp works on numbers, not on expressions of a warp; write glsl.mix(from, to, amount).`,
  'glsl.vec3(constrain(position.y, 0, 1), 0, 0)': `p5's constrain works on numbers, not on expressions of a warp; write glsl.clamp(x, low, high).`,
  'glsl.vec3(dist(0, 0, position.x, position.y), 0, 0)': `p5's dist works on numbers, not on expressions of a warp; write a.dist(b) of two vectors, such as glsl.vec2(x, y).`,
  'glsl.vec3(atan2(position.y, position.x), 0, 0)': `p5's atan2 works on numbers, not on expressions of a warp; write glsl.atan(y, x).`,
  'glsl.vec3(pow(position.y, 2), 0, 0)': `p5's pow works on numbers, not on expressions of a warp; write glsl.pow(x, 2).`,
  'createVector(position.x, 0, 0)': `p5's createVector works on numbers, not on expressions of a warp; write glsl.vec3(x, y, z).`,
  'glsl.noise(position.x, position.y, position.z)':
    'noise: it takes one point; write glsl.vec3(x, y, z).noise().',
  'glsl.vec3(position.x.noise(position.y), 0, 0)':
    'noise: it takes one point; write glsl.vec2(x, y).noise().',
  '{ position.mult(2) }':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned undefined (is its "return" missing?).',
  'position.y':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a single number.',
  'glsl.vec2(1, 2)':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a vec2.',
  '[position.x, 0, 0]':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned an array of 3.',
  'createVector(1, 0, 0)':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a vector of numbers.',
  '`${position.x}`':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the text "an expression of warpjet".',
  '`${position.x()}`':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the text "an expression of warpjet".',
  'glsl.vec3(`${position.x()}`, 0, 0)':
    'vec3: expected a number or an expression for argument 1, got the text "an expression of warpjet".',
  '(async () => position)()':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a promise (leave its "async" out).',
  null: 'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned null.',
  'glsl.vec3([1, 2, 3])':
    'vec3: expected a number or an expression for argument 1, got an array of 3; write glsl.vec3(x, y, z) for a vector.',
  'glsl.vec3("1", 0, 0)':
    'vec3: expected a number or an expression for argument 1, got the text "1".',
  'glsl.vec3(NaN, 0, 0)':
    'vec3: argument 1 is NaN, but a shader can only hold numbers between -3.4e38 and 3.4e38.',
  'glsl.vec3(undefined, 0, 0)':
    'vec3: expected a number or an expression for argument 1, got undefined.',
  'position.add(glsl.vec2(1, 2))':
    'add: a vec3 and a vec2 do not fit together; use vectors of one size, or numbers.',
  'position.add([1, 0, 0])':
    'add: expected a number or an expression for argument 1, got an array of 3; write glsl.vec3(x, y, z) for a vector.',
  'position.add(createVector(1, 0, 0))':
    'add: expected a number or an expression for argument 1, got a vector of numbers; write glsl.vec3(x, y, z) for a vector.',
  'glsl.vec3(position.x(1), 0, 0)': 'x: it takes fewer arguments; the number 1 is too many.',
  'glsl.vec3(glsl.param("amount"), 0, 0)':
    'createWarp: the warp reads "amount", which nothing declares; add the option { defs: "uniform float amount;" }.',
}

/** Statements of a sketch. */
const calls = {
  'createWarp()': 'createWarp: expected a function, got undefined.',
  'createWarp("twist")': 'createWarp: expected a function, got the text "twist".',
  [`createWarp(still, 'world')`]:
    'createWarp: expected an object of options, got the text "world".',
  [`createWarp(still, { spaces: 'world' })`]:
    'createWarp: there is no option "spaces"; did you mean space? There are uniforms, type, space, defs, normals, fadeNoise, surfaceVariation, stroke, returns, shader, hooks, scope.',
  [`createWarp(still, { space: 'wold' })`]: `createWarp: expected 'local', 'world' or 'camera' for the option "space", got the text "wold".`,
  [`createWarp(still, { type: 'phong' })`]: `createWarp: expected 'specular' or 'normal' for the option "type", got the text "phong".`,
  [`createWarp(still, { stroke: 'red' })`]:
    'createWarp: expected true or false for the option "stroke", got the text "red".',
  [`createWarp(still, { returns: 'normal' })`]: `createWarp: expected 'offset' or 'position' for the option "returns", got the text "normal".`,
  [`createWarp(still, { uniforms: { amount: 'big' } })`]:
    'createWarp: expected a number, true or false, an array of 2, 3, 4, 9 or 16 numbers, a vector or colour of p5 or three.js, an image, or a function that returns one of them, for the uniform "amount", got the text "big".',
  'createWarp(warpjet.compilWarp)':
    'warpjet.compilWarp: there is no such function; did you mean compileWarp?',
  'createWarp(warpjet.twist)':
    'warpjet.twist: no script of this page has it; add the script warpjet.deformers.min.js after p5.warpjet.min.js.',
  [`createWarp(still, { defs: 'float a = 1.0;\\nfloat twice(float x) { return 2.0 * y; }' })`]: `createWarp: the option "defs" has a mistake in its line 2, "float twice(float x) { return 2.0 * y; }": 'y' : undeclared identifier.`,
  [`createWarp(still, { defs: 'uniform float size' })`]: `createWarp: the option "defs" has a mistake in its line 1, "uniform float size": 'void' : syntax error.`,
  'flat.createWarp(still)':
    'createWarp: a warp needs a 3D canvas; call createCanvas(width, height, WEBGL) first.',
  'warp(3)':
    'The function that createWarp returned: expected an object of uniforms, such as { size: 0.5 }, got the number 3.',
  'warp({ amount: 1 })': `The warp has no uniform "amount"; createWarp's option "uniforms" must declare it: { uniforms: { amount: 0.5 } }.`,
}

/** Cases that differ on WEBGPU, where defs are WGSL, which is compiled on first use: see webgpu.browser.test.js. */
const onWebGPU = {
  'glsl.vec3(glsl.param("amount"), 0, 0)':
    'createWarp: the warp reads "amount", which nothing declares; give it a value by the option { uniforms: { amount: 0.5 } }, and read it as uniforms.amount.',
  ...Object.fromEntries(
    Object.keys(calls)
      .filter((code) => /has a mistake in its line/.test(calls[code]))
      .map((code) => [code, null]),
  ),
}

const inBraces = (code) => (code.startsWith('{') ? code : `return ${code}`)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  test(`p5 ${version}, ${renderer}: each mistake has its message, with the line of the sketch`, async () => {
    const expected =
      renderer === 'WEBGL' ? { ...offsets, ...calls } : { ...offsets, ...calls, ...onWebGPU }
    // Skips cases that are null.
    const codesWithMessage = (all) => Object.keys(all).filter((code) => expected[code])
    const works = [
      ...codesWithMessage(offsets).map(
        (code) =>
          `createWarp((inputs) => { const { glsl, position, millis } = inputs; ${inBraces(code)} })`,
      ),
      ...codesWithMessage(calls),
    ]
    const { page, messages } = await runSketch(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      `let warp, flat
const still = ({ glsl }) => glsl.vec3(0, 0, 0)
const errorOf = (work) => { try { work(); return ['nothing'] } catch ({ name, message }) { return [name, message] } }
const works = [
${works.map((work) => `() => ${work},`).join('\n')}
]
${setupOf(renderer)} createCanvas(100, 100, ${renderer})
  flat = createGraphics(10, 10)
  warp = createWarp(still)
  window.said = works.map(errorOf)
  // The guarded functions are restored.
  window.after = [sin(0), Math.max(1, 2), constrain(5, 0, 1)]
  noLoop()
  done = true
}`,
    )
    const said = await page.evaluate('said')
    const left = await page.evaluate('window.after')
    const source = await page.evaluate('document.documentElement.outerHTML')
    await leavePage(page)
    // p5's own friendly errors also report some of these calls.
    assert.deepEqual(
      messages.filter((text) => !/p5\.js says/.test(text)),
      [],
    )
    assert.deepEqual(left, [0, 2, 1])
    const lines = source.split('\n')
    const first = lines.findIndex((line) => line.startsWith('const works')) + 1
    const sentences = [...codesWithMessage(offsets), ...codesWithMessage(calls)].map(
      (code) => expected[code],
    )
    const number = /, line (\d+)\)$/
    const shift = number.exec(said[0][1])[1] - first
    said.forEach(([name, message], i) => {
      assert.equal(name, 'WarpError', works[i])
      assert.equal(message.replace(/ \(\S+, line \d+\)$/, ''), sentences[i], works[i])
      assert.match(message, number, works[i])
      assert.equal(number.exec(message)[1] - first, shift + i, `${works[i]}: ${message}`)
    })
  })

/** Statements whose errors nothing catches, with the message of p5's friendly errors. */
const uncaught = {
  'createWarp(({ position }) => position.sine())':
    'sine: an expression has no such method; did you mean sin?',
  'createWarp(twist())':
    'twist is not defined: add the script warpjet.deformers.min.js after p5.warpjet.min.js, and write warpjet.twist.',
  'createWarp(glslOffset(""))':
    'glslOffset is not defined: add the script warpjet.glsl.min.js after p5.warpjet.min.js, and write warpjet.glslOffset.',
  'exactNormals(baseMaterialShader())':
    'exactNormals is not defined: add the script warpjet.glsl.min.js after p5.warpjet.min.js.',
  'compileWarp(still)':
    'compileWarp is not defined: write warpjet.compileWarp, or before it const { compileWarp } = warpjet.',
  'createWarp(({ glsl }) => position.mult(2))':
    'position is not defined: it is an argument of the offset function, as in ({ position }) => ….',
}

for (const [version, renderer, scripts] of p5HostsInThisRun)
  test(`p5 ${version}, ${renderer}: p5's friendly errors show uncaught errors`, async () => {
    const all = {
      ...uncaught,
      // p5 2 has a function of this name for p5.strands.
      'createWarp(({ position }) => vec3(position.x, 0, 0))':
        version === '1.11'
          ? 'vec3 is not defined: write glsl.vec3.'
          : "p5's vec3 works on numbers, not on expressions of a warp; write glsl.vec3(x, y, z).",
    }
    const works = Object.keys(all)
    const { page } = await runSketch(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      `let said = []
const still = ({ glsl }) => glsl.vec3(0, 0, 0)
p5._friendlyError = (message) => said.push(message)
const works = [
${works.map((work) => `() => ${work},`).join('\n')}
]
${setupOf(renderer)} createCanvas(20, 20, ${renderer})
  noLoop()
  for (const work of works) setTimeout(work)
  setTimeout(async () => { await null; createWarp() })
  setTimeout(() => setTimeout(() => (window.over = true)))
}`,
    )
    await page.waitForFunction('window.over')
    const said = await page.evaluate('said.filter((text) => /\\(\\S+, line \\d+\\)$/.test(text))')
    await leavePage(page)
    const sentences = said.map((text) => text.replace(/ \(\S+, line \d+\)$/, ''))
    for (const sentence of [
      ...Object.values(all),
      'createWarp: expected a function, got undefined.',
    ])
      assert.ok(sentences.includes(sentence), `${sentence}\n${sentences.join('\n')}`)
  })

test('a printed expression describes itself', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5InThisRun[0][1], '/dist/p5.warpjet.min.js'],
    `function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  createWarp(({ position }) => {
    console.log(position.mult(2))
    console.log(\`x is \${position.x()}\`)
    console.log(String(position.x), [position.x()].join())
    // Chrome prints the source of functions.
    console.log(position.x)
    print(position.xy)
    return position
  })
  done = true
}`,
  )
  await leavePage(page)
  const said = 'an expression of warpjet'
  assert.deepEqual(messages.slice(0, 3), ['Expression', `x is ${said}`, `${said} ${said}`])
  const components = messages.slice(3)
  assert.equal(components.length, 2)
  for (const text of components) assert.match(text, /^["'`]an expression of warpjet["'`]\(.{1,60}$/)
})

test('an unused condition causes a warning with its line', async () => {
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5InThisRun[0][1], '/dist/p5.warpjet.min.js'],
    `function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  createWarp(({ glsl, position }) => {
    if (position.y.gt(0)) return glsl.vec3(1, 0, 0)
    return glsl.vec3(0, 0, 0)
  })
  createWarp(({ glsl, position }) => glsl.vec3(position.x.lt(0) ? 1 : 2, !position.y.lt(0) ? 3 : 4, 0))
  done = true
}`,
  )
  await leavePage(page)
  const note = `A condition is not used (line): JavaScript's if, ?:, && and ! treat every condition of a warp as true; write condition.ifElse(yes, no), a.and(b), condition.not().`
  assert.deepEqual(messages.map(withoutLine), [note, note])
  const numbers = messages.map((text) => +/line (\d+)\)/.exec(text)[1])
  assert.equal(numbers[1] - numbers[0], 3)
})

const withoutLine = (text) => text.replace(/ \(\S+, line \d+\)/, ' (line)')

test('operators that mean something else on expressions than in JavaScript cause a warning', async () => {
  const scripts = [p5InThisRun[0][1], '/dist/p5.warpjet.min.js', '/dist/warpjet.operators.min.js']
  const { page, messages } = await runSketch(
    browser,
    server,
    scripts,
    `let list = []
let wave
const methods = (offset) => createWarp((inputs) => offset(inputs), { scope: { offset } })
function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  methods(({ glsl }) => glsl.vec3(0, millis(), 0))
  methods(({ glsl, millis, position }) => glsl.vec3(position.x.gt(0).ifElse(millis(), position().y), 0, 0))
  createWarp(({ position }) => {
    let x = 0
    if (position.y > 0) { x = 1; list.push(x) }
    return [x, 0, 0]
  })
  try { createWarp(({ position }) => { if (position.y > 0) return position }) } catch ({ message }) { window.said = message }
  done = true
}`,
  )
  const said = await page.evaluate('window.said')
  await leavePage(page)
  assert.deepEqual(messages.map(withoutLine), [
    "createWarp: p5's millis() is constant in a warp; use the millis that the offset function gets, as in ({ glsl, millis }) => ….",
    'list.push(x) is in an if that the GPU decides for each vertex, so it is always called once, while the warp is made; set a variable there, or let JavaScript decide the if by numbers.',
  ])
  assert.equal(
    withoutLine(said),
    'An if that is decided for each vertex returns a value in only one of its branches; let the other branch return a value too, such as return [0, 0, 0] at the end. (line)',
  )
})
